#pragma once

#include <utility>
#include <vector>

#include "cirque/io/polygon_soup.h"
#include "cirque/mesh/assembly.h"
#include "cirque/mesh/preflight.h"
#include "cirque/mesh/surface.h"

/// A soup looked at, before it is refused, repaired or made a surface.
namespace cirque {

/// The soup as glued and oriented triangles, good or not.
struct Assembly {
  TriangleSoup triangles;
  Gluing gluing;
  Orientation orientation;
};

/// A triangle of a one-sided piece and an edge of it by its vertices, where that shows.
struct OneSided {
  Index face;
  std::pair<Index, Index> edge;
};

struct Inspected {
  Assembly assembly;
  std::vector<std::vector<Index>> components;  ///< polygons
};

/// Judges the soup and fills in the report. @pre indices in range, at least 3 corners a polygon.
Inspected Inspect(const PolygonSoup& soup, PreflightReport* report);

/// Of every one-sided piece.
std::vector<OneSided> FindOneSided(const Assembly& assembly);

/// The surface, of any number of components, that the triangles are. @pre they are manifold; pieces
/// that are one-sided are no surfaces.
Surface BuildSurface(const PolygonSoup& soup, Assembly assembly);

}  // namespace cirque
