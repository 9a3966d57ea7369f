#pragma once

#include <array>
#include <span>
#include <vector>

#include <Eigen/Core>

#include "cirque/core/types.h"

namespace cirque {

/// A polygon's corners in three, by their places along it, counter-clockwise as the polygon runs.
using PolygonTriangles = std::vector<std::array<Index, 3>>;

/// n - 2 triangles that fill the polygon and stay inside it: ears are cut off one after the other,
/// the one with the largest least angle first, of equal ones that whose corner has the least
/// coordinates, so that it does not matter where the polygon begins (G. Meisters, Polygons have
/// ears, Amer. Math. Monthly 82, 1975). The polygon is looked at along the axis that its normal
/// (Newell) is nearest to, its corners decided exactly, and where it crosses itself as seen so,
/// being bent, along the normal; points on a straight side are corners like others and no triangle
/// is flat. The polygon may touch itself at corners and along whole sides, as a keyhole does that
/// leads to a hole inside. Empty for a polygon that crosses itself either way, or has no area. O(n log n + n r) with r corners that are not convex.
PolygonTriangles CutEars(std::span<const Eigen::Vector3d> polygon);

/// The cosine of the least angle of a triangle: small for a good one. Rounded to nine digits, so that
/// equal triangles have equal ones.
double Sharpness(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c);

/// By x, then y, then z: an order that does not depend on how points are numbered.
bool ComesBefore(const Eigen::Vector3d& a, const Eigen::Vector3d& b);

/// Twice the area times the unit normal of a polygon, flat or not.
Eigen::Vector3d NewellNormal(std::span<const Eigen::Vector3d> polygon);

}  // namespace cirque
