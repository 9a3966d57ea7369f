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
/// the one with the largest least angle first (G. Meisters, Polygons have ears, Amer. Math. Monthly
/// 82, 1975). The polygon is looked at along the axis that its normal (Newell) is nearest to, its
/// corners decided exactly; points on a straight side are corners like others and no triangle is
/// flat. Empty for a polygon that crosses or touches itself as seen so, or has no area. O(n^2).
PolygonTriangles CutEars(std::span<const Eigen::Vector3d> polygon);

/// Twice the area times the unit normal of a polygon, flat or not.
Eigen::Vector3d NewellNormal(std::span<const Eigen::Vector3d> polygon);

}  // namespace cirque
