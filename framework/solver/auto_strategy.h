#pragma once

#include "cirque/solver/solver_strategy.h"

namespace cirque {

const OptionTable<SolverLimits>& AutoOptionTable();

/// Chooses a Newton strategy by what is at hand, and says in the summary which and why:
/// - newton_cg where the caller brings a factor of a matrix near the Hessian, which spares
///   factorizations;
/// - newton otherwise: on an energy whose Hessian changes abruptly (an angle fit's active edges),
///   factoring each of a few systems takes less time than iterating on a factor that does not fit.
class AutoStrategy final : public SolverStrategy {
 public:
  explicit AutoStrategy(const SolverLimits& limits) : limits_(limits) {}
  SolveSummary Minimize(const Energy& energy, const SolveControl& control,
                        Eigen::VectorXd* x) const override;
  std::unique_ptr<SystemSolver> MakeSystemSolver(int num_unknowns) const override;

 private:
  SolverLimits limits_;
};

}  // namespace cirque
