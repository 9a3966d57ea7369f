#include "cirque/energy/circle_pattern_residual.h"

#include <cmath>

#include "cirque/math/edge_energy.h"

namespace cirque {

bool CirclePatternResidual::Evaluate(double const* const* rho, double* residual,
                                     double** jacobians) const {
  const ResidualJet r = EdgeResidual(rho[0][0] - rho[1][0], alpha_i_, alpha_j_);
  if (!std::isfinite(r.value)) return false;
  *residual = r.value;
  if (jacobians && jacobians[0]) jacobians[0][0] = r.slope;
  if (jacobians && jacobians[1]) jacobians[1][0] = -r.slope;
  return true;
}

}  // namespace cirque
