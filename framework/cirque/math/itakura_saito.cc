#include "cirque/math/itakura_saito.h"

#include <cmath>

namespace cirque {
namespace {

/// Where |t - 1| is smaller the logarithm is taken by its series.
constexpr double kNearOne = 0.3;

/// sum_{k >= 0} s^{2k} / (2k + 3) = (atanh(s) - s) / s^3 for |s| <= 0.3 / 1.7.
double AtanhRemainder(double s) {
  const double s2 = s * s;
  double sum = 0.0;
  for (int k = 10; k >= 0; --k) sum = sum * s2 + 1.0 / (2 * k + 3);
  return sum;
}

// With x = t - 1 and s = x / (2 + x): log t = 2 atanh s = 2 s + 2 s^3 R(s^2) and x - 2 s = x s, so
// both divergences are x s plus a small term, and their quotients by x^2 are smooth.

/// IS(t) / x^2.
double ItakuraSaitoRatio(double t) {
  const double x = t - 1.0;
  if (std::abs(x) >= kNearOne) return (x - std::log(t)) / (x * x);
  const double inverse = 1.0 / (2.0 + x), s = x * inverse;
  return inverse * (1.0 - 2.0 * s * inverse * AtanhRemainder(s));
}

/// KL(t) / x^2.
double KullbackLeiblerRatio(double t) {
  const double x = t - 1.0;
  if (t == 0.0) return 1.0;
  if (std::abs(x) >= kNearOne) return (t * std::log(t) - x) / (x * x);
  const double inverse = 1.0 / (2.0 + x), s = x * inverse;
  return inverse * (1.0 + 2.0 * t * s * inverse * AtanhRemainder(s));
}

}  // namespace

ScalarJet ItakuraSaito(double t) {
  const double x = t - 1.0;
  return {x * x * ItakuraSaitoRatio(t), x / t, 1.0 / (t * t)};
}

ResidualJet ItakuraSaitoResidual(double t) {
  // dr/dt = D' / r = (x / t) / (x root): the factor x cancels.
  const double root = std::sqrt(2.0 * ItakuraSaitoRatio(t));
  return {(t - 1.0) * root, 1.0 / (t * root)};
}

ScalarJet KullbackLeibler(double t) {
  const double x = t - 1.0;
  return {x * x * KullbackLeiblerRatio(t), std::log(t), 1.0 / t};
}

ResidualJet KullbackLeiblerResidual(double t) {
  const double x = t - 1.0, root = std::sqrt(2.0 * KullbackLeiblerRatio(t));
  return {x * root, (x == 0.0 ? 1.0 : std::log(t) / x) / root};
}

}  // namespace cirque
