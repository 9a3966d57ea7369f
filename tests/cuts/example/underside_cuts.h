#pragma once

#include "cirque/core/option_table.h"
#include "cirque/cuts/cut_heuristic.h"

namespace cirque {

struct UndersideOptions {
  double weight = 4;  ///< of what lies highest
};

const OptionTable<UndersideOptions>& UndersideOptionTable();

/// The example of CONTRIBUTING.md: seams along the underside of what stands on a table.
class UndersideCuts final : public CutHeuristic {
 public:
  explicit UndersideCuts(const UndersideOptions& options) : options_(options) {}

  StatusOr<Eigen::VectorXd> EdgeCosts(const CutProblem& problem) const override;

 private:
  UndersideOptions options_;
};

}  // namespace cirque
