#pragma once

#include <span>

#include "cirque/energy/angle_objective.h"

namespace cirque {

/// delta(x; x0) = x log(x / x0) - x + x0: the Kullback-Leibler divergence of the angles from their
/// references, which are clamped to what is the least margin of a corner.
///
/// Conjugate, in closed form: with f = x0 e^s, alpha = f or its margin on both sides of the edge, of
/// value alpha - x0 and curvature 1 / alpha where free. Where the two exceed S, pi less the margin
/// of theta, they share it as the f do: alpha_l = S f_l / (f_l + f_r), of value
/// S log((f_l + f_r) / S) + S - x0_l - x0_r for both, until one of them is at its margin.
class EntropyObjective final : public AngleObjective {
 public:
  ScalarJet Distance(double reference, double x) const override;
  ResidualJet Residual(double reference, double x) const override;
  double ClampReference(double reference, double epsilon) const override;
  EdgeConjugate InteriorConjugate(double ref_l, double ref_r, double epsilon, double s_l,
                                  double s_r) const override;
  EdgeConjugate BoundaryConjugate(double ref, double epsilon, double s) const override;
  bool PrefersArrays() const override { return true; }
  void Conjugates(std::span<const EdgeSlopes> edges, double epsilon,
                  std::span<EdgeConjugate> conjugates) const override;

 private:
  /// The conjugate of an edge, given e^s_l and e^s_r.
  EdgeConjugate ConjugateOf(const EdgeSlopes& edge, double epsilon, double exp_l,
                            double exp_r) const;
};

}  // namespace cirque
