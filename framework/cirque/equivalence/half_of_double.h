#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "cirque/core/metric.h"
#include "cirque/core/status.h"
#include "cirque/core/triangulation.h"
#include "cirque/equivalence/solve_log_scales.h"
#include "cirque/intrinsic/broken_geodesics.h"
#include "cirque/intrinsic/intrinsic_delaunay.h"
#include "cirque/intrinsic/overlay.h"

namespace cirque {

/// A surface's half of its double, on which log scales were solved, as a triangulation of its own:
/// with the surface's vertices and boundary edges, which flips in the flat metric brought back to
/// the double (RestoreEdges), since they are straight there by symmetry.
struct HalfOfDouble {
  IntrinsicTriangulation half;  ///< lengths: flat; no flips: it is none of the surface's
  CornerAngles angles;          ///< of half, flat [rad]
};

/// What the overlay of a surface and what log scales were solved on is made of.
struct EquivalentTriangulation {
  ScaledTriangulation whole;  ///< the surface, or its double
  std::vector<Index>
      face_of_half;  ///< of whole.scaled's faces; kNone: of the mirror image; empty: no double
};

/// That of a result. `flat`: the flat lengths of result.intrinsic.
EquivalentTriangulation TakeWhole(const Triangulation& surface, const LogScalesResult& result,
                                  const EdgeLengths& flat);

/// That of a result on the surface's double, with the half. Nothing where rounding keeps the
/// boundary from coming back.
std::optional<HalfOfDouble> TakeHalf(const Triangulation& surface, const LogScalesResult& result,
                                     const EdgeLengths& flat, EquivalentTriangulation* whole);

/// The overlay of the surface and what it was solved on (OverlayThroughDelaunay), of a double's its
/// half. Error: as MakeOverlay.
StatusOr<Overlay> OverlayOf(const EquivalentTriangulation& equivalent, std::int64_t most_faces);

}  // namespace cirque
