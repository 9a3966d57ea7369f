#pragma once

#include <vector>

#include <Eigen/Core>

#include "cirque/core/triangulation.h"
#include "cirque/math/box_tree.h"

namespace cirque {

/// Directions spread evenly over the unit sphere, along a spiral of equal areas and golden angles
/// (Á. González, "Measurement of areas on a sphere using Fibonacci and latitude-longitude
/// lattices", Mathematical Geosciences 42, 2010).
std::vector<Eigen::Vector3d> SpreadDirections(int count);

/// From how many sides the edges of a surface in space are seen. From a direction an edge is seen
/// where the surface's outside at its midpoint lies that way (one of its triangles faces it; in a
/// concave edge both do) and no other triangle is met by the ray from there. A closed surface that
/// is turned inside out is taken as it lies; the back of a surface with a boundary is not seen. A
/// view from far away, of this surface alone.
class Visibility {
 public:
  /// `directions` > 0. Refers to the surface, which must outlive it. O(F log F).
  Visibility(const Triangulation& triangulation, const std::vector<Eigen::Vector3d>& position,
             int directions);

  /// The share of the directions from which the edge is seen, in [0, 1]; of every `parts`-th of them only
  /// from number `part` on. O(log F) a direction, expected. @pre 0 <= part < parts <= directions.
  double Of(Index edge, int part = 0, int parts = 1) const;

 private:
  using Point = Eigen::Vector3d;

  const Point& At(Index corner) const { return position_[t_.vertex[corner]]; }
  Point Normal(Index face) const;
  bool FacesOutward(Index edge, const Point& direction) const;
  bool IsHidden(Index edge, const Point& from, const Point& direction) const;
  bool IsHit(Index face, const Point& from, const Point& direction) const;

  const Triangulation& t_;
  const std::vector<Point>& position_;
  std::vector<Point> directions_;
  BoxTreeOf<3> tree_;
  double side_ = 1;  ///< -1: the triangles' clockwise sides are the outside
};

}  // namespace cirque
