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

struct CeresTrustRegionOptions : SolverLimits {
  std::string trust_region = "levenberg_marquardt";  ///< or dogleg
  std::string residuals = "exact";  ///< the energy's own; or gradient: grad E = 0 by least squares
  double initial_radius = 1e8;      ///< large: the first step is Gauss and Newton's
  int num_threads = 1;              ///< for residuals and Jacobians
};

const OptionTable<CeresTrustRegionOptions>& CeresTrustRegionOptionTable();

/// Whether the energy has residual blocks of its own that a trust region can work on.
bool OffersResiduals(const Energy& energy);

/// Ceres Solver's nonlinear least squares on the energy's residual blocks: Levenberg and Marquardt,
/// or dogleg, each step by sparse Cholesky on the normal equations. With exact residuals J'J has
/// the pattern and conditioning of the Hessian (docs/mathematics.md, Radii); kUnsupported for an
/// energy without any.
///
/// Ceres accepts steps by the value, which near the minimum has half the digits of the gradient; so
/// steps may raise the value (its non-monotonic mode), and a solve that Ceres ends on equal values
/// goes on while that halves the gradient. What remains is reported as kStalled.
///
/// Counts: a value evaluation is one of all residuals, a Hessian evaluation one of all Jacobians
/// (with gradient residuals: gradients and Hessians); a linear solve is a factorization, and Ceres
/// times both together.
class CeresTrustRegionStrategy final : public SolverStrategy {
 public:
  explicit CeresTrustRegionStrategy(const CeresTrustRegionOptions& options) : options_(options) {}
  SolveSummary Minimize(const Energy& energy, const SolveControl& control,
                        Eigen::VectorXd* x) const override;

 private:
  CeresTrustRegionOptions options_;
};

}  // namespace cirque
