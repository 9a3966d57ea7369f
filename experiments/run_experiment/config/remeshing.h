#pragma once

#include <string>
#include <vector>

#include "cirque/core/status.h"
#include "cirque/io/polygon_soup.h"

/// Finer and coarser meshes of a surface, for studies of convergence and of size: OpenMesh's, but for
/// midpoints. The meshes are triangles of a manifold, as TrianglesOf gives them; texture is left out.
namespace cirque {

/// The schemes of Subdivide. "midpoint" keeps the polyhedron; the others converge to smooth surfaces:
/// "loop" (C. Loop 1987) and "sqrt3" (L. Kobbelt 2000; three triangles of one) move all vertices,
/// "butterfly" (modified; D. Zorin, P. Schröder, W. Sweldens 1996) keeps those that are there.
const std::vector<std::string>& SubdivisionSchemes();

/// The mesh subdivided `times` times. Error (invalid input): two vertices that more than one edge
/// joins, where the scheme is OpenMesh's. @pre the scheme is one of SubdivisionSchemes().
StatusOr<PolygonSoup> Subdivide(const PolygonSoup& triangles, const std::string& scheme, int times);

/// The mesh with edges collapsed, those first that change least by the error quadrics (M. Garland,
/// P. Heckbert 1997), until about `wanted` triangles are left; topology stays. A mesh of no more
/// stays as it is. Error (invalid input): collapses that keep it a manifold end before, or two
/// vertices that more than one edge joins.
StatusOr<PolygonSoup> Decimate(const PolygonSoup& triangles, Index wanted);

}  // namespace cirque
