#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "cirque/core/infeasibility.h"
#include "cirque/core/solve_summary.h"
#include "cirque/core/status.h"
#include "cirque/mesh/preflight.h"
#include "cirque/mesh/surface.h"
#include "cirque/pipeline/summaries.h"

namespace cirque {

/// What a certificate says of a map's overlap: no point of the plane is covered twice, or some are.
inline constexpr char kInjective[] = "injective";
inline constexpr char kOverlaps[] = "boundary_overlaps";

/// The evidence that a run leaves behind: what its stages tell of themselves. Nothing in it steers
/// the program. docs/certificate.md is its reference.
struct Certificate {
  std::string outcome = "not_run";  ///< ToString(StatusCode), or kInaccurate
  std::string message;              ///< why, when the outcome is not ok
  /// kInjective or kOverlaps, exactly; "unknown" where triangles are flipped
  std::string overlap = "unknown";

  std::optional<TriangulationSummary> triangulation;
  std::optional<RetriangulationSummary> retriangulation;
  std::optional<AngleFitSummary> angle_fit;
  std::optional<RadiiSummary> radii;
  std::optional<EquivalenceSummary> equivalence;
  std::optional<RotationSummary> rotations;
  std::optional<HolonomySummary> holonomy;
  std::optional<LoopsSummary> loops;
  std::optional<ConeBudgetSummary> cone_budget;
  std::optional<ConeRoundingSummary> cone_rounding;
  std::optional<ConeRepairSummary> cone_repair;
  std::optional<LadderSummary> ladder;
  std::optional<BoundarySummary> boundary;
  std::optional<InjectivitySummary> injectivity;
  std::optional<ConeRefinementSummary> cone_refinement;
  std::optional<LayoutSummary> layout;
  std::optional<SeamSummary> seams;
  std::optional<IntegerSummary> integers;
  std::optional<DecimatedSolveSummary> decimated_solve;
  std::optional<MapRefinementSummary> map_refinement;
  std::optional<DistortionSummary> distortion;
  std::optional<ExactMapSummary> exact_map;
  std::optional<SphereSummary> sphere;
  std::optional<DiskSummary> disk;
  std::optional<HalfPlaneSummary> half_plane;
  std::optional<PolygonSummary> polygon;
  std::optional<PeriodicSummary> periodic;
  std::optional<RoundHolesSummary> round_holes;
  std::optional<CurveSummary> curve;
  std::optional<MirrorSummary> mirror;
  std::optional<PinSummary> pins;
  std::optional<AtlasSummary> atlas;
  std::optional<ProcessSummary> process;
  StageSeconds seconds;

  std::optional<RepairSummary> mesh_repair;   ///< where something was done to the mesh
  std::optional<ComponentSummary> component;  ///< of one of several: which
  /// Of a mesh of several components a certificate of each, in the order of their first faces. What
  /// stands beside them then is about all of them (SummarizeComponents).
  std::vector<Certificate> components;

  /// With outcome infeasible. Vertices and faces are numbered as in the input file, from 0.
  InfeasibilityCertificate infeasibility;

  /// All of it, NaN and infinity as null.
  std::string ToJson() const;
};

/// The summary, which is there from now on.
template <class Summary>
Summary& Fill(std::optional<Summary>* summary) {
  return *summary ? **summary : summary->emplace();
}

/// Adds to the time of a stage.
inline void AddSeconds(const Timer& timer, std::optional<double>* seconds) {
  *seconds = seconds->value_or(0) + timer.Seconds();
}

/// The outcome of a map without flips that doubles do not hold to kAccuracy: laid out edges that miss
/// lengths or directions by more, or seams with sides of different length. It is written, not ok. A
/// map to the sphere, disk, half-plane or a polygon that a refinement of the whole brought to rest no
/// longer depends on its layout; beside an exact map one with flipped triangles is not the result.
inline constexpr char kInaccurate[] = "inaccurate";
inline constexpr double kAccuracy = 1e-8;
/// [rad]: rotations that miss the multiples asked for (ParameterizeOptions::holonomy) by more make a map
/// inaccurate, too.
inline constexpr double kRotationAccuracy = 1e-10;

/// What of a layout misses kAccuracy, for people; empty: nothing.
std::string Inaccuracy(const Certificate& certificate);

/// Fills in outcome, message and total time of a run; returns its status.
Status Conclude(const Status& status, const Timer& timer, Certificate* certificate);

/// Renumbers the proof's vertices as the input file has them.
void NumberAsInFile(const Surface& surface, InfeasibilityCertificate* proof);

/// Names the proof's triangles by the file's faces, and its carrying faces too. Of a proof about
/// other triangles than the surface's (finer ones): nothing.
void NameTriangles(const Surface& surface, InfeasibilityCertificate* proof);

/// What a certificate's JSON says of its own form: "schema" and "version" (docs/certificate.md).
inline constexpr char kCertificateSchema[] = "cirque-certificate";
/// Raised whenever a reader of the version before would misread it.
inline constexpr int kCertificateVersion = 1;

/// One number of a certificate.
struct CertificateField {
  std::string name;     ///< in certificates and records; of several summaries at most one has it
  std::string summary;  ///< what it belongs to, for people
  std::string unit;     ///< "rad", "s", "MiB"; empty: none
  std::string meaning;
  std::optional<double> (*value)(const Certificate&);  ///< nothing: the run did not come to it

  std::string Label() const { return unit.empty() ? meaning : meaning + " [" + unit + "]"; }
};

/// The numbers, in the order of the stages, but for the families corner_vertex_0, corner_vertex_1,
/// ..., rotation_0, ... and boundary_turn_0, ...
const std::vector<CertificateField>& CertificateFields();

/// The times of stages, in the order of the stages.
const std::vector<CertificateField>& SecondsFields();

/// All numbers that the certificate holds, by name; NaN where a solver did not need one.
std::map<std::string, double> NumbersOf(const Certificate& certificate);

/// The times that it holds, by stage [s].
std::map<std::string, double> SecondsOf(const Certificate& certificate);

/// The page docs/certificate.md.
std::string CertificateReference();

}  // namespace cirque
