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

/// Flips for the sake of the angle fit (Retriangulate).
struct RetriangulationSummary {
  int retriangulation_rounds = 0, retriangulation_flips = 0;
  int active_edges_before = 0, active_edges_after = 0;
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

/// What the flat metric turns directions by along its loops (MeasureRotations). The values are those of
/// the loops around handles, two a handle, then of those around boundary loops but the first, which
/// Gauss-Bonnet settles.
struct RotationSummary {
  std::vector<double> rotations;  ///< [rad]; rotation_0, rotation_1, ... in certificates
  double rotation_miss_halves = 0,
         rotation_miss_thirds = 0;  ///< the largest distances to multiples
  /// Of the handles' loops, and of the boundary loops.
  int handle_rotations = 0, boundary_rotations = 0;
  /// [rad] between directions along boundary loops: of the first and each other, along paths.
  std::vector<double> boundary_turns;  ///< boundary_turn_0, ... in certificates
};

/// Cones and angles that make the rotations multiples (ParameterizeOptions::holonomy).
struct HolonomySummary {
  double holonomy_miss = kUnset;         ///< the largest distance to the multiples asked for
  double holonomy_miss_before = kUnset;  ///< the same before the angles closed it
  double holonomy_angle_change = 0;      ///< [rad] the largest by that
  int holonomy_steps = 0;                ///< of that
  int holonomy_loop = -1;                ///< that misses most, as in rotation_0, ...
  std::optional<int> holonomy_rounds, holonomy_moves;  ///< fits and moves of cones
  std::optional<double> holonomy_miss_start;           ///< of the cones before they were moved
};

/// Rotations that were asked for along loops (PrescribedRotations).
struct LoopsSummary {
  std::vector<double> rotations;  ///< [rad] of the map; loop_rotation_0, ... in certificates
  std::vector<double> misses;     ///< [rad] asked for less that, modulo 2 pi; loop_miss_0, ...
  double loop_miss = 0;           ///< [rad] the largest of these, without its sign
  int loop_that_misses = -1;      ///< whose that is; -1: there is no loop
  int loops_to_meet = 0;          ///< 1: they were to be met
  std::optional<double> loop_miss_before,
      loop_angle_change;          ///< [rad] of the angles that meet them
  std::optional<int> loop_steps;  ///< of these
};

/// The last solve for log scales, where conformal equivalence makes the surface flat.
struct EquivalenceSummary {
  double scales_residual = kUnset, log_scale_range = kUnset;
  int scales_iterations = 0, scales_factorizations = 0, scales_cg_iterations = 0;
  int ptolemy_flips = 0;
  int doubled = 0;     ///< 1: solved on the surface and its mirror image
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

/// Cones of a file whose digits miss Gauss-Bonnet, made exact (ConeFileRounding).
struct ConeRoundingSummary {
  int cones_rounded = 0;
  double cone_sum_missed = 0, cone_rounding_largest = 0;
};

/// A rung of the ladder (pipeline/ladder.h) that was tried.
struct RungSummary {
  std::string rung;     ///< its name; of the road that was asked for "as_asked"
  std::string outcome;  ///< as of a certificate
  std::string message;  ///< why, when that is not ok
  double seconds = 0;   ///< [s] wall time
};

/// The ladder, where the road that was asked for led to no map.
struct LadderSummary {
  std::vector<RungSummary> tried;  ///< in order, first the road that was asked for
  int rungs_tried = 0;             ///< without that
  std::string made_with;           ///< what the map that came out was made with; empty: as asked
  std::string since;               ///< why it was not made as asked
};

/// A boundary of a shape that was asked for (FlattenWithBoundary).
struct BoundarySummary {
  int boundary_vertices = 0, boundary_at_bounds = 0;
  double boundary_range = 0;  ///< [rad] that angle sums could differ by from those predicted
  /// RefineBoundary
  std::optional<int> boundary_steps, boundary_solves, boundary_overlaps_avoided;
  std::optional<double> boundary_log_scale_before, boundary_log_scale_after;
};

/// What made the image injective, where that was asked for and it overlapped itself (MakeInjective).
struct InjectivitySummary {
  std::vector<RungSummary> tried;  ///< in order, until one held
  std::string made_by;             ///< what the injective image was made by; empty: none is
  int injectivity_stages = 0;      ///< tried
  int charts = 1;
  std::optional<double> boundary_turned;  ///< [rad] largest change of a boundary vertex's angle sum
  /// DescendToInjective
  std::optional<int> descent_steps;
  std::optional<double> descent_before, descent_after;
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
  std::optional<double> cut_length, visible_cut_length;
  std::optional<double> area_used;  ///< of the bounding square of all that is written
  std::optional<int> origins;       ///< where one does not do (LayOutAboutSeveralOrigins)
  std::optional<int> cuts_tried;    ///< that led to maps, of which this is the fullest
  std::optional<int> given_cut_edges, further_cut_edges;  ///< where a cut was given
  /// Triangles that are flipped or have no area for who reads the coordinates as floats.
  std::optional<int> float32_vanishing_triangles;
};

/// The seams of a layout (MeasureSeams).
struct SeamSummary {
  int seams = 0;
  double seam_length_mismatch = 0, seam_rotation_mismatch = 0, seam_gap = 0;
  double cone_rotation_mismatch = 0;
};

/// A map brought onto a lattice (MoveOntoLattice).
struct IntegerSummary {
  int integer_cells = 0;  ///< of the lattice, asked for
  std::optional<double>
      integer_gap;  ///< cells: of cones from its points, translations from its vectors
  std::optional<double> integer_shift;  ///< cells: by which a corner was moved, at most
  std::string integer_obstacle;         ///< why it is not there; empty: it is
};

/// A map of a decimated surface, carried back to the surface itself (UndoCollapses).
struct DecimatedSolveSummary {
  Index solved_faces = 0;  ///< of the decimated surface
  Index collapses = 0;     ///< undone, one vertex each
  Index retreats = 0;      ///< vertices whose own best place was none without flips
};

/// RefineByPatches, or RefineMap, which has no patches.
struct MapRefinementSummary {
  std::optional<int> map_refinement_flagged, map_refinement_patches, map_refinement_rounds;
  std::optional<int> map_refinement_patch_steps;
  int map_refinement_steps = 0;  ///< on the whole map
  double map_refinement_before = kUnset, map_refinement_after = kUnset;
  std::optional<int> map_refinement_at_rest;       ///< of RefineMap
  std::optional<int> map_refinement_convex_start;  ///< 1: it began at EmbedInDisk
};

/// An exact map (MakeExactMap). The distortion is that of the triangles it was solved on, of
/// conformal equivalence that of its own.
struct ExactMapSummary {
  int exact_triangles = 0, exact_crossings = 0;
  double exact_faces_ratio = kUnset;  ///< faces of the overlay for one of the input
  int exact_faces_worst = 0;          ///< of the overlay in one of the input
  int exact_edges_spread = 0;
  double exact_largest_shift = 0;
  double exact_quasi_conformal_mean = kUnset, exact_quasi_conformal_max = kUnset;
  double exact_log_area_ratio_l2 = kUnset;
  double exact_layout_closure = kUnset, exact_seam_length_mismatch = kUnset;
  std::optional<int> exact_origins;  ///< where one does not do (LayOutAboutSeveralOrigins)
  /// Its own: of a strip, an annulus, a torus.
  std::optional<double> exact_strip_period, exact_inner_radius, exact_modulus_real,
      exact_modulus_imaginary;
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
  std::optional<int> split_chords;  ///< for the solve
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

/// A map that is periodic: a strip, the annulus that it is wound to, the parallelogram of a torus.
struct PeriodicSummary {
  std::optional<double> annulus_modulus;             ///< height over period, log(R / r) / (2 pi)
  std::optional<double> strip_period;                ///< of a strip of height 1
  std::optional<double> inner_radius, circle_error;  ///< of an annulus of outer radius 1
  std::optional<double> modulus_real,
      modulus_imaginary;            ///< tau of a torus, in the fundamental domain
  double period_mismatch = kUnset;  ///< of seams from their translations before these were exact
};

/// A map to a disk with round holes.
struct RoundHolesSummary {
  int holes = 0, rounds = 0;
  int chords = 0;  ///< edges between two vertices of the outer boundary, split for the solve
  double roundness = kUnset, circle_error = kUnset;
  double smallest_radius = kUnset, largest_radius = kUnset;
};

/// A map of a surface that is its own mirror image, by one half of it (MapMirrored).
struct MirrorSummary {
  Index on_axis = 0, across_axis = 0;  ///< vertices there; edges that lead across it
  double length_mismatch = kUnset;     ///< of edges and their mirror images, relative
};

/// A map whose boundary lies on a curve.
struct CurveSummary {
  Index start_vertex = kNone;  ///< the one at the curve's first point, as in the file, from 0
  int rounds = 0, corners = 0, chords = 0, bend_steps = 0;
  /// Log of the share that an edge has of the boundary as it was solved for, against that of the polygon
  /// on the curve: the largest.
  double length_mismatch = kUnset;
  double shift =
      kUnset;  ///< of a boundary vertex onto the curve, over the root of the curve's area
};

/// A map that is bent to three pins or more (MeetLandmarks). Misses over the square root of the image's
/// area.
struct PinSummary {
  int pins = 0, steps = 0;
  double miss_before = kUnset, miss_after = kUnset;
  double energy_before = kUnset, energy_after = kUnset;
};

/// The part of a mesh file that a certificate is about, where there are several.
struct ComponentSummary {
  Index first_face = kNone;  ///< its first polygon in the file, from 0
  Index faces = 0;           ///< polygons of the file
  Index vertices = 0;
};

/// Components side by side in the plane.
struct AtlasSummary {
  int components = 0, components_failed = 0, atlas_patches = 0;
};

/// The process that ran it.
struct ProcessSummary {
  std::optional<double> peak_memory_mib;
};

/// Wall time by stage [s].
struct StageSeconds {
  std::optional<double> read, preflight, subdivide, decimate, pole, corners, cones, triangulation;
  std::optional<double> angles, radii, scales, rotations, injective, refine_cones, layout, exact;
  std::optional<double> carry_back, measures;
  std::optional<double> write, total, process;
};

}  // namespace cirque
