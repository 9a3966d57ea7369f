#pragma once

#include <array>

#include <ceres/types.h>

#include "cirque/solver/solver_strategy.h"

namespace cirque {

template <>
inline constexpr auto kEnumWords<ceres::LineSearchDirectionType> =
    std::to_array<EnumWord<ceres::LineSearchDirectionType>>(
        {{ceres::LBFGS, "lbfgs"},
         {ceres::NONLINEAR_CONJUGATE_GRADIENT, "nonlinear_conjugate_gradient"},
         {ceres::BFGS, "bfgs"},
         {ceres::STEEPEST_DESCENT, "steepest_descent"}});

template <>
inline constexpr auto kEnumWords<ceres::LineSearchType> =
    std::to_array<EnumWord<ceres::LineSearchType>>({{ceres::WOLFE, "wolfe"},
                                                    {ceres::ARMIJO, "armijo"}});

/// What the parameters are divided by: the root of the start's Hessian's diagonal, or 1.
enum class ParameterScaling { kDiagonal, kNone };

template <>
inline constexpr auto kEnumWords<ParameterScaling> = std::to_array<EnumWord<ParameterScaling>>(
    {{ParameterScaling::kDiagonal, "diagonal"}, {ParameterScaling::kNone, "none"}});

struct CeresLineSearchOptions : SolverLimits {
  CeresLineSearchOptions() { max_iterations = 10000; }

  ceres::LineSearchDirectionType direction = ceres::LBFGS;
  ceres::LineSearchType line_search = ceres::WOLFE;  ///< lbfgs and bfgs do not take armijo
  ParameterScaling scaling = ParameterScaling::kDiagonal;
  int max_lbfgs_rank = 50;  ///< pairs of steps and gradients that lbfgs remembers
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

template <>
inline constexpr auto kEnumWords<ceres::TrustRegionStrategyType> =
    std::to_array<EnumWord<ceres::TrustRegionStrategyType>>(
        {{ceres::LEVENBERG_MARQUARDT, "levenberg_marquardt"}, {ceres::DOGLEG, "dogleg"}});

/// What the trust region works on: the energy's own residual blocks, or its gradient as residuals
/// (grad E = 0 by least squares).
enum class TrustRegionResiduals { kExact, kGradient };

template <>
inline constexpr auto kEnumWords<TrustRegionResiduals> =
    std::to_array<EnumWord<TrustRegionResiduals>>({{TrustRegionResiduals::kExact, "exact"},
                                                   {TrustRegionResiduals::kGradient, "gradient"}});

struct CeresTrustRegionOptions : SolverLimits {
  ceres::TrustRegionStrategyType trust_region = ceres::LEVENBERG_MARQUARDT;
  TrustRegionResiduals residuals = TrustRegionResiduals::kExact;
  double initial_radius = 1e8;  ///< large: the first step is Gauss and Newton's
  int num_threads = 1;          ///< for residuals and Jacobians
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
