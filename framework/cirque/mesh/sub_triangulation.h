#pragma once

#include <vector>

#include "cirque/core/metric.h"
#include "cirque/core/triangulation.h"

namespace cirque {

/// Some faces of a triangulation, their vertices and faces renumbered in the old order.
struct SubTriangulation {
  Triangulation triangulation;
  std::vector<Index> vertex;     ///< per vertex of the part: its number in the whole
  std::vector<Index> face;       ///< per face of the part: its number in the whole
  std::vector<Index> of_vertex;  ///< per vertex of the whole: its number in the part, or kNone

  /// The whole's halfedge that halfedge h of the part is.
  Index Halfedge(Index h) const { return 3 * face[h / 3] + h % 3; }
};

/// The faces with `keep`. @pre they leave no vertex with two fans of corners.
SubTriangulation KeepFaces(const Triangulation& whole, const std::vector<bool>& keep);

/// Lengths of the whole's edges as the part's.
EdgeLengths LengthsOf(const SubTriangulation& part, const Triangulation& whole,
                      const EdgeLengths& lengths);

/// The faces on one side of all chords, by flag: a chord is an inner edge between two boundary
/// vertices. Of the pieces into which the chords cut a disk the one with the most faces, the first
/// of equals. It has no chord itself: an inner vertex, or but one triangle.
std::vector<bool> LargestChordlessPiece(const Triangulation& disk);

}  // namespace cirque
