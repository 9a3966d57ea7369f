#pragma once

#include <cmath>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "cirque/core/metric.h"
#include "cirque/core/triangulation.h"
#include "cirque/intrinsic/overlay.h"
#include "cirque/math/lattice.h"
#include "cirque/math/predicates.h"

/// Where the corners of an overlay lie in an exact map (MakeExactMap of layout/exact_map.h): in the plane
/// or on the sphere.
namespace cirque {

/// The ends of the side of a triangulation's face on which a crossing lies: the halfedges whose
/// corners they are, in the direction in which the crossing's fraction counts.
struct SideOfCrossing {
  Index tail, tip;

  SideOfCrossing(Index side, Index direction) {
    tail = Triangulation::Next(side);
    tip = Triangulation::Prev(side);
    if (side != direction) std::swap(tail, tip);
  }
};

/// The plane, opened along a cut of the triangulation that was solved on.
class PlaneImage {
 public:
  using Point = Eigen::Vector2d;

  PlaneImage(const Triangulation& other, const Cut& cut, const CornerUv& uv,
             std::optional<int> grid)
      : open_(CutOpen(other, cut)), uv_(uv), grid_(grid) {}

  const Point& AtVertex(const Overlay::Corner& corner) const { return uv_.value[corner.other]; }

  /// The same bits from both sides of an edge that is no seam.
  Point AtCrossing(const Overlay::Corner& corner, const Crossing& crossing) const {
    const SideOfCrossing side(corner.other, crossing.other);
    const Point& tail = uv_.value[side.tail];
    Point along = crossing.along_other * (uv_.value[side.tip] - tail);
    if (grid_ && IsOnSeam(corner)) {
      along = {RoundToGrid(along.x(), *grid_), RoundToGrid(along.y(), *grid_)};
    }
    return tail + along;
  }

  static bool IsPositive(const Point& a, const Point& b, const Point& c) {
    return OrientationSign(a, b, c) > 0;
  }

  static double Size(const Point& a, const Point& b, const Point& c) {
    return (b.x() - a.x()) * (c.y() - a.y()) - (b.y() - a.y()) * (c.x() - a.x());
  }

  /// One number below 2 (vertices + crossings) for what has one place: of a crossing two where it
  /// lies on a seam.
  Index KeyOfVertex(const Overlay::Corner& corner) const { return open_.vertex[corner.other]; }
  Index KeyOfCrossing(const Overlay::Corner& corner, const Crossing& crossing, Index number) const {
    const bool second = IsOnSeam(corner) && corner.other != crossing.other;
    return open_.num_vertices + 2 * number + (second ? 1 : 0);
  }
  Index NumKeys(std::size_t crossings) const {
    return open_.num_vertices + 2 * static_cast<Index>(crossings);
  }

 private:
  bool IsOnSeam(const Overlay::Corner& corner) const { return open_.twin[corner.other] == kNone; }

  const Triangulation open_;
  const CornerUv& uv_;
  const std::optional<int> grid_;
};

/// The unit sphere.
class SphereImage {
 public:
  using Point = Eigen::Vector3d;

  SphereImage(const Triangulation& other, const std::vector<Point>& position)
      : other_(other), position_(position) {}

  const Point& AtVertex(const Overlay::Corner& corner) const { return position_[corner.vertex]; }

  /// The same bits from both sides of an edge.
  Point AtCrossing(const Overlay::Corner& corner, const Crossing& crossing) const {
    const SideOfCrossing side(corner.other, crossing.other);
    const Point &tail = position_[other_.vertex[side.tail]],
                &tip = position_[other_.vertex[side.tip]];
    return Point(tail + crossing.along_other * (tip - tail)).normalized();
  }

  /// As seen from outside: from the origin it turns clockwise.
  static bool IsPositive(const Point& a, const Point& b, const Point& c) {
    return OrientationSign3(a, b, c, Point::Zero()) < 0;
  }

  static double Size(const Point& a, const Point& b, const Point& c) {
    return a.dot((b - a).cross(c - a));
  }

 private:
  const Triangulation& other_;
  const std::vector<Point>& position_;
};

}  // namespace cirque
