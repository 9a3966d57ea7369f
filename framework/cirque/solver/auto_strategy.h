#pragma once

#include "cirque/solver/solver_strategy.h"

namespace cirque {

const OptionTable<SolverLimits>& AutoOptionTable();

/// Chooses a Newton strategy by what is at hand, and says in the summary which and why:
/// - newton_amg, if Cirque was built with PETSc, for 20 million unknowns or more: it takes less
///   memory than a factor;
/// - newton for fewer than 20,000 unknowns when the caller brings no factor: exact steps are cheap;
/// - newton_cg otherwise: one factor serves most steps, also where the Hessian changes abruptly in
///   places (an angle fit's active edges).
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
