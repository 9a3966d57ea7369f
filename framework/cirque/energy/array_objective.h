#pragma once

#include <span>

#include "cirque/energy/angle_objective.h"

namespace cirque {

/// An objective of corner angles only that is known by its distances of whole arrays: conjugates of
/// all edges are found side by side, so that an evaluation takes a dozen calls of Distances whatever
/// the number of edges. Results are those of SeparableObjective to rounding.
class ArrayObjective : public AngleObjective {
 public:
  void Distances(std::span<const double> references, std::span<const double> x,
                 std::span<ScalarJet> jets) const override = 0;

  bool TakesArrays() const final { return true; }
  ScalarJet Distance(double reference, double x) const final;

  /// r = +- sqrt(2 delta), whose slope at the reference is sqrt(delta'').
  ResidualJet Residual(double reference, double x) const final;

  double ClampReference(double reference, double epsilon) const final;
  EdgeConjugate InteriorConjugate(double ref_l, double ref_r, double epsilon, double s_l,
                                  double s_r) const final;
  EdgeConjugate BoundaryConjugate(double ref, double epsilon, double s) const final;
  void Conjugates(std::span<const EdgeSlopes> edges, double epsilon,
                  std::span<EdgeConjugate> conjugates) const final;
};

}  // namespace cirque
