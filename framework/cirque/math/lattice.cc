#include "cirque/math/lattice.h"

#include <cmath>

namespace cirque {
namespace {

constexpr int kMostSteps = 2000;
constexpr double kShorter = 1 - 1e-14;  ///< so that rounding does not go round in circles

}  // namespace

std::pair<double, double> Lattice::Coordinates(std::complex<double> z) const {
  const std::complex<double> in_first = z / first, tau = Tau();
  const double b = in_first.imag() / tau.imag();
  return {in_first.real() - b * tau.real(), b};
}

Lattice ReduceLattice(std::complex<double> a, std::complex<double> b) {
  for (int step = 0; step < kMostSteps; ++step) {
    if (std::abs(b) < std::abs(a)) std::swap(a, b);
    const double multiple = std::round((b / a).real());
    const std::complex<double> shorter = b - multiple * a;
    if (multiple == 0 || !(std::abs(shorter) < kShorter * std::abs(b))) break;
    b = shorter;
  }
  if ((b / a).imag() < 0) b = -b;
  return {a, b};
}

double RoundToGrid(double x, int exponent) {
  return std::ldexp(std::nearbyint(std::ldexp(x, -exponent)), exponent);
}

}  // namespace cirque
