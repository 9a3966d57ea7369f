#pragma once

#include <string>

#include "cirque/solver/solver_strategy.h"

namespace cirque {

struct CeresLineSearchOptions : SolverLimits {
  CeresLineSearchOptions() { max_iterations = 10000; }

  std::string direction = "lbfgs";    ///< or nonlinear_conjugate_gradient, bfgs, steepest_descent
  std::string line_search = "wolfe";  ///< or armijo, which lbfgs and bfgs do not take
  std::string scaling = "diagonal";   ///< parameters by the start's Hessian; or none
  int max_lbfgs_rank = 50;            ///< pairs of steps and gradients that lbfgs remembers
};

const OptionTable<CeresLineSearchOptions>& CeresLineSearchOptionTable();

/// As FactoryOf, and refuses a line search that the direction does not take.
StatusOr<std::shared_ptr<const SolverStrategy>> MakeCeresLineSearch(const OptionMap& options);

/// Ceres Solver's line search methods on value and gradient: no factorization, and a Hessian only
/// once, to scale the parameters by its diagonal; but many iterations on a large mesh, whose
/// Hessian is a Laplacian. They compare values, of which the last digits are lost near the minimum;
/// where no step lowers the value any more, the method starts again on value differences integrated
/// from gradients, as often as that halves the gradient. What remains is reported as kStalled.
/// kUnsupported for bfgs, which keeps a dense matrix, above 2000 parameters.
class CeresLineSearchStrategy final : public SolverStrategy {
 public:
  explicit CeresLineSearchStrategy(const CeresLineSearchOptions& options) : options_(options) {}
  SolveSummary Minimize(const Energy& energy, const SolveControl& control,
                        Eigen::VectorXd* x) const override;

 private:
  CeresLineSearchOptions options_;
};

}  // namespace cirque
