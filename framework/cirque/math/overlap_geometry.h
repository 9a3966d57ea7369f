#pragma once

#include <array>
#include <vector>

#include <Eigen/Core>

namespace cirque {

/// The corners of a triangle in the plane, counter-clockwise.
using PlaneTriangle = std::array<Eigen::Vector2d, 3>;

/// Whether two triangles have an inner point in common, exactly.
bool InteriorsMeet(const PlaneTriangle& s, const PlaneTriangle& t);

/// The corners of a convex polygon, counter-clockwise.
using ConvexPolygon = std::vector<Eigen::Vector2d>;

/// Its area, 0 with fewer than three corners.
double Area(const ConvexPolygon& polygon);

/// Cuts a convex polygon along the sides of a counter-clockwise triangle. Appends the pieces
/// outside the triangle, at most three, to `outside`, and returns the piece inside, empty where
/// there is none. Corners are rounded to doubles.
ConvexPolygon CutByTriangle(ConvexPolygon polygon, const PlaneTriangle& triangle,
                            std::vector<ConvexPolygon>* outside);

}  // namespace cirque
