#pragma once

#include <string>
#include <vector>

#include <Eigen/Core>

#include "cirque/core/solve_summary.h"
#include "cirque/core/status.h"
#include "cirque/mesh/surface.h"
#include "cirque/pipeline/certificate.h"
#include "cirque/pipeline/options.h"

namespace cirque {

/// What is particular to maps to the sphere.
struct SphereOptions {
  /// The vertex of the surface that is taken out for the solve in the plane and comes back as
  /// infinity; kNone: chosen (PoleCandidates).
  Index pole = kNone;
  std::string normalization = "surface_area";  ///< a name of SphereNormalizations()
  /// Turns the sphere so that the second moments of the surface's area on it are largest along x
  /// and smallest along z, the third moments along x and y positive. (Symmetric surfaces leave
  /// axes or signs undetermined: rounding then decides, the same way every time.)
  bool principal_axes = false;
  /// Fit the flat angles to those of the surface after an inversion of space about the pole; false:
  /// to the surface's own, which distorts more (for comparisons).
  bool inversion = true;
};

/// A conformal map of a closed surface of genus 0 to the unit sphere.
struct SphereMap {
  Index pole = kNone;                     ///< the vertex that was infinity
  std::vector<Eigen::Vector3d> position;  ///< per vertex of the surface, |x| = 1; empty without map
  Eigen::VectorXd angle_distortion;  ///< per face, its largest change of an angle, chordal [rad]
  Eigen::VectorXd quasi_conformal;   ///< per face, of its flat triangle to the chordal one; 0 where
                                     ///< that has no area
  Certificate certificate;
};

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
Status MapToSphere(const Surface& surface, const SphereOptions& options,
                   const ParameterizeOptions& parameterize_options, const SolveControl& control,
                   SphereMap* map);

}  // namespace cirque
