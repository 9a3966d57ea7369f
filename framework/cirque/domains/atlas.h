#pragma once

#include <utility>
#include <vector>

#include "cirque/core/metric.h"
#include "cirque/core/status.h"
#include "cirque/core/triangulation.h"
#include "cirque/domains/map_options.h"
#include "cirque/layout/exact_map.h"
#include "cirque/mesh/surface.h"
#include "cirque/pipeline/summaries.h"

/// Maps of several components side by side in the plane.
namespace cirque {

/// A map in the plane.
struct PlanarPiece {
  double surface_area;
  Patches patches;  ///< of its triangles
  CornerUv* uv;     ///< of their corners

  PlanarPiece(double area, Patches pieces, CornerUv* corners)
      : surface_area(area), patches(std::move(pieces)), uv(corners) {}
  /// Of a surface's own triangles, opened along the cut; its flags may be missing: nowhere.
  PlanarPiece(const Surface& surface, const Cut& cut, CornerUv* corners);
};

/// The area of a surface, and that of an image, of which flipped triangles count as negative.
double AreaOf(const Surface& surface);

/// What the frame holds.
struct ArrangedAtlas {
  int patches = 0;
  double area_used = kUnset;  ///< share of the bounding square that the images' triangles cover
  /// Pieces none of whose triangles was flipped and some are now, exactly: their smallest are lost in
  /// the rounding of coordinates far from 0. Increasing.
  std::vector<std::size_t> lost;
};

/// Whether the frame leaves so many maps where they are.
bool LeavesInPlace(const UvFrame& frame, std::size_t num_pieces);

/// Puts the maps into the frame, all by similarities that keep orientation: several ones, and all of
/// their patches, side by side (PackPatches). A single map keeps its place but for size.
ArrangedAtlas ArrangeAtlas(const UvFrame& frame, const std::vector<PlanarPiece>& pieces);

/// An exact map and the surface that it is of.
struct ExactPiece {
  const Surface& surface;
  ExactMap* map;
};

/// The same for exact maps. Error (kUnrepresentable): rounding at the new place would turn a triangle
/// over; the maps then are where they were.
Status ArrangeAtlas(const UvFrame& frame, const std::vector<ExactPiece>& pieces);

/// Several surfaces, or maps, as one of several parts, one behind the other.
Surface Joined(const std::vector<const Surface*>& surfaces);
CornerUv Joined(const std::vector<const CornerUv*>& uvs);
ExactMap Joined(const std::vector<ExactPiece>& pieces);

}  // namespace cirque
