#pragma once

#include "cirque/solver/solver_strategy.h"

namespace cirque {

const OptionTable<SolverLimits>& AutoOptionTable();

/// Chooses a Newton strategy by what is at hand, and says in the summary which and why:
/// - newton_amg, if Cirque was built with PETSc, for 10 million unknowns or more whose start was
///   solved by it too (the log radii): it takes less memory than a factor;
/// - newton_cg where the caller brings a factor of such a matrix, which spares factorizations;
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
