#pragma once

#include <array>
#include <memory>
#include <string>

#include "cirque/core/enum_words.h"
#include "cirque/core/option_table.h"
#include "cirque/core/status.h"

namespace cirque {

class AngleObjective;
class ConeHeuristic;
class CutHeuristic;

/// What makes the surface flat: the circle pattern of coherent angles, or discrete conformal
/// equivalence, scales at the vertices with Ptolemy flips.
enum class PatternKind { kCircle, kEquivalence };

template <>
inline constexpr auto kEnumWords<PatternKind> = std::to_array<EnumWord<PatternKind>>(
    {{PatternKind::kCircle, "circle"}, {PatternKind::kEquivalence, "equivalence"}});

/// What the angles and radii are solved on: the surface's metric after intrinsic Delaunay flips, or
/// the input's connectivity.
enum class SolvedTriangulation { kDelaunay, kInput };

template <>
inline constexpr auto kEnumWords<SolvedTriangulation> =
    std::to_array<EnumWord<SolvedTriangulation>>({{SolvedTriangulation::kDelaunay, "delaunay"},
                                                  {SolvedTriangulation::kInput, "input"}});

/// How flat triangles are placed: one after the other by their edges' directions, or all at once
/// by least squares (Poisson).
enum class LayoutMethod { kDirections, kLeastSquares };

template <>
inline constexpr auto kEnumWords<LayoutMethod> = std::to_array<EnumWord<LayoutMethod>>(
    {{LayoutMethod::kDirections, "directions"}, {LayoutMethod::kLeastSquares, "least_squares"}});

/// kRigid: the two sides of a cut stay congruent, the metric is flat but for the cones. kFree:
/// cones only choose the cut, and the surface opened along it gets a free boundary. kAuto: free
/// along a cut that is given where neither targets nor cones are, rigid otherwise.
enum class SeamKind { kAuto, kRigid, kFree };

template <>
inline constexpr auto kEnumWords<SeamKind> = std::to_array<EnumWord<SeamKind>>(
    {{SeamKind::kAuto, "auto"}, {SeamKind::kRigid, "rigid"}, {SeamKind::kFree, "free"}});

/// Along every loop of the flat metric directions turn. kFree: by what comes. kHalves, kThirds: by a
/// multiple of pi/2, pi/3, so that a map of the surface is seamless but for such rotations and
/// translations: cones have angles of such multiples and are moved to where the rotations are near
/// multiples (PlaceSeamlessCones), and the angles make them exact (CloseRotations).
enum class HolonomyRule { kFree, kHalves, kThirds };

template <>
inline constexpr auto kEnumWords<HolonomyRule> =
    std::to_array<EnumWord<HolonomyRule>>({{HolonomyRule::kFree, "free"},
                                           {HolonomyRule::kHalves, "pi/2"},
                                           {HolonomyRule::kThirds, "pi/3"}});

/// How to parameterize. ParameterizeOptionTable() has a line for every field but the last four, by
/// which it is a flag of circle_patterns and a key of an experiment config.
struct ParameterizeOptions {
  PatternKind pattern = PatternKind::kCircle;
  SolvedTriangulation triangulation = SolvedTriangulation::kDelaunay;
  int retriangulate = 0;                    ///< rounds of flips of active edges (Retriangulate)
  std::string angle_objective = "entropy";  ///< a name of AngleObjectives()
  std::string angle_solver = "auto";        ///< as MakeAngleSolver takes it
  std::string radii_solver = "auto";        ///< as MakeSolverStrategy takes it, for the log radii
  LayoutMethod layout = LayoutMethod::kDirections;
  /// A name of ConeHeuristics(), with options as in "greedy:target=0.1"; empty: DefaultTargets,
  /// which are no cones with a boundary. For targets that are not given otherwise.
  std::string cones;
  int cone_budget = -1;              ///< the heuristic's option `cones`; -1: its own default
  std::string cone_angles = "free";  ///< "free", "pi/2", "pi/3", "ranges" or "ranges:width=RADIANS"
  HolonomyRule holonomy = HolonomyRule::kFree;
  int integer_cells = 0;  ///< of a lattice that the map is brought onto (MoveOntoLattice); 0: none
  /// "free": the angle fit chooses the boundary's angle sums; or one of BoundaryShapes(), with
  /// options as in "least_area:share=0.25".
  std::string boundary = "free";
  int refine_cones = 0;  ///< steps that lower the realised area distortion by the cones' angles
  /// How the finished map is refined: "auto" where that is worth its time (RefineByPatches), a name
  /// of MapObjectives() (RefineMap) or StretchEnergies() (RefineStretch), all with options as in
  /// "mips:steps=5", or "none".
  std::string refine_map = "auto";
  SeamKind seams = SeamKind::kAuto;
  /// What a cut shall be short in: a name of CutHeuristics(), with options as in
  /// "visibility:directions=64".
  std::string cut_cost = "flat_length";
  std::string edge_costs;    ///< a file of factors on that (cuts/edge_files.h); empty: none
  int least_charts = 0;      ///< disks that the cut leaves at least (PartIntoCharts); 0: one
  double epsilon = 1e-3;     ///< least corner and intersection angle [rad]; shrinks where it must
  int max_iterations = 100;  ///< of each solve
  /// Surfaces of more faces are decimated to about so many for the solve, and the map is carried back
  /// (MapDecimated); 0: none is.
  int solve_at = 0;
  /// The most faces that the overlay of an exact map may have.
  int exact_limit = 20000000;
  /// Whether an image that overlaps itself is made injective (MakeInjective), at the price of
  /// distortion or of seams.
  bool injective = false;
  bool strict = false;  ///< no other road where this one leads to no map (pipeline/ladder.h)
  /// Whether Parameterization::exact_map is made too: the map that is linear on the triangles that
  /// it was solved on, on their overlay with the input's.
  bool exact = false;
  /// A caller's own, used where `angle_objective`, `cones` and `cut_cost` would else be looked up;
  /// null: none.
  std::shared_ptr<const AngleObjective> own_objective = {};
  std::shared_ptr<const ConeHeuristic> own_cones = {};
  std::shared_ptr<const CutHeuristic> own_cut = {};

  bool AsksForCones() const { return !cones.empty() || own_cones; }
};

/// The table of its fields: names, bounds, meaning, group.
const OptionTable<ParameterizeOptions>& ParameterizeOptionTable();

/// Whether a surface could be parameterized with these options, as far as can be said without one:
/// every field may have its value, names with options of their own included, and those that depend
/// on each other go together. Errors (invalid input): the message names field, value and bound.
Status CheckOptions(const ParameterizeOptions& options);

/// The objective of the angle fit: the caller's own, or that of the name. Error: no such name.
StatusOr<std::shared_ptr<const AngleObjective>> AngleObjectiveOf(
    const ParameterizeOptions& options);

}  // namespace cirque
