#include <algorithm>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "cirque/angles/angle_fit.h"
#include "cirque/core/solve_summary.h"
#include "cirque/core/text.h"
#include "cirque/domains/built_in_domains.h"
#include "cirque/domains/domain.h"
#include "cirque/domains/domain_ladder.h"
#include "cirque/domains/extreme_scale.h"
#include "cirque/domains/map_decimated.h"
#include "cirque/domains/map_mirrored.h"
#include "cirque/domains/pins.h"
#include "cirque/mesh/file_numbers.h"
#include "cirque/pipeline/finish_layout.h"
#include "cirque/pipeline/road_keeper.h"

namespace cirque {
namespace {

constexpr std::size_t kProofBegins = 18;  ///< "no coherent angles"

bool Contains(const std::vector<std::string>& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

/// What would else be ignored, or read beyond the surface's vertices.
Status CheckRequest(const Domain& domain, const MapRequest& request, Index num_vertices) {
  for (const auto& [option, given] :
       {std::pair("targets", request.targets.has_value()),
        std::pair("cut", request.cut.has_value()), std::pair("exact", request.options.exact),
        std::pair("rotations", request.rotations != nullptr),
        std::pair("injective", request.options.injective),
        std::pair("solve_at", request.options.solve_at > 0),
        std::pair("pins", !request.shape.pins.empty()),
        std::pair("symmetric", request.shape.symmetric)}) {
    if (!given || domain.Reads(option)) continue;
    return Status::InvalidInput(fmt::format("the domain {} takes no {}", request.domain, option));
  }
  if (Status s = ParameterizeOptionTable().Validate(request.options); !s.ok()) return s;
  if (LeavesConformal(request.options.refine_map) && !domain.Reads("boundary")) {
    return Status::InvalidInput(fmt::format(
        "refine_map = {} changes lengths and areas by moving the boundary, which the domain {} "
        "prescribes: take the plane, or another refine_map",
        request.options.refine_map, request.domain));
  }
  if (Status s = DomainOptionTable().Validate(request.shape); !s.ok()) return s;
  std::vector<Index> vertices = request.shape.corners;
  for (const Index v : {request.shape.centre, request.shape.angle_zero, request.shape.pole}) {
    if (v != kNone) vertices.push_back(v);
  }
  for (const Index v : vertices) {
    if (v >= 0 && v < num_vertices) continue;
    return Status::InvalidInput(fmt::format("{} is no vertex: there are {}", v, num_vertices));
  }
  return Status();
}

/// On the surface itself or, where it is to be solved by its half or at fewer faces, from there.
Status MapAsAsked(const Domain& domain, const Surface& surface, const MapRequest& request,
                  const SolveControl& control, SurfaceMap* map) {
  if (request.shape.symmetric) return MapMirrored(surface, request, control, map);
  const Index most = request.options.solve_at;
  if (most > 0 && surface.triangulation.num_faces() > most) {
    return MapDecimated(surface, request, control, map);
  }
  return ClimbDomainLadder(domain, surface, request, control, map);
}

/// Maps where squares of lengths are numbers, and back.
Status MapAtSafeScale(const Domain& domain, const Surface& surface, const MapRequest& request,
                      const SolveControl& control, SurfaceMap* map) {
  const int exponent = ExtremeExponent(surface);
  if (exponent == 0) return MapAsAsked(domain, surface, request, control, map);
  Status status = MapAsAsked(domain, Scaled(surface, -exponent), request, control, map);
  // The others' images have a size of their own.
  if (status.ok() && domain.Gives("flat")) ScaleMap(exponent, map);
  return status;
}

}  // namespace

const Registry<Domain>& Domains() {
  static const Registry<Domain> kTable(
      "domain",
      {{"plane",
        {"the plane, opened along a cut through cones where it must be",
         {"targets",    "cut",          "rotations",   "metric",       "pattern",
          "layout",     "cones",        "cone_budget", "cone_angles",  "holonomy",
          "boundary",   "refine_cones", "refine_map",  "seams",        "cut_cost",
          "edge_costs", "exact",        "exact_limit", "strict",       "injective",
          "pins",       "pin_weight",   "solve_at",    "least_charts", "symmetric"},
         {"uv", "flat"},
         MapToPlane}},
       {"sphere",
        {"the unit sphere, for closed surfaces of genus 0",
         {"pole", "normalization", "principal_axes", "inversion", "layout", "refine_map", "exact",
          "exact_limit", "strict"},
         {"position"},
         MapToSphere}},
       {"disk",
        {"the unit disk, for topological disks like the six that follow",
         {"centre", "angle_zero", "pole", "normalization", "refine_map", "exact", "exact_limit",
          "strict"},
         {"uv"},
         MapToDisk}},
       {"half_plane",
        {"the upper half-plane, one boundary vertex belonging at infinity",
         {"pole", "refine_map", "exact", "exact_limit", "strict"},
         {"uv"},
         MapToHalfPlane}},
       {"rectangle",
        {"a rectangle of height 1",
         {"corners", "pattern", "refine_map", "exact", "exact_limit", "strict"},
         {"uv"},
         MapToRectangle}},
       {"polygon",
        {"a polygon of equal or given angles",
         {"corners", "sides", "targets", "pattern", "refine_map", "exact", "exact_limit", "strict"},
         {"uv"},
         MapToPolygon}},
       {"triangle",
        {"an equilateral triangle",
         {"corners", "pattern", "refine_map", "exact", "exact_limit", "strict"},
         {"uv"},
         MapToTriangle}},
       {"curve",
        {"what a closed curve bounds, an ellipse or one of a file",
         {"curve", "angle_zero", "pattern", "refine_map", "exact", "exact_limit", "strict"},
         {"uv"},
         MapToCurve}},
       {"annulus",
        {"a round annulus of outer radius 1, for genus 0 with two boundary loops",
         {"pattern", "refine_map", "exact", "exact_limit", "strict"},
         {"uv"},
         MapToAnnulus}},
       {"strip",
        {"a strip of height 1 that is periodic along x, for the same surfaces",
         {"pattern", "refine_map", "exact", "exact_limit", "strict"},
         {"uv"},
         MapToStrip}},
       {"round_holes",
        {"the unit disk with round holes, for genus 0 with two or more boundary loops",
         {"pattern", "refine_map", "exact", "exact_limit", "strict"},
         {"uv"},
         MapToRoundHoles}},
       {"torus",
        {"the plane modulo the periods 1 and tau, for closed surfaces of genus 1",
         {"pattern", "refine_map", "exact", "exact_limit", "strict"},
         {"uv"},
         MapToTorus}}});
  return kTable;
}

bool Domain::Reads(const std::string& option) const { return Contains(reads, option); }

bool Domain::Gives(const std::string& member) const { return Contains(gives, member); }

bool IsReadBySomeDomain(const std::string& option) {
  const std::vector<std::string> names = Domains().Names();
  return std::any_of(names.begin(), names.end(),
                     [&](const std::string& name) { return Domains().Find(name)->Reads(option); });
}

StatusOr<SurfaceMap> MapSurface(const Surface& surface, const MapRequest& request,
                                const SolveControl& control, Certificate* failed) {
  return MapSurface(surface, request, control, failed, Domains());
}

namespace {

/// What a proof that there is no map names is numbered as in the file already, from 0; its message
/// names the surface that it was found on.
std::string MessageInFile(const Surface& surface, const Status& status,
                          const Certificate& certificate) {
  if (certificate.infeasibility.empty()) return NumberedAsInFile(surface, status.message());
  const std::string of_proof = InfeasibleMessage(certificate.infeasibility);
  const bool is_proof =
      status.message().substr(0, kProofBegins) == of_proof.substr(0, kProofBegins);
  if (!is_proof) return NumberedAsInFile(surface, status.message());
  const std::optional<LadderSummary>& ladder = certificate.ladder;
  return NumberedFromOne(of_proof) + (ladder ? OtherRoads(*ladder) : "");
}

/// Before anything is solved.
Status TakePins(const Surface& surface, const std::string& path, std::vector<Pin>* pins) {
  if (path.empty()) return Status();
  StatusOr<std::vector<Pin>> read = ReadPins(path, surface);
  if (read.ok()) *pins = *std::move(read);
  return read.status();
}

/// What is said of the roads that led to no map.
void NumberAsInFile(const Surface& surface, LadderSummary* ladder) {
  ladder->since = NumberedAsInFile(surface, ladder->since);
  for (RungSummary& rung : ladder->tried) rung.message = NumberedAsInFile(surface, rung.message);
}

}  // namespace

StatusOr<SurfaceMap> MapSurface(const Surface& surface, const MapRequest& request,
                                const SolveControl& control, Certificate* failed,
                                const Registry<Domain>& domains) {
  const Timer timer;
  SurfaceMap map;
  const StatusOr<Domain> domain = domains.Find(request.domain);
  Status status = domain.status();
  if (status.ok()) status = CheckRequest(*domain, request, surface.triangulation.num_vertices);
  std::vector<Pin> pins;
  if (status.ok()) status = TakePins(surface, request.shape.pins, &pins);
  if (status.ok()) status = MapAtSafeScale(*domain, surface, request, control, &map);
  if (status.ok() && !pins.empty()) status = MoveToPins(surface, request, pins, control, &map);
  InfeasibilityCertificate& proof = map.certificate.infeasibility;
  if (!proof.empty() && !surface.soup_polygon.empty()) NameTriangles(surface, &proof);
  status = Conclude(status, timer, &map.certificate);
  if (map.certificate.ladder) NumberAsInFile(surface, &*map.certificate.ladder);
  if (status.ok()) return map;
  status = Status(status.code(), MessageInFile(surface, status, map.certificate));
  map.certificate.message = status.message();
  if (failed) *failed = std::move(map.certificate);
  return status;
}

}  // namespace cirque
