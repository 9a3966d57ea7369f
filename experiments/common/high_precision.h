#pragma once

#include <array>
#include <cmath>

#include <boost/math/constants/constants.hpp>
#include <boost/math/special_functions/bernoulli.hpp>
#include <boost/multiprecision/cpp_bin_float.hpp>

/// The circle-pattern functions in 50 digits, by other formulas than the framework's: references
/// for tests and audits. Arguments are exact: pass doubles, or Real for more digits.
namespace cirque::high_precision {

using Real = boost::multiprecision::number<boost::multiprecision::cpp_bin_float<50>,
                                           boost::multiprecision::et_off>;

inline Real Pi() { return boost::math::constants::pi<Real>(); }

/// B_2k / (2k (2k+1)!), k = 1 to 110.
inline const std::array<Real, 110>& BernoulliCoefficients() {
  static const std::array<Real, 110> kCoefficients = [] {
    std::array<Real, 110> c;
    Real factorial = 1;
    for (int k = 1; k <= 110; ++k) {
      factorial *= Real(2 * k) * (2 * k + 1);
      c[k - 1] = boost::math::bernoulli_b2n<Real>(k) / (2 * k * factorial);
    }
    return c;
  }();
  return kCoefficients;
}

/// Im Li2(e^{mu}), mu = log_radius + i angle, log_radius <= 0, 0 <= angle <= pi, |mu| < 4, by
/// Li2(e^mu) = pi^2/6 + mu (1 - log(-mu)) - mu^2/4 - sum_k B_2k mu^{2k+1} / (2k (2k+1)!).
inline Real ImDilogByBernoulli(const Real& log_radius, const Real& angle) {
  const Real square_re = log_radius * log_radius - angle * angle;
  const Real square_im = 2 * log_radius * angle;
  const Real log_re = log(log_radius * log_radius + angle * angle) / 2;
  const Real log_im = atan2(-angle, -log_radius);
  Real sum = angle * (1 - log_re) - log_radius * log_im - square_im / 4;
  Real power_re = log_radius, power_im = angle;
  for (const Real& coefficient : BernoulliCoefficients()) {
    const Real re = power_re * square_re - power_im * square_im;
    power_im = power_re * square_im + power_im * square_re;
    power_re = re;
    sum -= coefficient * power_im;
    if (abs(coefficient) * (abs(power_re) + abs(power_im)) < Real("1e-70")) break;
  }
  return sum;
}

/// Im Li2(e^{log_radius + i angle}) by its power series: log_radius <= -2.
inline Real ImDilogByPowers(const Real& log_radius, const Real& angle) {
  const Real radius = exp(log_radius);
  Real sum = 0, power = 1;
  for (int n = 1; n <= 60; ++n) {
    power *= radius;
    sum += power * sin(n * angle) / (n * n);
  }
  return sum;
}

/// Im Li2(e^{d + i theta}), theta in [0, pi]; outside the unit circle by inversion.
inline Real ImDilog(const Real& d, const Real& theta) {
  if (theta == 0) return 0;
  if (d > 0) return d * (Pi() - theta) + ImDilog(-d, theta);
  return d < -2 ? ImDilogByPowers(d, theta) : ImDilogByBernoulli(d, theta);
}

/// Cl2(x) for every x.
inline Real Clausen(const Real& x) {
  const Real turns = x / (2 * Pi());
  const Real reduced = x - 2 * Pi() * floor(turns + Real(0.5));
  return reduced < 0 ? -ImDilog(0, -reduced) : ImDilog(0, reduced);
}

/// phi = atan2(sin theta, e^d - cos theta).
inline Real HalfAngle(const Real& d, const Real& theta) {
  return atan2(sin(theta), exp(d) - cos(theta));
}

/// sin theta / (cosh d - cos theta).
inline Real HalfAngleWeight(const Real& d, const Real& theta) {
  return sin(theta) / (cosh(d) - cos(theta));
}

/// Im Li2(e^{d + i theta}) + Im Li2(e^{-d + i theta}), the outer one by inversion.
inline Real EdgePotential(const Real& d, const Real& theta) {
  return abs(d) * (Pi() - theta) + 2 * ImDilog(-abs(d), theta);
}

/// log(sin alpha_j / sin alpha_i).
inline Real MinimalLogRatio(const Real& alpha_i, const Real& alpha_j) {
  return log(sin(alpha_j) / sin(alpha_i));
}

/// psi_e(d) - psi_e(d_e) with psi_e = EdgePotential + (alpha_i - alpha_j) d.
inline Real EdgeExcess(const Real& d, const Real& alpha_i, const Real& alpha_j) {
  const Real theta = Pi() - alpha_i - alpha_j;
  const Real minimum = MinimalLogRatio(alpha_i, alpha_j);
  return EdgePotential(d, theta) - EdgePotential(minimum, theta) +
         (alpha_i - alpha_j) * (d - minimum);
}

/// |x - reference| / |reference|; 0 where both vanish.
inline double RelativeError(double x, const Real& reference) {
  const Real error = abs(Real(x) - reference);
  return static_cast<double>(error == 0 ? error : Real(error / abs(reference)));
}

}  // namespace cirque::high_precision
