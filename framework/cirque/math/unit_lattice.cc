#include "cirque/math/unit_lattice.h"

#include <cmath>
#include <limits>

namespace cirque {

int OrderOf(LatticeKind kind) { return kind == LatticeKind::kSquares ? 4 : 6; }

std::optional<LatticeKind> LatticeOfOrder(int order) {
  if (order == 4) return LatticeKind::kSquares;
  if (order == 6) return LatticeKind::kTriangles;
  return std::nullopt;
}

Lattice PeriodsOf(LatticeKind kind) {
  if (kind == LatticeKind::kSquares) return {1, {0, 1}};
  return {1, {0.5, std::sqrt(3.) / 2}};
}

Eigen::Vector2d NearestInLattice(LatticeKind kind, const Eigen::Vector2d& point) {
  if (kind == LatticeKind::kSquares) return {std::round(point.x()), std::round(point.y())};
  const double height = std::sqrt(3.) / 2;
  const double row = std::floor(point.y() / height);
  Eigen::Vector2d nearest(0, 0);
  double least = std::numeric_limits<double>::infinity();
  for (const double j : {row, row + 1}) {
    const double shift = j / 2;
    const Eigen::Vector2d near(std::round(point.x() - shift) + shift, j * height);
    if ((near - point).squaredNorm() >= least) continue;
    least = (near - point).squaredNorm();
    nearest = near;
  }
  return nearest;
}

}  // namespace cirque
