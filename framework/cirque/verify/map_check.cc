#include "cirque/verify/map_check.h"

#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "cirque/core/text.h"
#include "cirque/verify/findings.h"

namespace cirque::verify {
namespace {

/// A NaN as tolerance would let everything pass.
Status CheckTolerances(const VerifyOptions& options) {
  const std::pair<const char*, double> tolerances[] = {
      {"position_tolerance", options.position_tolerance},
      {"angle_tolerance", options.angle_tolerance},
      {"seam_tolerance", options.seam_tolerance},
      {"circle_tolerance", options.circle_tolerance}};
  for (const auto& [name, value] : tolerances) {
    if (value >= 0) continue;
    return Status::InvalidInput(fmt::format("{} = {}: a number >= 0 is needed", name, value));
  }
  return {};
}

Status CheckInput(const PolygonSoup& in) {
  if (in.num_polygons() == 0) return Status::InvalidInput("no faces; nothing to map");
  for (std::size_t v = 0; v < in.position.size(); ++v) {
    if (!in.position[v].allFinite()) {
      return Status::InvalidInput(fmt::format("vertex {} has a coordinate that is not finite", v));
    }
  }
  return {};
}

/// Matches vertices and triangles; false when the rest cannot be judged.
bool MatchMeshes(const PolygonSoup& in, const PolygonSoup& out, const FanMesh& in_mesh,
                 const FanMesh& out_mesh, double tolerance, MapReport* report) {
  std::vector<std::string>& errors = report->errors;
  if (in.position.size() != out.position.size()) {
    errors.push_back(fmt::format("IN has {} and OUT {}; OUT must keep IN's vertices in their order",
                                 Count(in.position.size(), "vertex"), out.position.size()));
    return false;
  }
  report->displacement = ComparePositions(in.position, out.position, tolerance);
  const std::vector<Index>& moved = report->displacement.moved;
  if (!moved.empty()) {
    errors.push_back(fmt::format(
        "{} moved ({}): by up to {:.3g} of the bounding box, {:.3g} allowed",
        Count(moved.size(), "vertex"), IdList(moved), report->displacement.largest, tolerance));
  }
  report->correspondence = MatchTriangles(in_mesh, out_mesh);
  const Correspondence& match = report->correspondence;
  if (!match.missing.empty()) {
    errors.push_back(fmt::format("{} of IN missing from OUT ({})",
                                 Count(match.missing.size(), "triangle"), IdList(match.missing)));
  }
  if (!match.extra.empty()) {
    errors.push_back(fmt::format("{} of OUT not in IN (numbers of OUT: {})",
                                 Count(match.extra.size(), "triangle"), IdList(match.extra)));
  }
  return match.complete();
}

/// The UV of every corner; false when some are missing or not finite, which is an error then.
bool CollectUvs(const PolygonSoup& out, const FanMesh& mesh, std::vector<Point>* uv,
                MapReport* report) {
  uv->resize(mesh.vertex.size());
  for (Index f = 0; f < mesh.num_triangles(); ++f) {
    bool complete = !out.corner_texture.empty(), finite = true;
    for (Index h = 3 * f; complete && h < 3 * f + 3; ++h) {
      const Index texture = out.corner_texture[mesh.soup_corner[h]];
      complete = texture >= 0 && texture < static_cast<Index>(out.texture.size());
      if (!complete) continue;
      (*uv)[h] = out.texture[texture];
      finite = finite && (*uv)[h].allFinite();
    }
    if (!complete) report->without_uv.push_back(f);
    if (!finite) report->not_finite.push_back(f);
  }
  if (!report->without_uv.empty()) {
    report->errors.push_back(fmt::format("{} without texture coordinates ({})",
                                         Count(report->without_uv.size(), "triangle"),
                                         IdList(report->without_uv)));
  }
  if (!report->not_finite.empty()) {
    report->errors.push_back(fmt::format("{} with texture coordinates that are not finite ({})",
                                         Count(report->not_finite.size(), "triangle"),
                                         IdList(report->not_finite)));
  }
  return report->without_uv.empty() && report->not_finite.empty();
}

void Append(std::vector<std::string> more, std::vector<std::string>* errors) {
  errors->insert(errors->end(), std::make_move_iterator(more.begin()),
                 std::make_move_iterator(more.end()));
}

void JudgeSeams(const UvComplex& complex, const VerifyOptions& options, MapReport* report) {
  report->seams = CompareSeams(complex);
  const SeamAgreement& seams = *report->seams;
  const bool rigid = seams.num_edges == 0 || seams.largest_difference <= options.seam_tolerance;
  if (rigid || !options.require_rigid_seams) return;
  report->errors.push_back(fmt::format(
      "the two sides of seam {} differ in length by {:.3g}, {:.3g} allowed",
      NameEdge(complex, seams.worst_halfedge), seams.largest_difference, options.seam_tolerance));
}

void JudgeMap(const UvComplex& complex, const VerifyOptions& options, MapReport* report) {
  report->num_patches = complex.num_patches;
  report->orientations = ClassifyTriangles(complex);
  Append(OrientationErrors(*report->orientations, complex.num_triangles()), &report->errors);
  const bool oriented =
      report->orientations->flipped.empty() && report->orientations->zero_area.empty();
  report->angles = MeasureAngles(complex, options.targets, options.angle_tolerance);
  // Round a flipped triangle the angles say nothing that the flip does not.
  if (!oriented) report->angles->wrapped.clear();
  Append(AngleErrors(*report->angles, options.angle_tolerance), &report->errors);
  JudgeSeams(complex, options, report);
  if (options.unit_disk) {
    report->disk = FitDisk(complex, options.circle_tolerance);
    Append(DiskErrors(complex, *report->disk, options.circle_tolerance), &report->errors);
  }
  if (!oriented || !report->angles->wrapped.empty()) return;
  report->overlap = CheckOverlap(complex);
  if (options.require_injective) {
    Append(OverlapErrors(complex, *report->overlap), &report->errors);
  }
}

}  // namespace

std::string MapReport::Verdict() const {
  if (!valid()) return "INVALID: " + Join(errors, "; ");
  return overlap->overlaps() ? "valid (locally injective, boundary overlaps itself)"
                             : "valid (injective)";
}

StatusOr<MapReport> VerifyMap(const PolygonSoup& in, const PolygonSoup& out,
                              const VerifyOptions& options) {
  const Status tolerances = CheckTolerances(options);
  if (!tolerances.ok()) return tolerances;
  const Status input = CheckInput(in);
  if (!input.ok()) return input.In("IN");
  const StatusOr<FanMesh> in_mesh = FanTriangulate(in), out_mesh = FanTriangulate(out);
  if (!in_mesh.ok()) return in_mesh.status().In("IN");
  if (!out_mesh.ok()) return out_mesh.status().In("OUT");
  MapReport report;
  report.num_triangles = in_mesh->num_triangles();
  report.num_vertices = in_mesh->num_vertices;
  if (!MatchMeshes(in, out, *in_mesh, *out_mesh, options.position_tolerance, &report)) {
    return report;
  }
  StatusOr<Surface> surface = BuildSurface(Reorder(*out_mesh, report.correspondence));
  if (!surface.ok()) return surface.status().In("IN");
  report.turned = surface->turned;
  std::vector<Point> uv;
  if (!CollectUvs(out, surface->mesh, &uv, &report)) return report;
  report.complex = BuildUvComplex(*std::move(surface), std::move(uv));
  JudgeMap(*report.complex, options, &report);
  return report;
}

}  // namespace cirque::verify
