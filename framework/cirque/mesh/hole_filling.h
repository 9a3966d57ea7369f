#pragma once

#include <vector>

#include "cirque/core/metric.h"
#include "cirque/core/status.h"
#include "cirque/mesh/surface.h"

namespace cirque {

enum class KeptLoops {
  kLongest,  ///< the boundary loop of greatest length stays open (the first one of equal length)
  kNoLoop,   ///< a closed surface comes out
};

/// A surface whose first faces and vertices are those of another, in its order, and whose later
/// ones fill holes of it.
struct FilledSurface {
  Surface surface;  ///< fill: soup_polygon and soup_vertex are kNone
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
