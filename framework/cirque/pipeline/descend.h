#pragma once

#include <atomic>
#include <optional>
#include <string>

#include "cirque/core/metric.h"
#include "cirque/core/status.h"
#include "cirque/core/triangulation.h"
#include "cirque/intrinsic/intrinsic_surface.h"
#include "cirque/pipeline/summaries.h"

namespace cirque {

/// An injective image and the way there.
struct Descent {
  CornerUv uv;
  int steps = 0;
  double before = 0,
         after = 0;  ///< mean mips energy (MapObjectives) of the embedding, of the image
  std::optional<MapRefinementSummary> refinement;  ///< where `refine_map` leaves conformality
};

/// Maps a surface injectively that the cut leaves one disk of, near a flat metric whose own image
/// overlaps itself; the seams' sides need not match. From the opened surface's embedding in a disk
/// (EmbedInDisk) first the symmetric Dirichlet energy of the map from the flat metric is lowered,
/// which brings back the image as it was except where that overlapped, then mips on the surface
/// itself, or what `refine_map` names if that leaves conformality. The boundary is free throughout,
/// and no step makes it cross itself (Fence). Errors: cancelled; kUnrepresentable where doubles hold
/// no embedding; kNotConverged where the image is far from the flat metric after its steps, as where
/// long seams that branch a thousand times lie along the boundary of the disk.
/// @pre no triangle of the flat metric is flipped.
StatusOr<Descent> DescendToInjective(const IntrinsicSurface& surface,
                                     const EdgeLengths& flat_lengths, const Cut& cut,
                                     const std::string& refine_map,
                                     const std::atomic<bool>* cancelled);

}  // namespace cirque
