#pragma once

#include <map>
#include <string>
#include <vector>

#include "cirque/core/infeasibility.h"

namespace cirque {

/// The evidence that a run leaves behind. What it did not come to is absent from the maps.
struct Certificate {
  std::string outcome = "not_run";  ///< ToString(StatusCode)
  std::string message;              ///< why, when the outcome is not ok
  /// "injective"; "boundary_touches": no two boundary edges (seams opened) cross, but some touch,
  /// which verify_map can tell from overlaps; "boundary_overlaps"; "unknown"
  std::string overlap = "unknown";

  /// Angles in radians, lengths relative. By stage:
  /// - triangulation: flips, delaunay_rounds, mirrored_triangles (of the input, in the last round),
  ///   moved_vertices (which righted them), flip_back_stuck (flips that the flat metric does not
  ///   let be undone; where asked for)
  /// - angle fit: smallest_angle, smallest_theta, epsilon (the margin asked for),
  ///   triangle_sum_residual, vertex_sum_residual, angle_primal, angle_dual, angle_gap (relative),
  ///   angle_iterations, angle_factorizations, angle_cg_iterations, angle_fit_retried (1: by the
  ///   interior point)
  /// - radii: radii_gradient (max |dS/drho|), radii_primal, radii_dual, radii_gap (relative),
  ///   radii_iterations, radii_factorizations, radii_cg_iterations, log_radius_range (max rho - min
  ///   rho)
  /// - layout: layout_closure (over all edges), flipped_triangles (exact), cones, patches, seams,
  ///   seam_length_mismatch, seam_rotation_mismatch, seam_gap, cone_rotation_mismatch,
  ///   map_refinement_steps, map_refinement_before, ..._after (RefineMap),
  ///   rotation_order (n: the rotations across seams are exact multiples of 2 pi / n; 0: are not)
  /// - cones: cone_repairs (rounds), cones_moved, cones_widened (RepairCones); refinement_steps,
  ///   refinement_solves, refinement_area_distortion_before, ..._after (RefineCones); cut_length
  ///   (on the surface, over the square root of its area)
  /// - measures: quasi_conformal_mean, quasi_conformal_max, log_area_ratio_l2, log_area_ratio_min,
  ///   log_area_ratio_max
  /// - maps to the sphere also: pole (as in the input file, from 0), pole_corners, pole_attempts,
  ///   link_margin (pi minus the largest angle sum allowed at the link) [rad], delaunay_margin (the
  ///   smallest intersection angle of two circles on the sphere, those at the pole included, of the
  ///   triangulation where it was solved) [rad], normalization_iterations, normalization_residual,
  ///   centre_of_mass (its distance from 0), degree, angle_distortion_mean, angle_distortion_max
  ///   (between the flat triangles of the surface and of the image) [rad]; flipped_triangles are
  ///   those of the input on the sphere
  std::map<std::string, double> values;
  std::map<std::string, double> seconds;  ///< wall time by stage
  /// The solver of each stage; where it was chosen automatically with the reason.
  std::map<std::string, std::string> strategies;
  /// max |gradient| of the last solve of a stage ("angles", "radii") at its start and after every
  /// iteration, NaN where the strategy did not need it.
  std::map<std::string, std::vector<double>> history;

  /// With outcome infeasible. Vertices and faces are numbered as in the input file, from 0.
  InfeasibilityCertificate infeasibility;

  /// All of it, NaN and infinity as null.
  std::string ToJson() const;
};

}  // namespace cirque
