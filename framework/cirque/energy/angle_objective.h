#pragma once

#include <algorithm>
#include <memory>
#include <span>
#include <string>

#include "cirque/core/registry.h"
#include "cirque/core/types.h"
#include "cirque/math/scalar_jet.h"

namespace cirque {

/// What an objective says about one edge: g(s) = max over a in Q_e of [ s.a - phi(a) ], its
/// maximiser a (the gradient of g) and its (generalised) Hessian. At a boundary edge only the left
/// entries mean anything.
struct EdgeConjugate {
  double value = 0;
  double alpha_l = 0, alpha_r = 0;      ///< [rad]
  double h_ll = 0, h_lr = 0, h_rr = 0;  ///< d alpha / d s
};

/// What an edge's conjugate is asked at: raw references and slopes of its corners, left and right. Of
/// a boundary edge the left ones alone mean anything.
struct EdgeSlopes {
  double ref_l = 0, ref_r = 0, s_l = 0, s_r = 0;
  bool is_boundary = false;
};

/// The margins of an edge's set Q_e = {alpha_l >= l, alpha_r >= r, alpha_l + alpha_r <= pi - theta}
/// (boundary: [l, pi - theta]) [rad]; negative: Q_e is everything.
struct EdgeMargins {
  double l, r, theta;
};

/// A convex distance of corner angles from reference angles: a sum over corners of delta(alpha;
/// alpha0), and over edges of delta(theta; theta0) too where MeasuresTheta() says so, theta = pi -
/// alpha_l - alpha_r (boundary: pi - alpha), together with the set Q_e that an edge's angles may
/// range over. The dual energy, the primal fits and the KKT report all follow from these functions.
class AngleObjective {
 public:
  virtual ~AngleObjective() = default;

  /// delta(x; reference) with its first two derivatives in x; `reference` as ClampReference
  /// returned it.
  virtual ScalarJet Distance(double reference, double x) const = 0;

  /// r with 1/2 r^2 = delta(x; reference), smooth at x = reference.
  virtual ResidualJet Residual(double reference, double x) const = 0;

  /// Whether intersection angles are measured like corner angles.
  virtual bool MeasuresTheta() const { return false; }

  /// The reference angle that Distance can take: one not positive has none under some objectives.
  virtual double ClampReference(double reference, double /*epsilon*/) const { return reference; }

  /// The largest margin of a Q_e when `epsilon` is asked for; negative: Q_e is everything.
  /// Objectives with a barrier need none (0).
  virtual double Margin(double epsilon) const { return epsilon; }

  /// The margins of an edge with these raw (unclamped) references: Margin(epsilon), but at a corner
  /// whose reference is less than twice that only half of it, at least kLeastCornerMargin, so that a
  /// needle may stay as it is. (A small theta is dear: the errors of the radii grow with 1 / theta.)
  EdgeMargins Margins(double ref_l, double ref_r, double epsilon) const;
  EdgeMargins Margins(double ref, double epsilon) const;

  /// The conjugates over Q_e(Margins(...)) at the slopes s, for raw references.
  virtual EdgeConjugate InteriorConjugate(double ref_l, double ref_r, double epsilon, double s_l,
                                          double s_r) const = 0;
  virtual EdgeConjugate BoundaryConjugate(double ref, double epsilon, double s) const = 0;

  /// The one of both that the edge asks for.
  EdgeConjugate Conjugate(const EdgeSlopes& edge, double epsilon) const {
    return edge.is_boundary
               ? BoundaryConjugate(edge.ref_l, epsilon, edge.s_l)
               : InteriorConjugate(edge.ref_l, edge.ref_r, epsilon, edge.s_l, edge.s_r);
  }

  /// Whether it is to be asked by the two that follow, once for all corners or edges: where a call is
  /// dear, as of an objective in another language.
  virtual bool TakesArrays() const { return false; }

  /// Whether a hundred edges side by side take it less than one after another.
  virtual bool PrefersArrays() const { return false; }

  /// Distance and the conjugates of arrays of the same length.
  virtual void Distances(std::span<const double> references, std::span<const double> x,
                         std::span<ScalarJet> jets) const;
  virtual void Conjugates(std::span<const EdgeSlopes> edges, double epsilon,
                          std::span<EdgeConjugate> conjugates) const;

  /// phi of an interior edge's two angles, of a boundary edge's one, for raw references.
  double Interior(double ref_l, double ref_r, double epsilon, double alpha_l, double alpha_r) const;
  double Boundary(double ref, double epsilon, double alpha) const;
};

/// The table of objectives, one line an entry in registry.cc.
const Registry<std::shared_ptr<const AngleObjective>>& AngleObjectives();

/// Of Margins [rad].
inline constexpr double kLeastCornerMargin = 1e-8;

/// What the class says of them, inlined: an angle fit calls these for every edge.
inline EdgeMargins AngleObjective::Margins(double ref_l, double ref_r, double epsilon) const {
  constexpr double kShare = 0.5;
  const double largest = Margin(epsilon);
  if (!(largest > 0)) return {largest, largest, largest};
  const auto of_corner = [&](double reference) {
    return std::min(largest, std::max(kLeastCornerMargin, kShare * reference));
  };
  return {of_corner(ref_l), of_corner(ref_r), largest};
}

/// Likewise, of a boundary edge.
inline EdgeMargins AngleObjective::Margins(double ref, double epsilon) const {
  return Margins(ref, 0, epsilon);
}

/// Likewise: the distance at an interior edge.
inline double AngleObjective::Interior(double ref_l, double ref_r, double epsilon, double alpha_l,
                                       double alpha_r) const {
  const auto distance = [&](double ref, double x) {
    return Distance(ClampReference(ref, epsilon), x).value;
  };
  const double corners = distance(ref_l, alpha_l) + distance(ref_r, alpha_r);
  return MeasuresTheta() ? corners + distance(kPi - ref_l - ref_r, kPi - alpha_l - alpha_r)
                         : corners;
}

/// Likewise: the distance at a boundary edge.
inline double AngleObjective::Boundary(double ref, double epsilon, double alpha) const {
  const auto distance = [&](double r, double x) {
    return Distance(ClampReference(r, epsilon), x).value;
  };
  return MeasuresTheta() ? distance(ref, alpha) + distance(kPi - ref, kPi - alpha)
                         : distance(ref, alpha);
}

}  // namespace cirque
