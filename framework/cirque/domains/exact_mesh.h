#pragma once

#include <vector>

#include "cirque/io/polygon_soup.h"
#include "cirque/layout/exact_map.h"
#include "cirque/mesh/surface.h"

namespace cirque {

/// A mesh refined so that an exact map is linear on its triangles.
struct ExactMesh {
  /// Triangles with texture. The first points are those of the input, in its order; the others lie
  /// on edges of its triangles.
  PolygonSoup mesh;
  std::vector<Index> polygon;  ///< of the input: in which every triangle lies; not decreasing
};

/// The input refined by the exact map of `surface`, which was made of it; without the triangles of
/// a fill (FillHoles).
ExactMesh RefineByExactMap(const PolygonSoup& input, const Surface& surface, const ExactMap& map);

}  // namespace cirque
