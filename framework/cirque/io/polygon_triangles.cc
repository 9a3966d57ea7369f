#include "cirque/io/polygon_triangles.h"

#include <algorithm>

#include <Eigen/Geometry>

namespace cirque {
namespace {

using Polygon = std::vector<Eigen::Vector2d>;

double Cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& c) {
  return (b - a).x() * (c - a).y() - (b - a).y() * (c - a).x();
}

/// The polygon in its map's plane, else in the plane that it is nearest to, counter-clockwise.
Polygon Flat(const PolygonSoup& mesh, Index begin, Index end) {
  Polygon points;
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();
  bool textured = !mesh.corner_texture.empty();
  for (Index c = begin; c < end; ++c) {
    const Eigen::Vector3d& origin = mesh.position[mesh.corner[begin]];
    const Index next = c + 1 < end ? c + 1 : begin;
    normal +=
        (mesh.position[mesh.corner[c]] - origin).cross(mesh.position[mesh.corner[next]] - origin);
    textured = textured && mesh.corner_texture[c] != kNone;
  }
  Eigen::Index axis = 0;
  normal.cwiseAbs().maxCoeff(&axis);
  for (Index c = begin; c < end; ++c) {
    const Eigen::Vector3d& p = mesh.position[mesh.corner[c]];
    points.push_back(textured ? mesh.texture[mesh.corner_texture[c]]
                              : Eigen::Vector2d(p[(axis + 1) % 3], p[(axis + 2) % 3]));
  }
  double area = 0;
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    area += Cross(points[0], points[i], points[i + 1]);
  }
  if (area < 0) {
    for (Eigen::Vector2d& point : points) point.x() = -point.x();
  }
  return points;
}

/// Whether the corner in the middle of three may be cut off: convex, and no other corner in it.
bool IsEar(const Polygon& points, const std::vector<int>& left, std::size_t i) {
  const std::size_t n = left.size();
  const int before = left[(i + n - 1) % n], at = left[i], after = left[(i + 1) % n];
  const Eigen::Vector2d &a = points[before], &b = points[at], &c = points[after];
  if (!(Cross(a, b, c) > 0)) return false;
  return std::none_of(left.begin(), left.end(), [&](int other) {
    if (other == before || other == at || other == after) return false;
    const Eigen::Vector2d& p = points[other];
    return Cross(a, b, p) >= 0 && Cross(b, c, p) >= 0 && Cross(c, a, p) >= 0;
  });
}

}  // namespace

std::vector<std::array<Index, 3>> TrianglesOfPolygon(const PolygonSoup& mesh, Index polygon) {
  const Index first = mesh.first_corner[polygon], end = mesh.first_corner[polygon + 1];
  if (end - first == 3) return {{first, first + 1, first + 2}};
  const Polygon points = Flat(mesh, first, end);
  std::vector<int> left(points.size());
  for (std::size_t i = 0; i < left.size(); ++i) left[i] = static_cast<int>(i);
  std::vector<std::array<Index, 3>> triangles;
  while (left.size() > 3) {
    std::size_t ear = 0;
    while (ear < left.size() && !IsEar(points, left, ear)) ++ear;
    if (ear == left.size()) ear = 1;
    const std::size_t n = left.size();
    triangles.push_back(
        {first + left[(ear + n - 1) % n], first + left[ear], first + left[(ear + 1) % n]});
    left.erase(left.begin() + static_cast<std::ptrdiff_t>(ear));
  }
  triangles.push_back({first + left[0], first + left[1], first + left[2]});
  return triangles;
}

}  // namespace cirque
