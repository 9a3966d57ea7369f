#pragma once

#include "cirque/energy/angle_objective.h"

namespace cirque {

/// phi(alpha) = 1/2 |alpha - alpha0|^2: the thesis's quadratic program. Its conjugate is the
/// Euclidean projection of alpha0 + s onto Q_e; the generalised Hessian is that projection's
/// derivative.
class QuadraticObjective final : public AngleObjective {
 public:
  double Interior(double ref_l, double ref_r, double alpha_l, double alpha_r) const override;
  double Boundary(double ref, double alpha) const override;
  EdgeConjugate InteriorConjugate(double ref_l, double ref_r, double eps, double s_l,
                                  double s_r) const override;
  EdgeConjugate BoundaryConjugate(double ref, double eps, double s) const override;
};

}  // namespace cirque
