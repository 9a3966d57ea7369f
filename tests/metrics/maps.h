#pragma once

#include <array>
#include <functional>
#include <string>
#include <vector>

#include "cirque/metrics/measure_map.h"

#include "tests/common/surfaces.h"

namespace cirque {

/// A piecewise linear map of a surface to the plane.
struct TestMap {
  Triangulation triangulation;
  EdgeLengths lengths;
  CornerUv uv;

  MapMeasures Measure() const { return MeasureMap(triangulation, lengths, uv); }
};

using PlaneMap = std::function<Eigen::Vector2d(const Eigen::Vector3d&)>;

/// Vertex by vertex.
TestMap MapOf(const Surface& surface, const PlaneMap& map);

/// x and y of every vertex.
TestMap DroppedToPlane(const Surface& surface);

/// The map in four times as many triangles, face f split at its edges' midpoints into 4 f ... 4 f
/// + 3.
TestMap Subdivided(const Surface& surface, const CornerUv& uv);

/// n x n unit squares in the plane z = 0, two triangles each, row by row.
Surface Grid(int columns, int rows);

/// A surface of separate triangles is none; this is one triangulation of them all the same, each
/// triangle's own edges and vertices, mapped to `images`.
TestMap LooseTriangles(const std::vector<std::array<Eigen::Vector2d, 3>>& sources,
                       const std::vector<std::array<Eigen::Vector2d, 3>>& images);

}  // namespace cirque
