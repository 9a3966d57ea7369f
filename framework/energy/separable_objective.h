#pragma once

#include "cirque/energy/angle_objective.h"

namespace cirque {

/// An objective of corner angles only. From its scalar distance and where that has a given slope,
/// the conjugates over Q_e follow: clamp each angle to eps; where the two then exceed pi - eps,
/// move along that side of Q_e to the maximum (a scalar monotone equation) and clamp to its ends.
class SeparableObjective : public AngleObjective {
 public:
  /// The x with d delta(x; reference) / dx = slope.
  virtual double WithSlope(double reference, double slope) const = 0;

  EdgeConjugate InteriorConjugate(double ref_l, double ref_r, double epsilon, double s_l,
                                  double s_r) const final;
  EdgeConjugate BoundaryConjugate(double ref, double epsilon, double s) const final;

 private:
  EdgeConjugate MaximiseOnSum(double ref_l, double ref_r, double eps, double s_l, double s_r) const;
};

}  // namespace cirque
