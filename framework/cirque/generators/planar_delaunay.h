#pragma once

#include <array>
#include <vector>

#include <Eigen/Core>

#include "cirque/core/status.h"
#include "cirque/core/types.h"

namespace cirque {

/// The corners of a triangle, counter-clockwise.
using Triangle = std::array<Index, 3>;

/// The Delaunay triangulation of the convex hull of distinct points: no point lies strictly inside
/// the circumcircle of a triangle, decided exactly. Every point is a corner, those on the hull's
/// edges too; of cocircular points some triangulation is chosen, the same one on every machine.
///
/// Incremental insertion along a Hilbert curve (A. Bowyer, D. F. Watson, 1981), with ghost
/// triangles that join the hull's edges to a point at infinity: O(n log n) for all but contrived
/// points.
///
/// Errors (invalid input): fewer than three points, a coordinate that is not finite, two equal
/// points (their numbers are named), all points on one line.
StatusOr<std::vector<Triangle>> PlanarDelaunay(const std::vector<Eigen::Vector2d>& points);

/// The same and, for every edge of the hull from a to b (the hull on its left), the triangle
/// (b, a, kNone) whose third corner is the point at infinity: a closed surface, in which kNone may
/// stand first, second or third.
StatusOr<std::vector<Triangle>> ClosedPlanarDelaunay(const std::vector<Eigen::Vector2d>& points);

/// PlanarDelaunay for points that are known to have a triangulation.
std::vector<Triangle> TriangulateHull(const std::vector<Eigen::Vector2d>& points);

/// The Delaunay triangulation of the flat torus of the given periods: of points in the cell
/// [-period / 2, period / 2]^2 and all their translates, one triangle of each class. Needs points
/// spread over the whole cell, so densely that every circumradius is below a few mean distances of
/// points and no triangle meets a translate of itself; a few hundred even ones will do.
std::vector<Triangle> PeriodicDelaunay(const std::vector<Eigen::Vector2d>& points,
                                       const Eigen::Vector2d& periods);

/// The points' numbers in the order of a Hilbert curve whose cells are halved at medians, so that
/// neighbours in the order are near each other however uneven the points' density is. Equal
/// coordinates are ordered by number: the result is the same on every machine.
std::vector<Index> HilbertOrder(const std::vector<Eigen::Vector2d>& points);

}  // namespace cirque
