#pragma once

#include "cirque/core/option_table.h"
#include "cirque/cuts/cut_heuristic.h"

namespace cirque {

struct VisibilityOptions {
  int directions = 64;
};

const OptionTable<VisibilityOptions>& VisibilityOptionTable();

/// l (s + 1 / (2 n)), s the share of n directions from which an edge of length l is seen
/// (Visibility): the cut runs where few look. Half a direction on top, since what none of them sees
/// may be seen from between them, and nothing is for free.
/// (After A. Sheffer, J. Hart, "Seamster: inconspicuous low-distortion texture seam layout", 2002.)
class VisibilityCuts final : public CutHeuristic {
 public:
  explicit VisibilityCuts(const VisibilityOptions& options) : options_(options) {}

  StatusOr<Eigen::VectorXd> EdgeCosts(const CutProblem& problem) const override;

 private:
  VisibilityOptions options_;
};

}  // namespace cirque
