#pragma once

#include <vector>

#include "cirque/core/metric.h"
#include "cirque/core/status.h"
#include "cirque/domains/domain.h"
#include "cirque/domains/half_plane_chart.h"
#include "cirque/intrinsic/intrinsic_delaunay.h"
#include "cirque/intrinsic/intrinsic_surface.h"

namespace cirque {

/// A surface cut from another one (SplitEdges).
struct CutFrom {
  std::vector<Index> face;  ///< FacesBeforeSplit; empty: it is that surface
  Index num_faces = 0;      ///< of the other one
};

/// Error (kUnrepresentable): a face of the triangulation that was solved on is flipped there, or
/// doubles do not hold it; `elsewhere` may hold the map.
Status CheckSolvedNotFlipped(const Triangulation& solved, const CornerUv& uv,
                             const char* elsewhere);

/// Draws the exact map of a disk whose faces, as `solved` has them, lie in the plane as `uv` says,
/// and describes it in the certificate. A Moebius map bends the straight edges of the chart; in the
/// image they are drawn straight again, so that the map is linear on every solved face as it is in
/// the plane: each face of the overlay then is part of a face that is not flipped. Errors:
/// kUnrepresentable for a flipped one; those of DrawExactMap; kInvalidInput for an overlay above
/// the limit.
Status DrawExactDisk(const Triangulation& disk, const IntrinsicTriangulation& solved,
                     const CornerUv& uv, const CutFrom& from, int limit, SurfaceMap* map);

/// An exact map of a surface with these edges split (SplitEdges), of that before. Error
/// (kUnrepresentable): rounding turns a triangle over in its face.
StatusOr<ExactMap> BeforeSplit(const Triangulation& triangulation, const std::vector<bool>& edges,
                               const Triangulation& split, ExactMap map);

/// Hands the exact map of `from`, a map of the surface with these edges split, and what the certificate
/// says of it to the map of that before (BeforeSplit).
Status TakeExactMap(const Triangulation& triangulation, const std::vector<bool>& edges,
                    const Triangulation& split, SurfaceMap* from, SurfaceMap* map);

}  // namespace cirque
