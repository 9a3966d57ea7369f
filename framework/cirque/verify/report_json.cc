#include <algorithm>
#include <utility>

#include <nlohmann/json.hpp>

#include "cirque/verify/map_check.h"
#include "cirque/verify/report_words.h"

namespace cirque::verify {
namespace {

using Json = nlohmann::ordered_json;

/// "NAME": how many, "NAME_ids": the first of them.
void PutIds(const std::string& name, const std::vector<Index>& ids, Json* json) {
  constexpr std::size_t kShown = 1000;
  const auto end = ids.begin() + static_cast<std::ptrdiff_t>(std::min(kShown, ids.size()));
  (*json)[name] = ids.size();
  (*json)[name + "_ids"] = std::vector<Index>(ids.begin(), end);
}

void PutMatch(const MapReport& report, Json* json) {
  const MeshMatch& match = report.match;
  (*json)["faces"] = report.num_faces;
  (*json)["triangles"] = report.num_triangles;
  (*json)["vertices"] = report.num_vertices;
  PutIds("set_aside_faces", report.set_aside, json);
  (*json)["split_vertices"] = report.num_split;
  (*json)["same_order"] = match.faces.same_order;
  (*json)["matched_by_position"] = match.by_position;
  (*json)["polygons_in_pieces"] = match.faces.pieces.size();
  (*json)["scale"] = match.scale;
  (*json)["largest_displacement"] = match.displacement.largest;
  PutIds("moved_vertices", match.displacement.moved, json);
  PutIds("missing_triangles", match.faces.missing, json);
  PutIds("extra_triangles", match.faces.extra, json);
  PutIds("reversed_triangles", match.faces.reversed, json);
  PutIds("turned_triangles", report.turned, json);
  PutIds("triangles_without_uv", report.without_uv, json);
  PutIds("triangles_not_finite", report.not_finite, json);
}

void PutSeams(const UvComplex& complex, const SeamAgreement& seams, Json* json) {
  (*json)["components"] = complex.num_components;
  (*json)["patches"] = complex.num_patches;
  (*json)["torn"] = complex.torn();
  (*json)["seam_edges"] = complex.num_seam_edges;
  (*json)["largest_seam_length_difference"] = seams.largest_difference;
  (*json)["largest_seam_rotation_gap"] = seams.largest_rotation_gap;
}

void PutAngles(const AngleMeasures& angles, Json* json) {
  (*json)["smallest_angle"] = angles.smallest_angle;
  (*json)["delaunay_margin"] = angles.delaunay_margin;
  (*json)["inner_vertices_off_seams"] = angles.num_plain;
  (*json)["largest_angle_sum_deviation"] = angles.largest_plain_deviation;
  PutIds("wrapped_vertices", angles.wrapped, json);
  (*json)["inner_vertices_on_seams"] = angles.num_on_seam;
  (*json)["largest_flat_seam_deviation"] = angles.largest_flat_seam_deviation;
  (*json)["cones"] = Json::array();
  for (const Cone& cone : angles.cones) {
    (*json)["cones"].push_back({{"vertex", cone.vertex}, {"angle_sum", cone.angle_sum}});
  }
  (*json)["largest_target_deviation"] = angles.largest_target_deviation;
  PutIds("off_target_vertices", angles.off_target, json);
}

void PutQuality(const QualityFigures& quality, Json* json) {
  for (const auto& [name, value] : quality.values) (*json)[name] = value;
  if (quality.worst_triangle != kNone) {
    (*json)["quasi_conformal_worst_triangle"] = quality.worst_triangle;
  }
}

void PutOverlap(const UvComplex& complex, const OverlapResult& overlap, Json* json) {
  (*json)["boundary_edges"] = overlap.num_boundary_edges;
  (*json)["boundary_loops"] = overlap.num_boundary_loops;
  PutIds("wrapped_boundary_vertices", overlap.wrapped_boundary, json);
  if (!overlap.overlap) return;
  const auto [a, b] = *overlap.overlap;
  (*json)["boundary_crosses"] = overlap.crosses;
  (*json)["overlapping_triangles"] = {complex.FaceOf(a), complex.FaceOf(b)};
  (*json)["overlapping_patches"] = {complex.patch[a / 3], complex.patch[b / 3]};
}

}  // namespace

std::string ToJson(const MapReport& report) {
  Json json;
  json["valid"] = report.valid();
  json["injective"] = report.overlap ? Json(!report.overlap->overlaps()) : Json(nullptr);
  json["verdict"] = report.Verdict();
  json["errors"] = report.errors;
  PutMatch(report, &json);
  if (report.orientations) {
    PutIds("flipped_triangles", report.orientations->flipped, &json);
    PutIds("zero_area_triangles", report.orientations->zero_area, &json);
    PutIds("folded_faces", report.orientations->folded, &json);
  }
  if (report.angles) PutAngles(*report.angles, &json);
  if (report.seams) PutSeams(*report.complex, *report.seams, &json);
  if (report.quality) PutQuality(*report.quality, &json);
  if (report.disk) {
    json["boundary_circle_error"] = report.disk->largest_error;
    json["boundary_turns"] = report.disk->turns;
    PutIds("boundary_off_circle", report.disk->off_circle, &json);
    PutIds("boundary_out_of_order", report.disk->out_of_order, &json);
  }
  if (report.holes) {
    json["holes"] = report.holes->holes;
    json["hole_circle_error"] = report.holes->largest_error;
    PutIds("hole_off_circle", report.holes->off_circle, &json);
  }
  if (report.overlap) PutOverlap(*report.complex, *report.overlap, &json);
  return FiniteJson(std::move(json));
}

}  // namespace cirque::verify
