#pragma once

#include "cirque/domains/domain.h"

namespace cirque {

/// The options with which maps to the sphere distort least: the defaults but for angles fitted by
/// their entropy, whose relative changes keep needles and the dense end of a long limb from paying
/// for the rest (results/spheres.md).
ParameterizeOptions SphereParameterizeOptions();

/// Maps the surface to the sphere by a circle pattern: intrinsic Delaunay flips on the closed
/// surface; the pole's star removed, its link free but convex (angle sums at most pi - epsilon, so
/// that the edges at the pole intersect properly too); coherent angles close to those of the
/// surface after an inversion of space about the pole; log radii; layout; stereographic projection;
/// the pole restored; Moebius normalisation. Input triangles that come out flipped on the sphere
/// get their edges locked and everything is solved again, at last on the input's connectivity.
/// Where a pole does not lead to a map, up to three others are tried unless the options name one.
///
/// kInvalidInput: no closed surface of genus 0, no such pole or normalisation; kInfeasible: no
/// coherent angles on the input's connectivity without the pole's star (the certificate holds the
/// proof; by Rivin's theorem no other vertex would do, save for the margin epsilon);
/// kUnrepresentable: limbs too long for doubles on one sphere; kNotConverged.
/// Source of the reduction to the plane: L. Kharevych, thesis (2006), with the link kept convex.
Status MapToSphere(const Surface& surface, const MapRequest& request, const SolveControl& control,
                   SurfaceMap* map);

}  // namespace cirque
