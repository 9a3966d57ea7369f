#pragma once

#include <optional>
#include <string>
#include <vector>

#include "cirque/core/metric.h"
#include "cirque/io/polygon_soup.h"
#include "cirque/mesh/preflight.h"
#include "cirque/mesh/surface.h"

namespace cirque {

/// The soup as a surface, which it must be.
Surface SurfaceOf(const PolygonSoup& soup);

/// A mesh of ../shared/meshes, which must be a surface.
struct SharedSurface {
  PolygonSoup soup;
  PreflightReport report;
  Surface surface;
};

/// Reads NAME.obj there; nothing where the file does not exist, for the test to be skipped.
std::optional<SharedSurface> ReadSharedSurface(const std::string& name);

/// A generator's mesh as a surface.
Surface GeneratedSurface(const std::string& generator, Index triangles, unsigned seed = 1);

/// A vertex in the middle of n triangles whose outer vertices lie at the given angle steps around
/// it (they need not add up to 2 pi: the apex is lifted), radius 1.
Surface Fan(int n, double height);

/// The flat rectangle [0, columns] x [0, rows] of unit squares, vertex (i, j) being number j
/// (columns + 1) + i. Diagonals pass through points of even i + j: with an even number of rows and
/// columns all corners have two triangles.
Surface FlatStrip(int columns, int rows);

/// Every face split into three by a vertex at its centroid.
Surface Kleetope(const Surface& surface);

/// The regular polyhedron of 4, 8 or 20 triangles on the unit sphere.
Surface RegularPolyhedron(int num_faces);

/// Opens the inner edge of halfedge h, from a to b, and fills the gap with two faces: one of the
/// corners a, b, a, and in the loop that it leaves at a one whose other two sides are glued to each
/// other round a new vertex, the last, of one corner. What intrinsic flips may lead to, but no
/// simplicial complex.
Triangulation WithFoldedFace(const Triangulation& triangulation, Index h);

/// A tube of radius 1, closed at both ends, but for one triangle in its middle: two limbs, each seen
/// from a small hole.
Surface TwoLimbs(int rings);

/// The surface with its points moved.
template <class Map>
Surface Moved(Surface surface, const Map& map) {
  for (Eigen::Vector3d& x : surface.position) x = map(x);
  return surface;
}

/// The surface's corner angles [rad].
CornerAngles AnglesOf(const Surface& surface);

/// The meshes side by side in one soup.
PolygonSoup Together(const std::vector<PolygonSoup>& parts);

/// A terrain and a sphere, the first face of each twice, and a fin: a face on an inner edge of the
/// terrain, which then has three.
PolygonSoup UncleanMesh();

}  // namespace cirque
