#pragma once

#include <vector>

#include "cirque/core/infeasibility.h"
#include "cirque/core/metric.h"
#include "cirque/mesh/holes.h"
#include "cirque/mesh/surface.h"

namespace cirque {

/// A topological disk with the star of a boundary vertex, its pole, taken off.
struct PuncturedDisk {
  std::vector<bool> core;  ///< per face of the surface: on the solved side of every chord
  Index pole = kNone;      ///< vertex of the surface
  /// The core without the pole's faces; empty when the core is one triangle.
  SubTriangulation rest;
  EdgeLengths lengths;       ///< of rest
  ConeTargets targets;       ///< of rest
  std::vector<Index> chain;  ///< vertices of rest along the straight boundary, the surface left
  std::vector<Index> loop;   ///< all boundary vertices of the surface from the pole on, likewise
  std::vector<double> arc;   ///< per entry of loop the share of the boundary up to it
};

/// Takes the pole's faces off the core of a disk. Targets: inner vertices flat, the chain straight
/// (pi), its ends at most (pi - epsilon) / 2, the link between them at most pi - epsilon.
PuncturedDisk TakeOffStar(const Triangulation& whole, const EdgeLengths& lengths,
                          const std::vector<bool>& core, Index pole, double epsilon);

/// Fixes the angle sums along the link too, so that the pole's own triangles keep their shapes:
/// with the pole at infinity their circles are the link's lines, which turn at a vertex by the
/// intersection angle theta of the circles at its edge to the pole, half of it at the ends of the
/// chain, where the mirror image has the other half. Scaled so that the pole's angle sum becomes
/// pi, the angles turn by pi in all. `angles` are those of `whole`.
void KeepStar(const Triangulation& whole, const CornerAngles& angles, double epsilon,
              PuncturedDisk* disk);

/// The proof for disk.rest in the numbers of the input file, its faces those of the whole surface,
/// with the pole as its removed vertex.
void NumberAsInFile(const Surface& surface, const PuncturedDisk& disk,
                    InfeasibilityCertificate* proof);

}  // namespace cirque
