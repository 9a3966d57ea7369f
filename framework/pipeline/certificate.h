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

  /// Radians unless the name says otherwise:
  ///   smallest_angle, smallest_theta, epsilon     of the coherent angles, and the margin asked for
  ///   triangle_sum_residual, vertex_sum_residual  of the coherent angles
  ///   angle_primal, angle_dual, angle_gap         objective of the angle fit, its dual, relative
  ///   gap radii_gradient                              max |dS/drho| radii_primal, radii_dual,
  ///   radii_gap         circle-pattern energy, its dual, relative gap log_radius_range max rho -
  ///   min rho layout_closure                              relative, over all edges
  ///   flipped_triangles                           count, exact
  ///   quasi_conformal_mean, quasi_conformal_max, log_area_ratio_l2, log_area_ratio_min,
  ///   log_area_ratio_max angle_iterations, angle_factorizations, radii_iterations,
  ///   radii_factorizations
  std::map<std::string, double> values;
  std::map<std::string, double> seconds;  ///< wall time by stage

  /// With outcome infeasible. Vertices and faces are numbered as in the input file, from 0.
  InfeasibilityProof infeasibility;

  /// All of it, NaN and infinity as null.
  std::string ToJson() const;
};

}  // namespace cirque
