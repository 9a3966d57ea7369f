#pragma once

#include <optional>
#include <string>
#include <vector>

#include "cirque/core/solve_summary.h"
#include "cirque/core/types.h"

namespace cirque {

// What the stages of a run tell of themselves, as plain numbers. A member is called what it is
// called in certificates and records; CertificateFields (certificate_fields.h) says what it means
// and in which unit. Angles are in radians, lengths relative, vertices numbered as in the input
// file from 0. What a run did not come to is absent.

/// Flips to the intrinsic triangulation where it was solved, and back.
struct TriangulationSummary {
  int flips = 0;
  std::optional<int> delaunay_rounds, flipped_in_chart, moved_vertices, flip_back_stuck;
};

/// The last solve for coherent angles.
struct AngleFitSummary {
  double smallest_angle = kUnset, smallest_theta = kUnset, epsilon = kUnset;
  double triangle_sum_residual = kUnset, vertex_sum_residual = kUnset;
  double angle_primal = kUnset, angle_dual = kUnset, angle_gap = kUnset;
  int angle_iterations = 0, angle_factorizations = 0, angle_cg_iterations = 0;
  std::optional<int> angle_fit_retried;
  std::string solver;  ///< where it was chosen automatically with the reason
  /// max |gradient| at the start and after every iteration, NaN where the solver did not need it
  std::vector<double> gradients;
};

/// The last solve for log radii.
struct RadiiSummary {
  double radii_gradient = kUnset, radii_primal = kUnset, radii_dual = kUnset, radii_gap = kUnset;
  int radii_iterations = 0, radii_factorizations = 0, radii_cg_iterations = 0;
  double log_radius_range = kUnset;
  std::string solver;  ///< as that of the angle fit
  std::vector<double> gradients;
};

/// Cones that were infeasible, and what became of them (RepairCones).
struct ConeRepairSummary {
  int cone_repairs = 0, cones_moved = 0, cones_widened = 0;
};

/// Cones by a heuristic with a number that was asked for and was too small for Gauss-Bonnet, or for
/// angles that are multiples.
struct ConeBudgetSummary {
  int cones_asked = 0, cones_needed = 0;
};

/// A rung of the ladder (pipeline/ladder.h) that was tried.
struct RungSummary {
  std::string rung;     ///< its name; of the road that was asked for "as_asked"
  std::string outcome;  ///< as of a certificate
  std::string message;  ///< why, when that is not ok
};

/// The ladder, where the road that was asked for led to no map.
struct LadderSummary {
  std::vector<RungSummary> tried;  ///< in order, first the road that was asked for
  int rungs_tried = 0;             ///< without that
  std::string made_with;           ///< what the map that came out was made with; empty: as asked
  std::string since;               ///< why it was not made as asked
};

/// RefineCones.
struct ConeRefinementSummary {
  int refinement_steps = 0, refinement_solves = 0;
  double refinement_area_distortion_before = kUnset, refinement_area_distortion_after = kUnset;
};

/// Cut and layout.
struct LayoutSummary {
  double layout_closure = kUnset;
  int flipped_triangles = 0;
  std::optional<int> cones, patches, rotation_order;
  std::optional<double> cut_length;
  /// Triangles that are flipped or have no area for who reads the coordinates as floats.
  std::optional<int> float32_vanishing_triangles;
};

/// The seams of a layout (MeasureSeams).
struct SeamSummary {
  int seams = 0;
  double seam_length_mismatch = 0, seam_rotation_mismatch = 0, seam_gap = 0;
  double cone_rotation_mismatch = 0;
};

/// RefineByPatches, or RefineMap, which has no patches.
struct MapRefinementSummary {
  std::optional<int> map_refinement_flagged, map_refinement_patches, map_refinement_rounds;
  std::optional<int> map_refinement_patch_steps;
  int map_refinement_steps = 0;  ///< on the whole map
  double map_refinement_before = kUnset, map_refinement_after = kUnset;
};

/// Figures of the map (metrics/registry.h).
struct DistortionSummary {
  double quasi_conformal_mean = kUnset, quasi_conformal_max = kUnset;
  double log_area_ratio_l2 = kUnset, log_area_ratio_min = kUnset, log_area_ratio_max = kUnset;
};

/// A map to the sphere.
struct SphereSummary {
  Index pole_vertex = kNone;
  int pole_corners = 0, pole_attempts = 0;
  double link_margin = kUnset;
  std::optional<double> delaunay_margin, normalization_residual, centre_of_mass, degree;
  std::optional<int> normalization_iterations;
  std::optional<double> angle_distortion_mean, angle_distortion_max;
};

/// A map to the unit disk; kNone: no vertex was asked for or chosen.
struct DiskSummary {
  Index pole_vertex = kNone, centre_vertex = kNone, angle_zero_vertex = kNone;
  int overhanging_faces = 0;
  double boundary_spread = 0, boundary_straightness = kUnset, boundary_circle_error = kUnset;
  double boundary_centre_of_mass = kUnset, area_centre_of_mass = kUnset;
  std::optional<double> centre_error;
  double core_quasi_conformal_mean = kUnset, core_quasi_conformal_max = kUnset;
};

/// A map to the upper half-plane.
struct HalfPlaneSummary {
  Index pole_vertex = kNone;
  double pole_height = kUnset, boundary_straightness = kUnset;
};

/// A map to a polygon.
struct PolygonSummary {
  std::vector<Index> corner_vertices;  ///< corner_vertex_0, corner_vertex_1, ... in certificates
  double shortest_side = kUnset, longest_side = kUnset;
  std::optional<double> conformal_modulus, opposite_side_mismatch;
};

/// The process that ran it.
struct ProcessSummary {
  std::optional<double> peak_memory_mib;
};

/// Wall time by stage [s].
struct StageSeconds {
  std::optional<double> read, preflight, subdivide, pole, corners, cones, triangulation, angles,
      radii;
  std::optional<double> refine_cones, layout, measures, write, total, process;
};

}  // namespace cirque
