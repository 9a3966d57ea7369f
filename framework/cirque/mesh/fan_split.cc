#include "cirque/mesh/fan_split.h"

#include <algorithm>
#include <limits>
#include <span>

#include <Eigen/Geometry>

#include "cirque/core/parallel.h"

namespace cirque {
namespace {

using Corners = std::span<const Index>;

constexpr std::size_t kNoApex = std::numeric_limits<std::size_t>::max();

Corners CornersOf(const PolygonSoup& soup, Index p) {
  return Corners(soup.corner)
      .subspan(soup.first_corner[p], soup.first_corner[p + 1] - soup.first_corner[p]);
}

bool RepeatsVertex(Corners corners) {
  if (corners.size() == 3) {
    return corners[0] == corners[1] || corners[1] == corners[2] || corners[2] == corners[0];
  }
  std::vector<Index> sorted(corners.size());
  std::copy(corners.begin(), corners.end(), sorted.begin());
  std::sort(sorted.begin(), sorted.end());
  return std::adjacent_find(sorted.begin(), sorted.end()) != sorted.end();
}

bool HasZeroAreaInFan(const PolygonSoup& soup, Corners corners, std::size_t apex) {
  const std::size_t size = corners.size();
  const auto point = [&](std::size_t i) { return soup.position[corners[(apex + i) % size]]; };
  for (std::size_t i = 1; i + 1 < size; ++i) {
    if (IsZeroArea(point(0), point(i), point(i + 1))) return true;
  }
  return false;
}

/// The first corner whose fan has no triangle of zero area; the number of corners when there is
/// none.
std::size_t FindApex(const PolygonSoup& soup, Corners corners) {
  const auto finite = [&](Index v) { return soup.position[v].allFinite(); };
  if (!std::all_of(corners.begin(), corners.end(), finite)) return 0;
  // A triangle has only one fan.
  const std::size_t last = corners.size() == 3 ? 1 : corners.size();
  for (std::size_t apex = 0; apex < last; ++apex) {
    if (!HasZeroAreaInFan(soup, corners, apex)) return apex;
  }
  return corners.size();
}

void AppendFan(Corners corners, std::size_t apex, Index polygon, TriangleSoup* triangles) {
  const std::size_t size = corners.size();
  for (std::size_t i = 1; i + 1 < size; ++i) {
    const Index h = static_cast<Index>(triangles->vertex.size());
    for (const std::size_t k : {std::size_t{0}, i, i + 1}) {
      triangles->vertex.push_back(corners[(apex + k) % size]);
    }
    triangles->polygon.push_back(polygon);
    // Across the edge from the apex to corner i lies the triangle before, across the one from
    // corner i + 1 the triangle behind.
    triangles->mate.push_back(kNone);
    triangles->mate.push_back(i + 2 < size ? h + 5 : kNone);
    triangles->mate.push_back(i > 1 ? h - 2 : kNone);
  }
}

}  // namespace

bool IsZeroArea(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c) {
  const double longest =
      std::max({(b - a).stableNorm(), (c - b).stableNorm(), (a - c).stableNorm()});
  // Scaled first, so that tiny and huge triangles neither underflow nor overflow.
  const Eigen::Vector3d ab = (b - a) / longest, ac = (c - a) / longest;
  return !(ab.cross(ac).norm() > 1e-12);
}

TriangleSoup SplitIntoFans(const PolygonSoup& soup, BadFaces* bad) {
  TriangleSoup triangles;
  triangles.vertex.reserve(soup.corner.size());
  triangles.mate.reserve(soup.corner.size());
  triangles.polygon.reserve(soup.num_polygons());
  std::vector<std::size_t> apex(soup.num_polygons());
  ParallelFor(soup.num_polygons(), [&](Index p) {
    const Corners corners = CornersOf(soup, p);
    apex[p] = RepeatsVertex(corners) ? kNoApex : FindApex(soup, corners);
  });
  for (Index p = 0; p < soup.num_polygons(); ++p) {
    if (apex[p] == kNoApex) {
      bad->repeated_vertex.push_back(p);
      continue;
    }
    const Corners corners = CornersOf(soup, p);
    if (apex[p] == corners.size()) bad->zero_area.push_back(p);
    AppendFan(corners, apex[p], p, &triangles);
  }
  return triangles;
}

}  // namespace cirque
