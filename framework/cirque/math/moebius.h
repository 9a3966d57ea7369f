#pragma once

#include <array>
#include <complex>
#include <optional>

#include <Eigen/Core>

namespace cirque {

using Complex = std::complex<double>;

/// A point of the extended complex plane.
struct ExtendedComplex {
  Complex value = 0;  ///< of a finite point
  bool is_infinite = false;

  ExtendedComplex() = default;
  ExtendedComplex(Complex z) : value(z) {}  // NOLINT(google-explicit-constructor)
  ExtendedComplex(double x) : value(x) {}   // NOLINT(google-explicit-constructor)
  static ExtendedComplex Infinity();

  bool operator==(const ExtendedComplex& other) const {
    return is_infinite ? other.is_infinite : !other.is_infinite && value == other.value;
  }
};

/// The Moebius map z -> (a z + b) / (c z + d), a d - b c != 0, of the extended complex plane.
/// Infinity is a point like any other: points are homogeneous pairs inside, so nothing overflows on
/// the way.
class Moebius {
 public:
  /// The identity.
  Moebius() = default;

  /// Coefficients are scaled by a common power of two to order 1. Anything singular or not finite
  /// is a broken caller.
  Moebius(Complex a, Complex b, Complex c, Complex d);

  /// The map that takes from[i] to to[i]; nothing where two of `from`, or two of `to`, coincide.
  static std::optional<Moebius> FromThreePoints(const std::array<ExtendedComplex, 3>& from,
                                                const std::array<ExtendedComplex, 3>& to);

  /// z -> (z - a) / (1 - conj(a) z): the unit disk onto itself, a to 0, direction kept there.
  /// @pre |a| < 1.
  static Moebius DiskAutomorphism(Complex a);

  /// z -> (z - c) / (z - conj(c)): the upper half-plane onto the unit disk, c to 0, infinity to 1.
  /// @pre Im c > 0.
  static Moebius Cayley(Complex c);

  /// z -> e^{i angle} z.
  static Moebius Rotation(double angle);

  ExtendedComplex operator()(const ExtendedComplex& z) const;

  /// (*this)(inner(z)).
  Moebius After(const Moebius& inner) const;
  Moebius Inverse() const;

  /// The two fixed points, equal for a parabolic map; nothing for the identity, which fixes all.
  std::optional<std::array<ExtendedComplex, 2>> FixedPoints() const;

  /// {a, b, c, d}.
  const std::array<Complex, 4>& coefficients() const { return m_; }

 private:
  std::array<Complex, 4> m_ = {1, 0, 0, 1};
};

/// (p - r)(q - s) / ((q - r)(p - s)), which Moebius maps keep; infinite where q = r or p = s. Of
/// the four points no three may coincide.
ExtendedComplex CrossRatio(const ExtendedComplex& p, const ExtendedComplex& q,
                           const ExtendedComplex& r, const ExtendedComplex& s);

/// The Lorentz boost by a vector x of the open unit ball, acting on the unit sphere: a Moebius
/// transformation that fixes x/|x| and -x/|x| and moves everything from the former to the latter.
/// It carries the point x of Klein's ball to the centre; its inverse is the boost by -x.
///
/// With x4 = 1/sqrt(1 - x.x) and s = x4 x the light ray (v, 1) goes to
/// v' = v + ((v.s)/(x4+1) - 1) s, v4' = x4 - v.s, and the point is v'/v4'. That quotient cancels
/// for v near x/|x|; computed is the same map in Poincare's ball, which does not:
///   v -> (1 - y.y) (v - y)/|v - y|^2 - y,  y = x / (1 + sqrt(1 - x.x)).
/// The image is a unit vector to rounding.
///
/// Source: Springborn, A unique representation of polyhedral types, Math. Z. 249 (2005).
class LorentzBoost {
 public:
  /// |x| < 1; anything else is a broken caller.
  explicit LorentzBoost(const Eigen::Vector3d& x);

  /// The image of the unit vector v.
  Eigen::Vector3d operator()(const Eigen::Vector3d& v) const;

  /// y, the point of Poincare's ball that it carries to the centre: x at half its hyperbolic
  /// distance. On the equator, as complex numbers, the boost by a vector of the equator's plane is
  /// v -> (v - y) / (1 - conj(y) v).
  const Eigen::Vector3d& centre() const { return y_; }

 private:
  Eigen::Vector3d y_;
  double one_minus_y2_ = 1.0;  ///< 1 - y.y without cancellation
};

}  // namespace cirque
