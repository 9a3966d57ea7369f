#pragma once

#include <atomic>

#include "cirque/core/metric.h"
#include "cirque/core/option_table.h"
#include "cirque/core/status.h"
#include "cirque/layout/map_objective.h"
#include "cirque/layout/opened_map.h"
#include "cirque/layout/stretch_energy.h"

namespace cirque {

struct RefineMapOptions {
  int steps = 20;          ///< the most
  double decrease = 1e-4;  ///< ends when a step lowers the objective by less than this share
};

/// Both by name, with their meanings, for configs and the command line.
const OptionTable<RefineMapOptions>& RefineMapOptionTable();

/// What became of the objective.
struct MapRefinement {
  int steps = 0;  ///< on the whole map
  double before = 0, after = 0;
  bool at_rest = false;  ///< ended before the most steps: the next would bring too little
};

/// Moves the UVs of a map without flipped faces to where the objective is less, while every seam
/// keeps its rotation and its two sides stay congruent: among all maps with the same cone angles
/// and transitions, towards the least distorted. The circle pattern's own map is conformal in the
/// limit of fine meshes; on the mesh at hand this takes away what its angle fit, which cannot see
/// the finished map, leaves.
///
/// Gauss-Newton: with a complex number z_i per vertex of the opened surface the Beltrami
/// coefficient of a face,
///   mu = sum_i z_i G_i / sum_i z_i conj(G_i),
/// is holomorphic in z, so a step solves one Hermitian system
///   sum A w J* J,   A the faces' areas, w the objective's weight, J = d mu / d z
/// (LowerObjective). Vertices can be held, and those of a boundary can slide along it, which is no
/// Hermitian condition: then the system is a real one.
/// The image keeps its area (OpenedMap::WriteTo), and stays injective where it shall: a step by which
/// it would not is shortened. Faces of no area take no part, but stay as they
/// are oriented.
///
/// Errors: cancelled.
StatusOr<MapRefinement> RefineMap(const SeamedSurface& of, const MapObjective& objective,
                                  const RefineMapOptions& options,
                                  const std::atomic<bool>* cancelled, CornerUv* uv);

/// How to lower a stretch energy: further from where a circle pattern begins than conformal energies.
struct RefineStretchOptions {
  int steps = 1000;        ///< the most; a map far from its minimum takes hundreds
  double decrease = 1e-6;  ///< ends when a step lowers the energy by less than this share
  double weight = 0.5;     ///< of area in energies that blend
  /// Of an edge's length: how far the barrier about the boundary of an image that stays injective
  /// reaches at last.
  double least_reach = 0.01;
};

/// By name; `weight` only of energies that blend.
const OptionTable<RefineStretchOptions>& RefineStretchOptionTable(bool blends);

/// The same for an energy of both singular values (StretchEnergies), from angles towards lengths and
/// areas: the same seams, rotations and exact orientation, steps by StretchSystem. The surface's unit
/// is the best for the map as it comes (BestUnit), from which the image may grow and shrink; before
/// and after are the energies in the best unit of each. The image keeps its area. One that is to stay
/// injective does by a barrier about its boundary (Fence), which reaches less and less far, and by the
/// exact verdict on every step.
StatusOr<MapRefinement> RefineStretch(const SeamedSurface& of, StretchEnergy energy,
                                      const RefineStretchOptions& options,
                                      const std::atomic<bool>* cancelled, CornerUv* uv);

}  // namespace cirque
