#pragma once

#include <map>
#include <string>

#include "cirque/core/infeasibility.h"

namespace cirque {

/// The evidence that a run leaves behind. What it did not come to is absent from the maps.
struct Certificate {
  std::string outcome = "not_run";  ///< ToString(StatusCode)
  std::string message;              ///< why, when the outcome is not ok
  std::string overlap = "unknown";  ///< "injective", "boundary_overlaps" or "unknown"

  /// Angles in radians, lengths relative. By stage:
  /// - triangulation: flips, delaunay_rounds, mirrored_triangles (of the input, before the last
  /// round)
  /// - angle fit: smallest_angle, smallest_theta, epsilon (the margin asked for),
  ///   triangle_sum_residual, vertex_sum_residual, angle_primal, angle_dual, angle_gap (relative),
  ///   angle_iterations, angle_factorizations, angle_fit_retried (1: by the interior point)
  /// - radii: radii_gradient (max |dS/drho|), radii_primal, radii_dual, radii_gap (relative),
  ///   radii_iterations, radii_factorizations, log_radius_range (max rho - min rho)
  /// - layout: layout_closure (over all edges), flipped_triangles (exact), cones, patches, seams,
  ///   seam_length_mismatch, seam_rotation_mismatch, seam_gap, cone_rotation_mismatch
  /// - cones: cone_repairs (rounds), cones_moved, cones_widened (RepairCones); refinement_steps,
  ///   refinement_solves, refinement_area_distortion_before, ..._after (RefineCones); cut_length
  ///   (on the surface, over the square root of its area)
  /// - measures: quasi_conformal_mean, quasi_conformal_max, log_area_ratio_l2, log_area_ratio_min,
  ///   log_area_ratio_max
  std::map<std::string, double> values;
  std::map<std::string, double> seconds;  ///< wall time by stage

  /// With outcome infeasible. Vertices and faces are numbered as in the input file, from 0.
  InfeasibilityProof infeasibility;

  /// All of it, NaN and infinity as null.
  std::string ToJson() const;
};

}  // namespace cirque
