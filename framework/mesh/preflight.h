#pragma once

#include <string>
#include <vector>

#include "cirque/core/status.h"
#include "cirque/mesh/polygon_soup.h"
#include "cirque/mesh/surface.h"

namespace cirque {

/// Everything about a mesh that decides whether it can be parameterized. Lists hold 0-based ids of
/// the soup.
struct PreflightReport {
  Index num_vertices = 0, num_polygons = 0, num_triangles = 0, num_edges = 0;
  std::vector<Index> non_finite_vertices, isolated_vertices, duplicate_vertices;
  std::vector<Index> repeated_vertex_faces, zero_area_faces;
  std::vector<std::pair<Index, Index>> non_manifold_edges;
  std::vector<Index> non_manifold_vertices;
  std::vector<Index> reoriented_faces;  ///< disoriented faces, turned around by the repair
  Index components = 0;
  bool orientable = true;
  Index boundary_loops = 0;
  Index genus = 0;

  std::string Text()
      const;  ///< a few lines for people, vertex and face numbers as in the file (1-based for OBJ)
};

/// Judges the soup and, where nothing has to be guessed, repairs it: isolated vertices are set
/// aside, faces are reoriented consistently (like the majority), polygons are split into triangle
/// fans. Whatever else is wrong is refused with what, where and what to do. The report is filled in
/// either case.
StatusOr<Surface> Preflight(const PolygonSoup& soup, PreflightReport* report);

}  // namespace cirque
