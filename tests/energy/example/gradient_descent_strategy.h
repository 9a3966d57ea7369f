#pragma once

#include "cirque/solver/solver_strategy.h"

namespace cirque {

struct GradientDescentOptions : SolverLimits {
  GradientDescentOptions() { max_iterations = 100000; }

  double step = 0.1;
};

const OptionTable<GradientDescentOptions>& GradientDescentOptionTable();

/// The example of framework/docs/adding-an-energy.md: x -= step * gradient.
class GradientDescentStrategy final : public SolverStrategy {
 public:
  explicit GradientDescentStrategy(const GradientDescentOptions& options) : options_(options) {}

  SolveSummary Minimize(const Energy& energy, const SolveControl& control,
                        Eigen::VectorXd* x) const override;

 private:
  GradientDescentOptions options_;
};

}  // namespace cirque
