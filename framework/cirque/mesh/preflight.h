#pragma once

#include <array>
#include <string>
#include <utility>
#include <vector>

#include "cirque/core/enum_words.h"
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

/// How far a mesh that is no surface is made one. kSafe: nothing is moved and nothing guessed; faces
/// are set aside and vertices split. kWeld: boundary vertices that lie together are made one first.
enum class RepairMode { kNothing, kSafe, kWeld };

template <>
inline constexpr auto kEnumWords<RepairMode> = std::to_array<EnumWord<RepairMode>>(
    {{RepairMode::kNothing, "none"}, {RepairMode::kSafe, "safe"}, {RepairMode::kWeld, "weld"}});

/// How to repair.
struct RepairOptions {
  RepairMode mode = RepairMode::kSafe;
  /// Of kWeld: how far apart vertices may be, relative to the diagonal of the bounding box.
  double tolerance = 0;
};

/// "none", "safe", "weld" or "weld:TOLERANCE". Error (invalid input): anything else.
StatusOr<RepairOptions> ParseRepair(const std::string& text);

/// What was done to a mesh, and what was seen in it and left. Ids are the soup's, from 0, each list
/// in increasing order.
struct RepairSummary {
  std::vector<Index> zero_area_faces;        ///< set aside
  std::vector<Index> repeated_vertex_faces;  ///< set aside: fewer than three different vertices, or
                                             ///< loops that face both ways
  std::vector<Index> duplicate_faces;  ///< set aside: an earlier one has the same vertices, and an
                                       ///< edge has more than two faces
  std::vector<Index> welded_vertices;  ///< made one with an earlier one
  std::vector<Index> split_vertices;   ///< one for each fan of corners
  std::vector<std::pair<Index, Index>> split_edges;  ///< of more than two faces
  std::vector<Index> t_junctions;  ///< left: boundary vertices inside another boundary edge
  Index coincident_edges = 0;      ///< left: boundary edges that lie where others do

  Index num_set_aside() const;
  bool ChangesNothing() const;
  /// A line for each thing done or seen, counted from 1.
  std::string Text() const;
};

/// A part of a mesh that hangs together.
struct MeshComponent {
  StatusOr<Surface> surface;  ///< or why it is none: it has only one side
  Index first_polygon = 0, num_polygons = 0;
};

/// The components of a mesh, each a surface, in the order of their first polygons, after what
/// `repair` allows:
///
/// * Faces of no area, of fewer than three different vertices, and duplicates are set aside.
/// * kWeld: vertices on the boundary of the rest that are no further apart than the tolerance are
///   made one; faces that lose their area by it are set aside too.
/// * Edges of more than two faces are opened, and every vertex whose corners then form several fans
///   becomes several, one for each. Two sides of such an edge that stay connected about both of its
///   ends meet again: the wall on a closed box comes off, and the box stays closed.
///
/// Surfaces number vertices, polygons and corners as the soup does: several vertices of surfaces may
/// be one of the soup (Surface::soup_vertex: of welded ones the first). Errors (invalid input): no
/// faces left, coordinates that are not finite, and what the mode does not allow to be repaired;
/// the message says what would be. O((F + V) log V).
StatusOr<std::vector<MeshComponent>> SurfacesOf(const PolygonSoup& soup,
                                                const RepairOptions& repair,
                                                PreflightReport* report, RepairSummary* summary);

/// The surface of points (V) and triangles (F, corners counted from 0), judged and repaired by
/// Preflight, whose messages count vertices and faces from 1. Faces keep their numbers, and so do
/// vertices unless a point belongs to no triangle (Surface::soup_vertex). Error (invalid input):
/// also a corner that is no point.
StatusOr<Surface> SurfaceFromTriangles(const std::vector<Eigen::Vector3d>& points,
                                       const std::vector<std::array<Index, 3>>& triangles);

/// Why a component is refused that shows at this edge that it has only one side.
std::string DescribeOneSided(std::pair<Index, Index> edge);

/// Everything in the report that forbids a parameterization, each with where it is and what to do;
/// empty when nothing does. `components` lists the polygons of each component; `one_sided_edge` is
/// where a surface that is not orientable shows it. Vertices and faces are counted from 1.
std::string DescribeProblems(const PreflightReport& report,
                             const std::vector<std::vector<Index>>& components,
                             std::pair<Index, Index> one_sided_edge);

}  // namespace cirque
