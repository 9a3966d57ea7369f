#pragma once

#include <array>
#include <string>
#include <utility>
#include <vector>

#include "cirque/core/status.h"
#include "cirque/io/polygon_soup.h"
#include "cirque/mesh/surface.h"

namespace cirque {

/// Everything about a mesh that decides whether it can be parameterized. Lists hold ids of the
/// soup, counted from 0, in increasing order.
struct PreflightReport {
  Index num_vertices = 0, num_polygons = 0, num_triangles = 0, num_edges = 0;
  std::vector<Index> non_finite_vertices;
  std::string non_finite_at;                 ///< where the first stands in its file; empty: unknown
  std::vector<Index> isolated_vertices;      ///< of no face; set aside by the repair
  std::vector<Index> duplicate_vertices;     ///< where an earlier one lies; legal, left apart
  std::vector<Index> repeated_vertex_faces;  ///< left out of all that follows
  std::vector<Index> zero_area_faces;  ///< twice the area <= 1e-12 (longest edge)^2, in any split
  std::vector<std::pair<Index, Index>> non_manifold_edges;  ///< of more than two faces
  std::vector<Index> non_manifold_vertices;  ///< whose corners do not form one fan or one cycle
  std::vector<Index> reoriented_faces;       ///< turned around by the repair
  Index components = 0;                      ///< faces that share a vertex belong together
  bool orientable = true;
  Index boundary_loops = 0;
  Index genus = 0;  ///< of all components together: handles, or crosscaps when not orientable;
                    ///< kNone when this is not a manifold

  /// A few lines for people; vertices and faces are counted from 1 in the file's order (in OBJ:
  /// their numbers in the file).
  std::string Text() const;
};

/// Judges the soup and, where nothing has to be guessed, repairs it: isolated vertices are set
/// aside; faces are turned around to agree with the majority of their neighbours (with the first
/// face when there is none); polygons are split into triangles inside themselves
/// (SplitIntoTriangles). Everything else is refused, all problems in one
/// message: what, where (counted from 1) and what to do. The report is filled in either case. Runs
/// in O(F + V). The soup must be one: indices in range, at least 3 corners a polygon.
StatusOr<Surface> Preflight(const PolygonSoup& soup, PreflightReport* report);

/// The surface of points (V) and triangles (F, corners counted from 0), judged and repaired by
/// Preflight, whose messages count vertices and faces from 1. Faces keep their numbers, and so do
/// vertices unless a point belongs to no triangle (Surface::soup_vertex). Error (invalid input):
/// also a corner that is no point.
StatusOr<Surface> SurfaceFromTriangles(const std::vector<Eigen::Vector3d>& points,
                                       const std::vector<std::array<Index, 3>>& triangles);

/// Everything in the report that forbids a parameterization, each with where it is and what to do;
/// empty when nothing does. `components` lists the polygons of each component; `one_sided_edge` is
/// where a surface that is not orientable shows it. Vertices and faces are counted from 1.
std::string DescribeProblems(const PreflightReport& report,
                             const std::vector<std::vector<Index>>& components,
                             std::pair<Index, Index> one_sided_edge);

}  // namespace cirque
