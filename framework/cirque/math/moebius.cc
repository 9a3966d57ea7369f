#include "cirque/math/moebius.h"

#include <algorithm>
#include <cmath>

#include <glog/logging.h>

namespace cirque {
namespace {

/// A point as the ratio p : q, the larger of order 1.
struct Ratio {
  Complex p, q;
};

double Magnitude(Complex z) { return std::max(std::abs(z.real()), std::abs(z.imag())); }

Complex Scale(Complex z, int exponent) {
  return {std::ldexp(z.real(), exponent), std::ldexp(z.imag(), exponent)};
}

/// Divides by the power of two of the largest.
template <std::size_t N>
void Normalize(std::array<Complex, N>* values) {
  double largest = 0;
  for (const Complex z : *values) largest = std::max(largest, Magnitude(z));
  int exponent = 0;
  std::frexp(largest, &exponent);
  for (Complex& z : *values) z = Scale(z, -exponent);
}

Ratio ToRatio(const ExtendedComplex& z) {
  if (z.is_infinite) return {1, 0};
  std::array<Complex, 2> pair = {z.value, 1};
  Normalize(&pair);
  return {pair[0], pair[1]};
}

ExtendedComplex ToPoint(Complex p, Complex q) {
  if (q == Complex(0)) return ExtendedComplex::Infinity();
  const Complex z = p / q;
  return std::isfinite(z.real()) && std::isfinite(z.imag()) ? ExtendedComplex(z)
                                                            : ExtendedComplex::Infinity();
}

/// z - w up to the points' own factors; of finite points their exact difference decides.
Complex Bracket(const ExtendedComplex& z, const ExtendedComplex& w) {
  if (z.is_infinite || w.is_infinite) {
    return z.is_infinite == w.is_infinite ? 0 : (z.is_infinite ? 1 : -1);
  }
  return z.value - w.value;
}

/// The map that takes the three points to 0, 1 and infinity.
std::optional<Moebius> ToStandard(const std::array<ExtendedComplex, 3>& z) {
  const Complex b01 = Bracket(z[0], z[1]), b12 = Bracket(z[1], z[2]), b02 = Bracket(z[0], z[2]);
  if (b01 == Complex(0) || b12 == Complex(0) || b02 == Complex(0)) return std::nullopt;
  // (z - z0) : (z - z2), each as a row of coefficients, an infinite point's row being (0, -1).
  const auto row = [](const ExtendedComplex& point, Complex factor) {
    return point.is_infinite ? std::array<Complex, 2>{0, -factor}
                             : std::array<Complex, 2>{factor, -factor * point.value};
  };
  const auto [a, b] = row(z[0], b12);
  const auto [c, d] = row(z[2], -b01);
  return Moebius(a, b, c, d);
}

}  // namespace

ExtendedComplex ExtendedComplex::Infinity() {
  ExtendedComplex z;
  z.is_infinite = true;
  return z;
}

Moebius::Moebius(Complex a, Complex b, Complex c, Complex d) : m_{a, b, c, d} {
  for (const Complex z : m_) {
    CHECK(std::isfinite(z.real()) && std::isfinite(z.imag())) << "coefficients must be finite";
  }
  Normalize(&m_);
  CHECK(m_[0] * m_[3] != m_[1] * m_[2]) << "a Moebius map needs a d - b c != 0";
}

std::optional<Moebius> Moebius::FromThreePoints(const std::array<ExtendedComplex, 3>& from,
                                                const std::array<ExtendedComplex, 3>& to) {
  const std::optional<Moebius> first = ToStandard(from), second = ToStandard(to);
  if (!first || !second) return std::nullopt;
  return second->Inverse().After(*first);
}

Moebius Moebius::DiskAutomorphism(Complex a) {
  CHECK_LT(std::abs(a), 1.0) << "the point that goes to 0 must lie inside the unit disk";
  return {1, -a, -std::conj(a), 1};
}

Moebius Moebius::Cayley(Complex c) {
  CHECK_GT(c.imag(), 0.0) << "the point that goes to 0 must lie above the real axis";
  return {1, -c, 1, -std::conj(c)};
}

Moebius Moebius::Rotation(double angle) { return {std::polar(1.0, angle), 0, 0, 1}; }

ExtendedComplex Moebius::operator()(const ExtendedComplex& z) const {
  const auto& [a, b, c, d] = m_;
  const Ratio r = ToRatio(z);
  return ToPoint(a * r.p + b * r.q, c * r.p + d * r.q);
}

Moebius Moebius::After(const Moebius& inner) const {
  const auto& [a, b, c, d] = m_;
  const auto& [p, q, r, s] = inner.m_;
  return {a * p + b * r, a * q + b * s, c * p + d * r, c * q + d * s};
}

Moebius Moebius::Inverse() const { return {m_[3], -m_[1], -m_[2], m_[0]}; }

std::optional<std::array<ExtendedComplex, 2>> Moebius::FixedPoints() const {
  const auto& [a, b, c, d] = m_;
  const Complex linear = d - a;  // c z^2 + (d - a) z - b = 0
  if (c == Complex(0) && linear == Complex(0) && b == Complex(0)) return std::nullopt;
  const Complex root = std::sqrt(linear * linear + 4.0 * b * c);
  const bool same_side = (std::conj(linear) * root).real() >= 0;
  const Complex larger = -0.5 * (linear + (same_side ? root : -root));
  if (larger == Complex(0)) {
    const ExtendedComplex both = c == Complex(0) ? ExtendedComplex::Infinity() : ExtendedComplex(0);
    return std::array<ExtendedComplex, 2>{both, both};
  }
  return std::array<ExtendedComplex, 2>{ToPoint(larger, c), ToPoint(-b, larger)};
}

ExtendedComplex CrossRatio(const ExtendedComplex& p, const ExtendedComplex& q,
                           const ExtendedComplex& r, const ExtendedComplex& s) {
  return ToPoint(Bracket(p, r) * Bracket(q, s), Bracket(q, r) * Bracket(p, s));
}

LorentzBoost::LorentzBoost(const Eigen::Vector3d& x) {
  const double norm = x.norm();
  CHECK_LT(norm, 1.0) << "a Lorentz boost needs a vector inside the unit ball";
  const double root = std::sqrt((1.0 - norm) * (1.0 + norm));
  y_ = x / (1.0 + root);
  one_minus_y2_ = 2.0 * root / (1.0 + root);
}

Eigen::Vector3d LorentzBoost::operator()(const Eigen::Vector3d& v) const {
  const Eigen::Vector3d difference = v - y_;
  return ((one_minus_y2_ / difference.squaredNorm()) * difference - y_).normalized();
}

}  // namespace cirque
