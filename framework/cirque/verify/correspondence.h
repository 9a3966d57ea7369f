#pragma once

#include <map>
#include <vector>

#include "cirque/core/types.h"
#include "cirque/io/polygon_soup.h"

namespace cirque::verify {

/// The faces of a mesh with a name for every corner. IN's corners and OUT's have the same name
/// where they are meant to be one vertex; kNone is no name.
struct NamedFaces {
  std::vector<Index> first_corner = {0};  ///< F + 1, as in PolygonSoup
  std::vector<Index> name;                ///< per corner

  Index num_faces() const { return static_cast<Index>(first_corner.size()) - 1; }
  Index NumCorners(Index f) const { return first_corner[f + 1] - first_corner[f]; }
  Index Name(Index f, Index k) const { return name[first_corner[f] + k]; }
};

/// The corners of a mesh by the names of its vertices.
NamedFaces NameCorners(const PolygonSoup& soup, const std::vector<Index>& vertex_name);

/// Which faces of OUT are which of IN.
struct Correspondence {
  std::vector<Index> out_face;  ///< per face of IN; kNone where OUT lacks it or has it in pieces
  std::map<Index, std::vector<Index>> pieces;  ///< of those faces of IN that OUT has in pieces
  std::vector<Index> missing;                  ///< faces of IN that OUT lacks
  std::vector<Index> extra;                    ///< faces of OUT that IN lacks
  std::vector<Index> reversed;                 ///< faces of IN that run the other way round in OUT
  bool same_order = false;                     ///< OUT lists them as IN does

  bool complete() const { return missing.empty() && extra.empty(); }
};

/// Faces correspond when their corners have the same names in turn, from whichever corner on; those
/// that are left when their corners have the same names in reverse; and a polygon of IN that is
/// still left to faces of OUT that, glued along diagonals of the polygon, have its border, in which
/// corners that repeat the name of the one before count once.
/// O(n log n) with n corners.
Correspondence MatchFaces(const NamedFaces& in, const NamedFaces& out);

}  // namespace cirque::verify
