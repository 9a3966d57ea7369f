#include "cirque/verify/map_check.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include <fmt/format.h>

#include "cirque/core/text.h"
#include "cirque/verify/findings.h"
#include "cirque/verify/polygon_check.h"
#include "cirque/verify/report_words.h"
#include "cirque/verify/set_aside.h"

namespace cirque::verify {
namespace {

/// A NaN as tolerance would let everything pass.
Status CheckOptions(const VerifyOptions& options, Index num_vertices) {
  const std::pair<const char*, double> tolerances[] = {
      {"position_tolerance", options.position_tolerance},
      {"angle_tolerance", options.angle_tolerance},
      {"seam_tolerance", options.seams.tolerance},
      {"circle_tolerance", options.circle_tolerance},
      {"max_patches", options.seams.max_patches.value_or(0)},
      {"max_seam_edges", options.seams.max_edges.value_or(0)},
      {"seam_rotations", options.seams.rotation_order}};
  for (const auto& [name, value] : tolerances) {
    if (value >= 0) continue;
    return Status::InvalidInput(fmt::format("{} = {}: a number >= 0 is needed", name, value));
  }
  if (options.targets.at.empty() || static_cast<Index>(options.targets.at.size()) == num_vertices) {
    return {};
  }
  return Status::InvalidInput(
      fmt::format("{} targets for {} vertices", options.targets.at.size(), num_vertices));
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

void Append(std::vector<std::string> more, std::vector<std::string>* errors) {
  errors->insert(errors->end(), std::make_move_iterator(more.begin()),
                 std::make_move_iterator(more.end()));
}

/// Faces of OUT without a UV at every corner, and with one that is not finite.
struct UvGaps {
  std::vector<char> without, not_finite;
};

UvGaps FindUvGaps(const PolygonSoup& out) {
  UvGaps gaps;
  const auto num_uvs = static_cast<Index>(out.texture.size());
  for (Index g = 0; g < out.num_polygons(); ++g) {
    bool complete = !out.corner_texture.empty(), finite = true;
    for (Index c = out.first_corner[g]; complete && c < out.first_corner[g + 1]; ++c) {
      const Index uv = out.corner_texture[c];
      complete = uv >= 0 && uv < num_uvs;
      finite = finite && complete && out.texture[uv].allFinite();
    }
    gaps.without.push_back(!complete);
    gaps.not_finite.push_back(complete && !finite);
  }
  return gaps;
}

/// The faces of IN of which `bad` tells a part.
std::vector<Index> FacesOf(const Correspondence& faces, const std::vector<char>& bad) {
  std::vector<Index> result;
  for (Index f = 0; f < static_cast<Index>(faces.out_face.size()); ++f) {
    if (faces.out_face[f] != kNone && bad[faces.out_face[f]]) result.push_back(f);
    const auto cut = faces.pieces.find(f);
    if (cut == faces.pieces.end()) continue;
    bool is_bad = false;
    for (const Index g : cut->second) is_bad = is_bad || bad[g];
    if (is_bad) result.push_back(f);
  }
  return result;
}

/// Whether every face has its UVs; if not, that is an error.
bool JudgeUvs(const PolygonSoup& out, MapReport* report) {
  const UvGaps gaps = FindUvGaps(out);
  report->without_uv = FacesOf(report->match.faces, gaps.without);
  report->not_finite = FacesOf(report->match.faces, gaps.not_finite);
  for (const auto& [faces, fault] :
       {std::pair(&report->without_uv, "without texture coordinates"),
        std::pair(&report->not_finite, "with texture coordinates that are not finite")}) {
    if (faces->empty()) continue;
    report->errors.push_back(
        fmt::format("{} {} ({})", Count(faces->size(), report->noun), fault, IdList(*faces)));
  }
  return report->without_uv.empty() && report->not_finite.empty();
}

bool RepeatsVertex(const std::vector<FaceCorner>& corners) {
  std::vector<Index> vertices;
  for (const FaceCorner& corner : corners) vertices.push_back(corner.vertex);
  std::sort(vertices.begin(), vertices.end());
  return std::adjacent_find(vertices.begin(), vertices.end()) != vertices.end();
}

/// The shape of a face in the plane, and triangles that fill it where it is simple.
ImageOf ImageInPlane(const PolygonSoup& out) {
  return [&out](const std::vector<FaceCorner>& corners) {
    std::vector<Point> polygon;
    for (const FaceCorner& corner : corners) {
      polygon.push_back(out.texture[out.corner_texture[corner.soup_corner]]);
    }
    const auto n = static_cast<int>(polygon.size());
    const PolygonShape shape = ShapeOf(polygon);
    const auto turn = [&](int i, int j, int k) {
      return Orientation(polygon[i], polygon[j], polygon[k]);
    };
    std::vector<int> triangles;
    if (n > 3 && shape == PolygonShape::kSimple) triangles = CutEars(n, turn);
    if (n > 3 && shape == PolygonShape::kFolded && RepeatsVertex(corners)) {
      triangles = CutEars(n, turn, [&](int i, int k) { return polygon[i] == polygon[k]; });
      if (!triangles.empty()) return std::pair(PolygonShape::kSimple, std::move(triangles));
    }
    if (triangles.empty()) triangles = CutFan(n);
    return std::pair(shape, std::move(triangles));
  };
}

void JudgeMap(const UvComplex& complex, const VerifyOptions& options, MapReport* report) {
  const Orientations& found = *report->orientations;
  Append(OrientationErrors(found, report->noun), &report->errors);
  const bool oriented = found.flipped.empty() && found.zero_area.empty() && found.folded.empty();
  report->angles = MeasureAngles(complex, options.targets, options.angle_tolerance);
  // Round a flipped triangle the angles say nothing that the flip does not.
  if (!oriented) report->angles->wrapped.clear();
  Append(AngleErrors(*report->angles, options.angle_tolerance), &report->errors);
  report->seams = CompareSeams(complex, options.seams.rotation_order);
  Append(SeamErrors(complex, *report->seams, options.seams), &report->errors);
  if (options.unit_disk) {
    report->disk = FitDisk(complex, options.circle_tolerance);
    Append(DiskErrors(complex, *report->disk, options.circle_tolerance), &report->errors);
  }
  if (options.round_holes) {
    report->holes = FitHoles(complex, options.hole_tolerance);
    Append(HoleErrors(*report->holes, options.hole_tolerance), &report->errors);
  }
  if (!oriented || !report->angles->wrapped.empty()) return;
  report->overlap = CheckOverlap(complex);
  if (options.require_injective) {
    Append(OverlapErrors(complex, *report->overlap), &report->errors);
  }
}

/// Judges what OUT's corners make of IN's faces, all of which were found.
void JudgeFaces(const PolygonSoup& in, const PolygonSoup& out, JudgedFaces faces,
                const VerifyOptions& options, MapReport* report) {
  const std::vector<Index> folded = FoldedTriangulations(in, report->match);
  if (!folded.empty()) {
    report->errors.push_back(
        fmt::format("{} cut by OUT into triangles that lie partly outside of it ({})",
                    Count(folded.size(), "polygon"), IdList(folded)));
  }
  if (!JudgeUvs(out, report)) return;
  faces.left_out = KeepInLine(faces.left_out, in, report->match, out);
  for (Index f = 0; f < in.num_polygons(); ++f) {
    if (faces.left_out[f]) report->set_aside.push_back(f);
  }
  const auto same = [&](const FaceCorner& a, const FaceCorner& b) {
    return out.texture[out.corner_texture[a.soup_corner]] ==
           out.texture[out.corner_texture[b.soup_corner]];
  };
  JudgedMesh judged = BuildJudgedMesh(in, faces, report->match, ImageInPlane(out), same);
  report->orientations = std::move(judged.orientations);
  StatusOr<Surface> surface = BuildSurface(std::move(judged.mesh), Joints::kOpen);
  if (!surface.ok()) {
    report->errors.push_back("OUT: " + surface.status().message());
    return;
  }
  std::vector<Point> uv;
  uv.reserve(surface->mesh.soup_corner.size());
  for (const Index c : surface->mesh.soup_corner) uv.push_back(out.texture[out.corner_texture[c]]);
  report->num_split = surface->mesh.num_vertices - static_cast<Index>(in.position.size());
  report->complex = BuildUvComplex(*std::move(surface), std::move(uv));
  JudgeMap(*report->complex, options, report);
}

}  // namespace

std::string MapReport::Verdict() const {
  if (!valid()) return "INVALID: " + Join(errors, "; ");
  return fmt::format("{}, {}",
                     overlap->overlaps() ? "valid (locally injective, boundary overlaps itself)"
                                         : "valid (injective)",
                     SeamStatement(*complex));
}

StatusOr<MapReport> VerifyMap(const PolygonSoup& in, const PolygonSoup& out,
                              const VerifyOptions& options) {
  Status status = CheckOptions(options, static_cast<Index>(in.position.size()));
  if (!status.ok()) return status;
  status = CheckInput(in);
  if (!status.ok()) return status.In("IN");
  status = CheckFaces(out);
  if (!status.ok()) return status.In("OUT");
  status = CheckFaces(in);
  if (!status.ok()) return status.In("IN");
  JudgedFaces faces{{}, MaySetAside(in)};
  std::vector<bool> keep = faces.left_out;
  keep.flip();
  if (std::find(keep.begin(), keep.end(), true) == keep.end()) {
    return Status::InvalidInput("no face has an area; nothing to map").In("IN");
  }
  StatusOr<TriangleMesh> mesh = FanTriangulate(in, &keep);
  if (!mesh.ok()) return mesh.status().In("IN");
  const StatusOr<Surface> surface = BuildSurface(*std::move(mesh), Joints::kOpen);
  if (!surface.ok()) return surface.status().In("IN");
  faces.turned = TurnedFaces(in, *surface);
  MapReport report;
  report.noun = FaceNoun(in);
  report.num_faces = in.num_polygons();
  report.num_triangles = surface->mesh.num_triangles();
  report.num_vertices = static_cast<Index>(in.position.size());
  for (const Index t : surface->turned) {
    const Index f = surface->mesh.face[t];
    if (report.turned.empty() || report.turned.back() != f) report.turned.push_back(f);
  }
  report.match = MatchMeshes(in, out, options.position_tolerance);
  report.errors = MatchErrors(in, out, report.match, options.position_tolerance);
  if (report.match.faces.complete()) JudgeFaces(in, out, std::move(faces), options, &report);
  return report;
}

}  // namespace cirque::verify
