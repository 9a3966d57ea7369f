#pragma once

#include "cirque/core/solve_summary.h"
#include "cirque/core/status.h"
#include "cirque/domains/domain.h"
#include "cirque/mesh/surface.h"

namespace cirque {

/// MapToPlane for a disk that is its own mirror image, mesh included, so that its map is: x -> -x takes
/// the place of every vertex to that of its mirror image, bit by bit, and what lies on the axis of the
/// surface lies on x = 0. One half is mapped, with angle sums pi along the axis, which thereby is
/// straight, and the other is its mirror image; triangles across the axis are halved for the solve. The
/// symmetry is one of edge lengths (FindMirrorSymmetry): the surface need not be symmetric in space.
///
/// The certificate's fit, radii and closure are of the half, its figures of distortion of the whole
/// surface. The map has no flat metric (Parameterization::flat). Errors: kInvalidInput for a surface that
/// is no disk or has no such symmetry, and for requests with what is not symmetric: targets, cut, cones,
/// a boundary shape, pins, an exact map, injectivity, solve_at; those of Parameterize; kUnrepresentable
/// where the axis, made straight, flips triangles.
Status MapMirrored(const Surface& surface, const MapRequest& request, const SolveControl& control,
                   SurfaceMap* map);

}  // namespace cirque
