#include "cirque/math/lattice_pattern.h"

#include <algorithm>
#include <cmath>
#include <complex>

namespace cirque {

double PatternDistance(LatticeKind kind, const Eigen::Vector2d& point) {
  if (kind == LatticeKind::kTriangles) {
    constexpr double kRadius = 0.3;
    return kRadius - (NearestInLattice(kind, point) - point).norm();
  }
  constexpr double kHalfSquare = 0.25;  // edges lie at odd multiples of it
  const auto wave = [](double x) { return std::abs(x - std::round(x)) - kHalfSquare; };
  const double x = wave(point.x()), y = wave(point.y());
  const double distance = std::min(std::abs(x), std::abs(y));
  return (x < 0) == (y < 0) ? distance : -distance;
}

Eigen::Vector2d InPeriods(LatticeKind kind, const Eigen::Vector2d& point) {
  const auto [a, b] = PeriodsOf(kind).Coordinates({point.x(), point.y()});
  return {a, b};
}

std::vector<std::uint8_t> PatternTile(LatticeKind kind, int side, double slope) {
  const Lattice periods = PeriodsOf(kind);
  std::vector<std::uint8_t> tile;
  for (int j = 0; j < side; ++j) {
    for (int i = 0; i < side; ++i) {
      const std::complex<double> at =
          ((i + 0.5) * periods.first + (j + 0.5) * periods.second) / static_cast<double>(side);
      const double share = 0.5 + slope * PatternDistance(kind, {at.real(), at.imag()});
      tile.push_back(static_cast<std::uint8_t>(std::lround(255 * std::clamp(share, 0., 1.))));
    }
  }
  return tile;
}

}  // namespace cirque
