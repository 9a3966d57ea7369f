#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <Eigen/Core>

#include "cirque/core/status.h"
#include "cirque/core/types.h"
#include "cirque/io/polygon_soup.h"

namespace cirque::verify {

/// What was found of a mesh OUT that is to refine IN. Numbers count from 0.
struct RefinementReport {
  std::vector<std::string> errors;  ///< why it is no refinement
  Index num_faces = 0;              ///< of IN
  Index num_pieces = 0;             ///< faces of OUT
  Index most_pieces = 0;            ///< in one face of IN
  Index most_pieces_in = kNone;
  /// Over IN's triangles |area of the pieces / area - 1|, beyond what the rounding of points on its
  /// sides can make of it (a unit in the last place of its largest coordinate times its perimeter).
  double area_error = 0;
  std::vector<Index> set_aside;  ///< faces of IN without pieces that need none (set_aside.h)
  Index num_polygons = 0;  ///< faces of IN that are no triangles, whose areas were not compared

  bool valid() const { return errors.empty(); }
};

/// The face of IN that each face of an OBJ is a part of, by its lines `g face_N`, N from 1. Error
/// (invalid input): a face before the first of them, or another group.
StatusOr<std::vector<Index>> ReadGroups(std::string_view obj);

/// The points of space that the lines `vt x y z` of an OBJ give its vertices, in their order. Error
/// (invalid input): a line of other numbers; a corner of `obj_mesh` whose numbers of point and texture
/// differ; no such line for every vertex.
StatusOr<std::vector<Eigen::Vector3d>> ReadTextureInSpace(std::string_view obj,
                                                          const PolygonSoup& obj_mesh);

/// Whether OUT, whose face g is a part of IN's face group[g], refines IN: its first points are
/// IN's; the pieces of every face fill it, none turned over, and their areas add up to its own
/// within 1e-12; every edge of IN is covered once from either side, by the same points in order,
/// which lie on it. Error (invalid input): numbers that do not fit.
StatusOr<RefinementReport> CheckRefinement(const PolygonSoup& in, const PolygonSoup& out,
                                           const std::vector<Index>& group);

/// Lines for people.
std::string ToText(const RefinementReport& report);

}  // namespace cirque::verify
