// Independent checker of UV maps and of infeasibility certificates.
#include <algorithm>
#include <cstdio>
#include <optional>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gflags/gflags.h>

#include "cirque/core/atomic_file.h"
#include "cirque/core/count.h"
#include "cirque/core/text.h"
#include "cirque/io/io.h"
#include "cirque/metrics/measure_files.h"
#include "cirque/verify/infeasibility_check.h"
#include "cirque/verify/map_check.h"
#include "cirque/verify/refinement_check.h"
#include "cirque/verify/sphere_check.h"

#include "experiments/common/flag_parsing.h"
#include "experiments/common/judged_measures.h"
#include "experiments/common/manual.h"
#include "experiments/common/program.h"

DEFINE_string(json, "", "write the report as JSON too; without FILE, instead of the text");
DEFINE_string(
    measures, "",
    "files of distortion measures, a comma between: .csv (per triangle), .json (per map), "
    ".ply or .ply:MEASURE (colours on IN)");
DEFINE_string(
    targets, "",
    "angle sums that are asked for: a file of one a vertex of IN [rad], or 'free', or of "
    "cones as circle_patterns' -iv takes it, 2 pi at all other inner vertices. A map that "
    "misses one is invalid; a certificate must prove that these cannot be met, and "
    "without a file that 2 pi at inner vertices cannot");
DEFINE_string(infeasible, "", "infeasibility certificate to check against the one mesh given");
DEFINE_double(position_tolerance, 1e-6,
              "how far a vertex may be off, as a fraction of the bounding box's diagonal");
DEFINE_double(angle_tolerance, 1e-6, "how far an angle sum may be off 2 pi or its target [rad]");
DEFINE_double(seam_tolerance, 1e-6,
              "how far the lengths of a seam's two sides may differ, relatively");
DEFINE_string(domain, "plane",
              "plane: OUT's texture coordinates; disk: with their boundary on the unit circle, in "
              "order; round_holes: and those of holes on circles; sphere: OUT's points");
DEFINE_double(circle_tolerance, 1e-14, "how far a boundary vertex may be off the unit circle");
DEFINE_bool(require_injective, false, "a map that overlaps itself is invalid");
DEFINE_bool(require_rigid_seams, false, "a seam whose two sides differ in length is invalid");
DEFINE_string(
    require_seams, "",
    "file of edges, 'from to' or 'from to face' a line, numbers from 1: a map whose seams "
    "are others is invalid");
DEFINE_int32(require_seam_rotations, 0,
             "a seam whose sides are turned against each other by no multiple of 2 pi / N is "
             "invalid (4: seamless grids); 0: any will do");
DEFINE_int32(max_patches, -1, "a map of more patches than this is invalid; -1: any number will do");
DEFINE_int32(max_seam_edges, -1, "a map with more seam edges than this is invalid; -1: any number");
DEFINE_bool(exact, false,
            "OUT is an .obj that circle_patterns --exact wrote: judged as a refinement of IN, its "
            "groups face_N being parts of IN's faces, then as the map of itself; with "
            "--domain=sphere OUT's texture coordinates say where its points lie on IN");
DEFINE_double(radius_tolerance, 1e-12, "sphere: how far a point may be off the unit sphere");

namespace cirque::verify {
namespace {

constexpr char kSource[] = "experiments/verify_map/";
constexpr int kValid = 0, kInvalid = 1, kBadInput = 2;
/// The proof is right, no solution exists, but for targets that the certificate names itself.
constexpr int kInfeasibleForOwnTargets = 3;

Manual ProgramManual() {
  return {
      "verify_map",
      "checks a UV map, or the certificate that there is none, independently of what made it",
      {{"IN OUT", "is OUT, a mesh with texture coordinates, a valid map of the mesh IN?"},
       {"--domain=sphere IN OUT", "are OUT's points a valid map of IN to the unit sphere?"},
       {"--exact IN OUT", "is OUT, a refinement of IN with texture coordinates, a valid map?"},
       {"--infeasible CERT IN", "does the certificate prove that IN has no coherent angles?"}},
      {"Faces are found by their corners: OUT may be renumbered, split at seams, scaled and "
       "shifted. "
       "The verdict shares no code with what made the map."},
      {{"0", "valid map or accepted certificate"},
       {"1", "invalid or rejected"},
       {"2", "bad input"},
       {"3", "a certificate that holds for targets of its own only, not for those asked about"}}};
}

/// The limit that a flag sets; -1 is none.
std::optional<Index> Limit(int flag) { return flag == -1 ? std::nullopt : std::optional(flag); }

int Complain(const Status& status) {
  fmt::print(stderr, "verify_map: {}\n", status.message());
  return kBadInput;
}

/// Prints or writes a report, and says by the exit status how it ended.
template <class Report>
int Conclude(const Report& report, int status) {
  if (FLAGS_json == "-") {
    fmt::print("{}", ToJson(report));
  } else {
    fmt::print("{}", ToText(report));
    if (!FLAGS_json.empty()) {
      const Status written = WriteFileAtomically(FLAGS_json, ToJson(report));
      if (!written.ok()) return Complain(written);
    }
  }
  return status;
}

Status ReadTargetsIfGiven(const PolygonSoup& in, AngleTargets* targets) {
  if (FLAGS_targets.empty()) return Status();
  StatusOr<AngleTargets> given = ReadTargets(FLAGS_targets, static_cast<Index>(in.position.size()));
  if (given.ok()) *targets = *std::move(given);
  return given.status();
}

/// Reads a mesh, saying what was passed over.
StatusOr<PolygonSoup> Read(const std::string& path) {
  StatusOr<PolygonSoup> soup = ReadMesh(path);
  if (!soup.ok()) return soup;
  for (const std::string& warning : soup->warnings) fmt::print(stderr, "warning: {}\n", warning);
  return soup;
}

int VerifyInfeasibility(const std::vector<std::string>& files) {
  const StatusOr<InfeasibilityCertificate> certificate =
      ReadInfeasibilityCertificate(FLAGS_infeasible);
  if (!certificate.ok()) return Complain(certificate.status());
  const StatusOr<PolygonSoup> in = Read(files[0]);
  if (!in.ok()) return Complain(in.status());
  AngleTargets targets = DefaultTargets();
  if (Status s = ReadTargetsIfGiven(*in, &targets); !s.ok()) return Complain(s);
  const StatusOr<InfeasibilityReport> report = CheckInfeasibility(*certificate, *in, targets);
  if (!report.ok()) return Complain(report.status());
  if (!report->accepted()) return Conclude(*report, kInvalid);
  return Conclude(*report, report->proves_asked ? kValid : kInfeasibleForOwnTargets);
}

/// Adds the distortion measures to the report and writes them to the files asked for; nothing where
/// an error left nothing to measure.
Status Measure(const std::vector<MeasureFile>& files, const PolygonSoup& in, MapReport* report) {
  if (!report->complex) return Status();
  const bool injective = report->overlap && !report->overlap->overlaps();
  const MapMeasures measures = MeasureComplex(*report->complex, in.position, injective);
  report->quality = ToQualityFigures(measures);
  Index& worst = report->quality->worst_triangle;
  if (worst != kNone) worst = report->complex->mesh().face[worst];
  if (files.empty()) return Status();
  std::vector<Index> corners = report->complex->mesh().vertex;
  for (Index& v : corners) v = report->complex->mesh().Origin(v);
  return WriteMeasureFiles(files, in.position, corners, measures);
}

int VerifyOnSphere(const PolygonSoup& in, const PolygonSoup& out) {
  const StatusOr<SphereReport> report = VerifySphereMap(in, out, {FLAGS_radius_tolerance});
  if (!report.ok()) return Complain(report.status());
  return Conclude(*report, report->valid() ? kValid : kInvalid);
}

StatusOr<VerifyOptions> OptionsOfFlags(const PolygonSoup& in) {
  VerifyOptions options;
  options.position_tolerance = FLAGS_position_tolerance;
  options.angle_tolerance = FLAGS_angle_tolerance;
  options.round_holes = FLAGS_domain == "round_holes";
  options.unit_disk = options.round_holes || FLAGS_domain == "disk";
  options.circle_tolerance = FLAGS_circle_tolerance;
  options.require_injective = FLAGS_require_injective;
  options.seams.tolerance = FLAGS_seam_tolerance;
  options.seams.rigid = FLAGS_require_rigid_seams;
  options.seams.rotation_order = FLAGS_require_seam_rotations;
  options.seams.max_patches = Limit(FLAGS_max_patches);
  options.seams.max_edges = Limit(FLAGS_max_seam_edges);
  if (!FLAGS_require_seams.empty()) {
    auto edges = ReadEdges(FLAGS_require_seams, static_cast<Index>(in.position.size()));
    if (!edges.ok()) return edges.status();
    options.seams.edges = *std::move(edges);
  }
  if (Status s = ReadTargetsIfGiven(in, &options.targets); !s.ok()) return s;
  return options;
}

/// Puts what was found of the refinement before what was found of its map.
template <class Report>
int ConcludeExact(const RefinementReport& refinement, Report* report) {
  report->errors.insert(report->errors.begin(), refinement.errors.begin(), refinement.errors.end());
  if (FLAGS_json != "-") fmt::print("{}", ToText(refinement));
  return Conclude(*report, report->valid() ? kValid : kInvalid);
}

/// That of a map to the sphere, whose texture coordinates say where its points lie on IN.
int VerifyExactOnSphere(const PolygonSoup& in, const MeshFile& out,
                        const std::vector<Index>& groups) {
  const auto on_in = ReadTextureInSpace(out.text, out.soup);
  if (!on_in.ok()) return Complain(on_in.status());
  PolygonSoup refined = out.soup;
  refined.texture.clear();
  refined.corner_texture.clear();
  PolygonSoup on_sphere = refined;
  refined.position = *on_in;
  const StatusOr<RefinementReport> refinement = CheckRefinement(in, refined, groups);
  if (!refinement.ok()) return Complain(refinement.status());
  StatusOr<SphereReport> report = VerifySphereMap(refined, on_sphere, {FLAGS_radius_tolerance});
  if (!report.ok()) return Complain(report.status());
  return ConcludeExact(*refinement, &*report);
}

/// A map of a refinement of IN: whether it refines it, and whether it is a map.
int VerifyExact(const std::vector<std::string>& files) {
  const StatusOr<PolygonSoup> in = Read(files[0]);
  if (!in.ok()) return Complain(in.status());
  const StatusOr<MeshFile> out = ReadMeshFile(files[1]);
  if (!out.ok()) return Complain(out.status());
  const StatusOr<std::vector<Index>> groups = ReadGroups(out->text);
  if (!groups.ok()) return Complain(groups.status().In(files[1]));
  if (FLAGS_domain == "sphere") return VerifyExactOnSphere(*in, *out, *groups);
  const StatusOr<RefinementReport> refinement = CheckRefinement(*in, out->soup, *groups);
  if (!refinement.ok()) return Complain(refinement.status().In(files[1]));
  PolygonSoup refined = out->soup;
  refined.texture.clear();
  refined.corner_texture.clear();
  const StatusOr<VerifyOptions> options = OptionsOfFlags(refined);
  if (!options.ok()) return Complain(options.status());
  StatusOr<MapReport> report = VerifyMap(refined, out->soup, *options);
  if (!report.ok()) return Complain(report.status());
  return ConcludeExact(*refinement, &*report);
}

int VerifyFiles(const std::vector<std::string>& files) {
  const StatusOr<PolygonSoup> in = Read(files[0]);
  if (!in.ok()) return Complain(in.status());
  const StatusOr<PolygonSoup> out = Read(files[1]);
  if (!out.ok()) return Complain(out.status());
  if (FLAGS_domain == "sphere") return VerifyOnSphere(*in, *out);
  const StatusOr<VerifyOptions> options = OptionsOfFlags(*in);
  if (!options.ok()) return Complain(options.status());
  const StatusOr<std::vector<MeasureFile>> measures = ParseMeasureFiles(FLAGS_measures);
  if (!measures.ok()) return Complain(measures.status().In("--measures"));
  StatusOr<MapReport> report = VerifyMap(*in, *out, *options);
  if (!report.ok()) return Complain(report.status());
  if (Status s = Measure(*measures, *in, &*report); !s.ok()) return Complain(s);
  return Conclude(*report, report->valid() ? kValid : kInvalid);
}

int Main(int argc, char** argv) {
  CommandLine line = GflagsOf(kSource, {"json"});
  const StatusOr<std::vector<std::string>> files = line.Parse({argv + 1, argv + argc});
  if (!files.ok()) return Complain(files.status());
  if (const auto answered = AnswerQuestions(ProgramManual(), line, *files)) return *answered;
  const std::vector<std::string> domains = {"plane", "disk", "round_holes", "sphere"};
  if (std::find(domains.begin(), domains.end(), FLAGS_domain) == domains.end()) {
    return Complain(Status::InvalidInput(UnknownName("domain", FLAGS_domain, domains)));
  }
  if (!(FLAGS_radius_tolerance >= 0)) {
    return Complain(Status::InvalidInput("radius_tolerance: a number >= 0 is needed"));
  }
  const bool certificate = !FLAGS_infeasible.empty();
  if (files->size() != (certificate ? 1u : 2u)) {
    return Complain(Status::InvalidInput(
        fmt::format("{} given; write verify_map IN OUT, or verify_map --infeasible CERT IN",
                    Count(files->size(), "file"))));
  }
  if (certificate) return VerifyInfeasibility(*files);
  return FLAGS_exact ? VerifyExact(*files) : VerifyFiles(*files);
}

}  // namespace
}  // namespace cirque::verify

int main(int argc, char** argv) {
  return cirque::RunMain("verify_map", argc, argv, cirque::verify::Main);
}
