#pragma once

#include <string>

namespace cirque {

/// How to parameterize. Every field has a flag of circle_patterns and a key of an experiment config
/// by its name.
struct ParameterizeOptions {
  std::string triangulation = "delaunay";  ///< "delaunay": intrinsic Delaunay flips; "input": none
  std::string angle_objective = "quadratic";  ///< a name of AngleObjectives()
  std::string angle_solver = "auto";          ///< a name of AngleSolverNames()
  std::string radii_solver = "auto";          ///< a name of SolverStrategies(), for the log radii
  std::string layout = "directions";          ///< or "least_squares" (Poisson)
  /// A name of ConeHeuristics(), with options as in "greedy:target=0.1"; empty: DefaultTargets,
  /// which are no cones with a boundary. For targets that are not given otherwise.
  std::string cones;
  int cone_budget = -1;              ///< the heuristic's option `cones`; -1: its own default
  std::string cone_angles = "free";  ///< "free", "pi/2", "pi/3", "ranges" or "ranges:width=RADIANS"
  int refine_cones = 0;  ///< steps that lower the realised area distortion by the cones' angles
  /// A name of MapObjectives(), with options as in "mips:steps=5", by which the finished map is
  /// refined (RefineMap), or "none".
  std::string refine_map = "none";
  /// "rigid": the two sides of a cut stay congruent, the metric is flat but for the cones. "free":
  /// cones only choose the cut, and the surface opened along it gets a free boundary.
  std::string seams = "rigid";
  std::string cut_cost =
      "flat_length";         ///< a word of CutCostWords(): what the cut shall be short in
  std::string edge_costs;    ///< a file of factors on that (cuts/edge_cost_file.h); empty: none
  double epsilon = 1e-3;     ///< least corner and intersection angle [rad]; shrinks where it must
  int max_iterations = 100;  ///< of each solve
};

}  // namespace cirque
