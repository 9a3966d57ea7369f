#pragma once

#include <optional>
#include <vector>

#include "cirque/core/solve_summary.h"
#include "cirque/domains/atlas.h"
#include "cirque/domains/map_components.h"
#include "cirque/domains/map_options.h"
#include "cirque/mesh/holes.h"
#include "cirque/mesh/preflight.h"

/// The components of a mesh on their way to one atlas.
namespace cirque {

/// A component and what becomes of it.
struct MeshPiece {
  const MeshComponent& of;
  ComponentSummary component;
  std::optional<FilledSurface> filled = {};  ///< where holes are filled for the solve
  MappedComponent mapped = {};               ///< its certificate is filled in any case
  MapRequest request = {};                   ///< what was asked of its map
  bool with_cones_for_frame = false;         ///< that asks for what ArrangePieces chose

  bool IsSurface() const { return of.surface.ok(); }
  const Surface& Solved() const { return filled ? filled->surface : *of.surface; }
  bool HasMap() const { return IsSurface() && mapped.status.ok(); }
};

/// Maps pieces as their requests say (MapComponents).
void MapPieces(const std::vector<MeshPiece*>& pieces, const SolveControl& control);

/// Puts the maps of pieces, all of which have one, into the frame, without what filled their holes.
/// Those that lose triangles there, because their scale ranges over more than coordinates far from 0
/// tell apart, are mapped again with cones that leave less of a range, where cones are the program's
/// to choose: where half of the curvature is, then everywhere. Those that still lose some become
/// kUnrepresentable and are taken out of `pieces`.
ArrangedAtlas ArrangePieces(const UvFrame& frame, const SolveControl& control,
                            std::vector<MeshPiece*>* pieces);

}  // namespace cirque
