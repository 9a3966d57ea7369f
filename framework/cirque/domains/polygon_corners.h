#pragma once

#include <vector>

#include "cirque/core/metric.h"
#include "cirque/core/status.h"
#include "cirque/core/triangulation.h"

namespace cirque {

/// The boundary vertices of a disk in order, the surface on their left.
std::vector<Index> BoundaryInOrder(const Triangulation& disk);

/// Sorts corners along the boundary, the first one staying first. Error (invalid input): they are
/// not different vertices of the boundary.
Status SortCorners(const Triangulation& disk, std::vector<Index>* corners);

/// Boundary vertices that a map with straight sides needs corners at, or others like them: a chord,
/// an inner edge between two boundary vertices, leaves the triangles on either side of it no area
/// unless some corner lies strictly beyond it. Of the pieces into which the chords cut the disk
/// those with one chord are the ends; one vertex of each, the middle one along the boundary by
/// number of edges, in the boundary's order. A boundary vertex of but one triangle is such a piece.
std::vector<Index> CornersBeyondChords(const Triangulation& disk);

/// The boundary vertices nearest to the corners of a regular polygon in the unit disk; those of
/// CornersBeyondChords first.
std::vector<Index> NearlyRegularCorners(const Triangulation& disk, const CornerUv& in_disk,
                                        int sides);

}  // namespace cirque
