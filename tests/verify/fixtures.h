#pragma once

#include <array>
#include <utility>
#include <vector>

#include "cirque/io/polygon_soup.h"
#include "cirque/verify/map_check.h"

namespace cirque::verify {

using Triangle = std::array<Index, 3>;
using Cell = std::pair<int, int>;

/// VerifyMap where it must not fail as a whole.
MapReport Judge(const PolygonSoup& in, const PolygonSoup& out, const VerifyOptions& options = {});

/// A triangle mesh without texture.
PolygonSoup MakeSoup(std::vector<Eigen::Vector3d> position, const std::vector<Triangle>& triangles);

/// The mesh with one UV per vertex.
PolygonSoup WithVertexUv(PolygonSoup mesh, std::vector<Eigen::Vector2d> uv);

/// The mesh with its own UV at every corner.
PolygonSoup WithCornerUv(PolygonSoup mesh, std::vector<Eigen::Vector2d> uv);

/// The positions' x and y.
std::vector<Eigen::Vector2d> Flattened(const PolygonSoup& mesh);

/// n x n unit squares, each cut into two triangles, on a gently curved sheet over [0, n]^2.
/// Vertex (i, j) has number j (n + 1) + i.
PolygonSoup Sheet(int n);

/// The same in the plane z = 0.
PolygonSoup FlatSheet(int n);

/// Unit squares (two triangles each) in the plane, each glued to the one before it along their
/// common edge and to nothing else, so that a walk which comes back lies on itself or touches
/// itself. Returned with UVs; the positions rise with the walk.
PolygonSoup SquareStrip(const std::vector<Cell>& walk);

/// n triangles round vertex 0, apart from each other in height. `uv_step` is the UV angle of each
/// at vertex 0. Cut along the edge (0, 1) unless `uv_step` n is a multiple of 2 pi.
PolygonSoup Fan(int n, double uv_step);

}  // namespace cirque::verify
