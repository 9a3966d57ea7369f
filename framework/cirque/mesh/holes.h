#pragma once

#include <vector>

#include "cirque/core/metric.h"
#include "cirque/core/status.h"
#include "cirque/core/triangulation.h"
#include "cirque/mesh/surface.h"

/// Holes: faces taken out of a surface, down to a part of it or to a puncture, and put into it.
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
std::vector<bool> LargestChordlessPiece(const Triangulation& disk,
                                        const std::vector<bool>& boundary);

/// A closed surface without the open star of one vertex.
struct PuncturedSurface : SubTriangulation {
  std::vector<Index> link;  ///< the vertices next to the pole, around it, in the closed surface
  Index pole = kNone;       ///< the vertex removed
};

/// Whether the closed star of the vertex of `corner` is a disk: its neighbours differ from each
/// other and from the vertex itself. (In a Delta-complex they need not.)
bool HasDiskStar(const Triangulation& triangulation, Index corner);

/// Removes the star of `pole`. Errors (invalid input): a star that is no disk, or nothing left.
/// @pre a closed surface.
StatusOr<PuncturedSurface> Puncture(const Triangulation& triangulation, Index pole);

enum class KeptLoops {
  kLongest,  ///< the boundary loop of greatest length stays open (the first one of equal length)
  kNoLoop,   ///< a closed surface comes out
};

/// A surface whose first faces and vertices are those of another, in its order, and whose later
/// ones fill holes of it.
struct FilledSurface {
  Surface surface;  ///< fill: soup_polygon, soup_vertex and soup_corner are kNone
  Index num_input_faces = 0;
  Index num_input_vertices = 0;
  Index num_filled_loops = 0;
};

/// Closes the boundary loops of a surface, in its own orientation: a loop of three edges by one
/// triangle, any other (and such a triangle without area, or one that would repeat a face) by a fan
/// about a new vertex. That vertex is the mean of the loop's, lifted along the loop's normal where
/// triangles would be slivers. Errors (invalid input): no lift gives all triangles an area, because
/// the coordinates of the loop are too close together for doubles; its vertices are named.
StatusOr<FilledSurface> FillHoles(const Surface& surface, KeptLoops kept);

/// The UVs of the input's faces alone, so that the fill does not appear in the output.
CornerUv WithoutFill(const FilledSurface& filled, const CornerUv& uv);

}  // namespace cirque
