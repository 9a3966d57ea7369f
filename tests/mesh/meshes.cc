#include "tests/mesh/meshes.h"

#include <unistd.h>

#include <cmath>
#include <utility>

#include <gtest/gtest.h>

namespace cirque::testing {

PolygonSoup MakeSoup(std::vector<Eigen::Vector3d> position,
                     const std::vector<std::vector<Index>>& polygons) {
  PolygonSoup soup;
  soup.position = std::move(position);
  for (const std::vector<Index>& polygon : polygons) {
    soup.corner.insert(soup.corner.end(), polygon.begin(), polygon.end());
    soup.first_corner.push_back(static_cast<Index>(soup.corner.size()));
  }
  return soup;
}

PolygonSoup Tetrahedron() {
  return MakeSoup({{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}},
                  {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {1, 3, 2}});
}

PolygonSoup Torus() {
  PolygonSoup soup;
  const auto vertex = [](Index i, Index j) { return 3 * (i % 3) + j % 3; };
  std::vector<std::vector<Index>> polygons;
  std::vector<Eigen::Vector3d> position;
  for (Index i = 0; i < 3; ++i) {
    for (Index j = 0; j < 3; ++j) {
      const double a = 2 * kPi * i / 3, b = 2 * kPi * j / 3, r = 2 + std::cos(b);
      position.emplace_back(r * std::cos(a), r * std::sin(a), std::sin(b));
      polygons.push_back({vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1), vertex(i, j + 1)});
    }
  }
  return MakeSoup(std::move(position), polygons);
}

PolygonSoup Ring(Index n, bool twisted) {
  std::vector<Eigen::Vector3d> position;
  std::vector<std::vector<Index>> polygons;
  for (Index i = 0; i < n; ++i) {
    const double a = 2 * kPi * i / n, lean = twisted ? a / 2 : 0;
    const Eigen::Vector3d radial(std::cos(a), std::sin(a), 0);
    const Eigen::Vector3d across =
        std::cos(lean) * radial / 4 + Eigen::Vector3d(0, 0, std::sin(lean) / 4);
    position.push_back(radial - across);
    position.push_back(radial + across);
    const Index inner = 2 * i, outer = inner + 1;
    const bool last = i + 1 == n;
    const Index next_inner = last ? (twisted ? 1 : 0) : inner + 2;
    const Index next_outer = last ? (twisted ? 0 : 1) : inner + 3;
    polygons.push_back({inner, outer, next_outer, next_inner});
  }
  return MakeSoup(std::move(position), polygons);
}

PolygonSoup OneTriangle() { return MakeSoup({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}); }

std::string TempPath(const std::string& name) {
  return ::testing::TempDir() + std::to_string(getpid()) + "_" + name;
}

}  // namespace cirque::testing
