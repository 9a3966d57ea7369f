#include <algorithm>
#include <cmath>

#include "cirque/generators/generators.h"
#include "cirque/generators/surface_chart.h"

namespace cirque {
namespace {

/// A chart of the square [-1, 1]^2, without lift, flatten and spacing.
SurfaceChart SquareChart() {
  SurfaceChart chart;
  chart.position = [](double a, double b) { return Eigen::Vector2d(2 * a - 1, 2 * b - 1); };
  chart.boundary = {
      [](double t) { return Eigen::Vector2d(2 * t - 1, -1); },
      [](double t) { return Eigen::Vector2d(1, 2 * t - 1); },
      [](double t) { return Eigen::Vector2d(1 - 2 * t, 1); },
      [](double t) { return Eigen::Vector2d(-1, 1 - 2 * t); },
  };
  chart.triangulate = TriangulateHull;
  return chart;
}

/// Whether a point of the square keeps its distance from the sides.
bool InsideSquare(const Eigen::Vector2d& point, double edge_length) {
  return point.cwiseAbs().maxCoeff() < 1 - kClearance * std::min(edge_length, 1.);
}

}  // namespace

PolygonSoup FlatDelaunayPatch(const GeneratorOptions& options) {
  SurfaceChart chart = SquareChart();
  chart.lift = [](const Eigen::Vector2d& p) { return Eigen::Vector3d(p.x(), p.y(), 0); };
  chart.flatten = [](const Eigen::Vector3d& p) { return Eigen::Vector2d(p.head<2>()); };
  chart.spacing = [](const Eigen::Vector3d& p) {
    return 0.5 + (p.head<2>() - Eigen::Vector2d(0.4, 0.3)).norm() / 2;
  };
  chart.allowed = InsideSquare;
  return MeshChart(chart, options);
}

PolygonSoup BumpyTerrain(const GeneratorOptions& options) {
  constexpr int kBumps = 25;
  struct Bump {
    Eigen::Vector2d centre;
    double width, height;
  };
  UniformRandom random(options.seed);
  std::vector<Bump> bumps;
  for (int i = 0; i < kBumps; ++i) {
    const double x = random(-1, 1), y = random(-1, 1);
    const double width = random(0.1, 0.35), steepness = random(-0.9, 0.9);
    bumps.push_back({{x, y}, width, steepness * width});
  }
  SurfaceChart chart = SquareChart();
  chart.lift = [&bumps](const Eigen::Vector2d& p) {
    double z = 0;
    for (const Bump& bump : bumps) {
      z += bump.height * std::exp(-(p - bump.centre).squaredNorm() / (2 * bump.width * bump.width));
    }
    return Eigen::Vector3d(p.x(), p.y(), z);
  };
  chart.flatten = [](const Eigen::Vector3d& p) { return Eigen::Vector2d(p.head<2>()); };
  chart.allowed = InsideSquare;
  return MeshChart(chart, options);
}

PolygonSoup HexagonalFan(const GeneratorOptions& options) {
  const auto rings = std::max(1, static_cast<int>(std::lround(std::sqrt(options.triangles / 6.))));
  // Lattice point (i, j) is i (1, 0) + j (1/2, sqrt(3)/2); the hexagon is max(|i|, |j|, |i + j|) <=
  // rings, and row j begins at i = max(-rings, -rings - j).
  std::vector<Eigen::Vector3d> position;
  std::vector<Index> row_start;
  for (int j = -rings; j <= rings; ++j) {
    row_start.push_back(static_cast<Index>(position.size()) - std::max(-rings, -rings - j));
    for (int i = std::max(-rings, -rings - j); i <= std::min(rings, rings - j); ++i) {
      position.emplace_back(i + j / 2., j * std::sqrt(3.) / 2, 0);
    }
  }
  const auto inside = [&](int i, int j) {
    return std::max({std::abs(i), std::abs(j), std::abs(i + j)}) <= rings;
  };
  const auto at = [&](int i, int j) { return row_start[j + rings] + i; };
  std::vector<Triangle> triangles;
  for (int j = -rings; j < rings; ++j) {
    for (int i = -rings; i <= rings; ++i) {
      if (!inside(i, j + 1)) continue;
      if (inside(i, j) && inside(i + 1, j)) {
        triangles.push_back({at(i, j), at(i + 1, j), at(i, j + 1)});
      }
      if (inside(i + 1, j) && inside(i + 1, j + 1)) {
        triangles.push_back({at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)});
      }
    }
  }
  return SoupOfTriangles(position, triangles);
}

}  // namespace cirque
