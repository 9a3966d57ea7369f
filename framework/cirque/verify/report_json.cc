#include <algorithm>

#include <nlohmann/json.hpp>

#include "cirque/verify/map_check.h"

namespace cirque::verify {
namespace {

using Json = nlohmann::ordered_json;  // NaN is written as null

/// "NAME": how many, "NAME_ids": the first of them.
void PutIds(const std::string& name, const std::vector<Index>& ids, Json* json) {
  constexpr std::size_t kShown = 1000;
  const auto end = ids.begin() + static_cast<std::ptrdiff_t>(std::min(kShown, ids.size()));
  (*json)[name] = ids.size();
  (*json)[name + "_ids"] = std::vector<Index>(ids.begin(), end);
}

void PutMatch(const MapReport& report, Json* json) {
  (*json)["triangles"] = report.num_triangles;
  (*json)["vertices"] = report.num_vertices;
  (*json)["same_order"] = report.correspondence.same_order;
  (*json)["largest_displacement"] = report.displacement.largest;
  PutIds("moved_vertices", report.displacement.moved, json);
  PutIds("missing_triangles", report.correspondence.missing, json);
  PutIds("extra_triangles", report.correspondence.extra, json);
  PutIds("reversed_triangles", report.correspondence.reversed, json);
  PutIds("turned_triangles", report.turned, json);
  PutIds("triangles_without_uv", report.without_uv, json);
  PutIds("triangles_not_finite", report.not_finite, json);
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
  (*json)["quasi_conformal_worst_triangle"] = quality.worst_triangle;
}

void PutOverlap(const OverlapResult& overlap, Json* json) {
  (*json)["boundary_edges"] = overlap.num_boundary_edges;
  (*json)["boundary_loops"] = overlap.num_boundary_loops;
  (*json)["boundary_crossings"] = overlap.num_crossings;
  if (overlap.num_crossings > 0) {
    (*json)["first_crossing_triangles"] = {overlap.first_crossing.first / 3,
                                           overlap.first_crossing.second / 3};
  }
  PutIds("wrapped_boundary_vertices", overlap.wrapped_boundary, json);
  (*json)["nested_patches"] =
      overlap.nested_patches.first == kNone
          ? Json(nullptr)
          : Json::array({overlap.nested_patches.first, overlap.nested_patches.second});
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
  }
  if (report.angles) PutAngles(*report.angles, &json);
  if (report.seams) {
    json["seam_edges"] = report.seams->num_edges;
    json["largest_seam_length_difference"] = report.seams->largest_difference;
  }
  if (report.quality) PutQuality(*report.quality, &json);
  json["patches"] = report.num_patches;
  if (report.disk) {
    json["boundary_circle_error"] = report.disk->largest_error;
    json["boundary_turns"] = report.disk->turns;
    PutIds("boundary_off_circle", report.disk->off_circle, &json);
    PutIds("boundary_out_of_order", report.disk->out_of_order, &json);
  }
  if (report.overlap) PutOverlap(*report.overlap, &json);
  return json.dump(2) + "\n";
}

}  // namespace cirque::verify
