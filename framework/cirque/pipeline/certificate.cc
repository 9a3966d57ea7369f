#include "cirque/pipeline/certificate.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace cirque {
namespace {

/// JSON has no NaN: what a run did not come to is null.
nlohmann::ordered_json NumberToJson(double value) {
  return std::isfinite(value) ? nlohmann::ordered_json(value) : nullptr;
}

nlohmann::ordered_json NumbersToJson(const std::map<std::string, double>& numbers) {
  auto json = nlohmann::ordered_json::object();
  for (const auto& [name, value] : numbers) json[name] = NumberToJson(value);
  return json;
}

nlohmann::ordered_json NumbersToJson(const std::vector<double>& numbers) {
  auto json = nlohmann::ordered_json::array();
  for (const double number : numbers) json.push_back(NumberToJson(number));
  return json;
}

nlohmann::ordered_json InfeasibilityToJson(const InfeasibilityCertificate& proof) {
  nlohmann::ordered_json json = {{"epsilon_over_pi", proof.epsilon_over_pi},
                                 {"margin", proof.margin},
                                 {"carrying_faces", proof.carrying_faces},
                                 {"carrying_vertices", proof.carrying_vertices},
                                 {"constrained_vertex", proof.constrained_vertex},
                                 {"lower_over_pi", proof.lower_over_pi},
                                 {"upper_over_pi", proof.upper_over_pi},
                                 {"vertex_multiplier", proof.vertex_multiplier},
                                 {"face_multiplier", proof.face_multiplier}};
  if (proof.removed_vertex != kNone) json["removed_vertex"] = proof.removed_vertex;
  if (!proof.triangle_face.empty()) {
    json["triangle_face"] = proof.triangle_face;
    json["triangle_corner"] = proof.triangle_corner;
  }
  return json;
}

nlohmann::ordered_json LadderToJson(const LadderSummary& ladder) {
  auto tried = nlohmann::ordered_json::array();
  for (const RungSummary& rung : ladder.tried) {
    tried.push_back({{"rung", rung.rung},
                     {"outcome", rung.outcome},
                     {"message", rung.message},
                     {"seconds", rung.seconds}});
  }
  return {{"made_with", ladder.made_with}, {"since", ladder.since}, {"tried", std::move(tried)}};
}

nlohmann::ordered_json InjectivityToJson(const InjectivitySummary& injectivity) {
  auto tried = nlohmann::ordered_json::array();
  for (const RungSummary& stage : injectivity.tried) {
    tried.push_back(
        {{"stage", stage.rung}, {"outcome", stage.outcome}, {"seconds", stage.seconds}});
  }
  return {{"made_by", injectivity.made_by}, {"tried", std::move(tried)}};
}

nlohmann::ordered_json RepairToJson(const RepairSummary& repair) {
  auto edges = nlohmann::ordered_json::array();
  for (const auto& [a, b] : repair.split_edges) edges.push_back({a, b});
  return {{"zero_area_faces", repair.zero_area_faces},
          {"repeated_vertex_faces", repair.repeated_vertex_faces},
          {"duplicate_faces", repair.duplicate_faces},
          {"welded_vertices", repair.welded_vertices},
          {"split_vertices", repair.split_vertices},
          {"split_edges", std::move(edges)},
          {"t_junctions", repair.t_junctions},
          {"coincident_edges", repair.coincident_edges}};
}

nlohmann::ordered_json ToJsonValue(const Certificate& certificate);

/// The content of one of several components' certificates.
nlohmann::ordered_json ComponentToJson(const Certificate& certificate) {
  const ComponentSummary of = certificate.component.value_or(ComponentSummary());
  nlohmann::ordered_json json = {
      {"first_face", of.first_face}, {"faces", of.faces}, {"vertices", of.vertices}};
  json.update(ToJsonValue(certificate));
  return json;
}

nlohmann::ordered_json ToJsonValue(const Certificate& certificate) {
  const auto& [outcome, message, overlap] =
      std::tie(certificate.outcome, certificate.message, certificate.overlap);
  nlohmann::ordered_json json = {{"schema", kCertificateSchema},
                                 {"version", kCertificateVersion},
                                 {"outcome", outcome},
                                 {"message", message},
                                 {"overlap", overlap},
                                 {"values", NumbersToJson(NumbersOf(certificate))},
                                 {"seconds", NumbersToJson(SecondsOf(certificate))},
                                 {"solvers", nlohmann::ordered_json::object()},
                                 {"history", nlohmann::ordered_json::object()}};
  if (const auto& angles = certificate.angle_fit) {
    json["solvers"]["angles"] = angles->solver;
    json["history"]["angles"] = NumbersToJson(angles->gradients);
  }
  if (const auto& radii = certificate.radii) {
    json["solvers"]["radii"] = radii->solver;
    json["history"]["radii"] = NumbersToJson(radii->gradients);
  }
  if (const auto& scales = certificate.equivalence) {
    json["solvers"]["scales"] = scales->solver;
    json["history"]["scales"] = NumbersToJson(scales->gradients);
  }
  if (certificate.ladder) json["ladder"] = LadderToJson(*certificate.ladder);
  if (certificate.injectivity) {
    json["injectivity"] = InjectivityToJson(*certificate.injectivity);
  }
  if (certificate.mesh_repair) json["repair"] = RepairToJson(*certificate.mesh_repair);
  if (const auto& proof = certificate.infeasibility; !proof.empty()) {
    json["infeasibility"] = InfeasibilityToJson(proof);
  }
  for (const Certificate& part : certificate.components) {
    json["components"].push_back(ComponentToJson(part));
  }
  return json;
}

}  // namespace

std::string Certificate::ToJson() const {
  return ToJsonValue(*this).dump(1, ' ', false, nlohmann::json::error_handler_t::replace) + "\n";
}

namespace {

/// A map onto a shape of its own that came to rest is a least one there, whatever it began with.
bool ForgetsLayout(const Certificate& c) {
  const bool on_shape = c.sphere || c.disk || c.half_plane || c.polygon;
  return on_shape && c.map_refinement && c.map_refinement->map_refinement_at_rest == 1;
}

}  // namespace

namespace {

/// What of the rotations is not as it was asked for.
std::string MissedRotation(const HolonomySummary& holonomy) {
  if (!(holonomy.holonomy_miss > kRotationAccuracy)) return "";
  return fmt::format(
      "the map has no flipped triangle but is not seamless: rotation_{} misses the next multiple "
      "by {:.2g} rad, others by less; angles nearest to the surface's would have changed by up to "
      "{:.2g} rad on the way there; more cones (-cones=seamless -cone_budget=N) leave more room",
      holonomy.holonomy_loop, holonomy.holonomy_miss, holonomy.holonomy_angle_change);
}

/// What of the rotations along a file's loops is not met though it was to be.
std::string MissedLoop(const LoopsSummary& loops) {
  if (loops.loops_to_meet == 0 || !(loops.loop_miss > kRotationAccuracy)) return "";
  return fmt::format(
      "the map has no flipped triangle, but of the rotations that were to be met that along loop "
      "{} "
      "misses by {:.2g} rad, others by less: no angles were found that meet all of them with these "
      "cones; along loops that others make up, or around vertices, the cones decide",
      loops.loop_that_misses + 1, loops.loop_miss);
}

/// Smaller cells help there, another road does not.
std::string MissedLattice(const Certificate& certificate) {
  if (!certificate.integers || certificate.integers->integer_obstacle.empty()) return "";
  return "the map has no flipped triangle and is seamless, but not on a lattice: " +
         certificate.integers->integer_obstacle;
}

/// What edges and seams of the map that is the result miss, relative.
struct LayoutMisses {
  double closure, lengths;
};

LayoutMisses Misses(const Certificate& of) {
  const bool exact_alone = of.exact_map && of.layout && of.layout->flipped_triangles > 0;
  if (exact_alone) {
    return {of.exact_map->exact_layout_closure, of.exact_map->exact_seam_length_mismatch};
  }
  const bool has_layout = of.layout && !ForgetsLayout(of);
  return {has_layout ? of.layout->layout_closure : 0,
          of.seams ? of.seams->seam_length_mismatch : 0};
}

}  // namespace

std::string Inaccuracy(const Certificate& certificate) {
  if (certificate.holonomy) {
    if (std::string missed = MissedRotation(*certificate.holonomy); !missed.empty()) return missed;
  }
  if (certificate.loops) {
    if (std::string missed = MissedLoop(*certificate.loops); !missed.empty()) return missed;
  }
  const auto [closure, lengths] = Misses(certificate);
  if (!(closure > kAccuracy || lengths > kAccuracy)) return "";
  return fmt::format(
      "the map has no flipped triangle but is not accurate to {:.0e}: its edges close to {:.1e} of "
      "their length, the two sides of seams differ by up to {:.1e}; log radii range over {:.1f}, "
      "more cones (-cones=greedy) bring that down",
      kAccuracy, closure, lengths, certificate.radii ? certificate.radii->log_radius_range : 0);
}

Status Conclude(const Status& status, const Timer& timer, Certificate* certificate) {
  certificate->seconds.total = timer.Seconds();
  certificate->outcome = ToString(status.code());
  certificate->message = status.message();
  if (!status.ok()) return status;
  certificate->message = Inaccuracy(*certificate);
  if (certificate->message.empty()) certificate->message = MissedLattice(*certificate);
  if (!certificate->message.empty()) certificate->outcome = kInaccurate;
  return status;
}

void NameTriangles(const Surface& surface, InfeasibilityCertificate* proof) {
  const std::vector<Index>& face = surface.soup_polygon;
  if (proof->face_multiplier.size() != face.size()) return;
  std::vector<Index> carrying;
  for (const Index f : proof->carrying_faces) {
    if (face[f] == kNone) continue;
    if (std::find(carrying.begin(), carrying.end(), face[f]) == carrying.end()) {
      carrying.push_back(face[f]);
    }
  }
  proof->carrying_faces = std::move(carrying);
  proof->triangle_face = face;
  proof->triangle_corner = surface.soup_corner;
  for (std::size_t begin = 0, end = 0; begin < face.size(); begin = end) {
    while (end < face.size() && face[end] == face[begin]) ++end;
    const auto first = proof->triangle_corner.begin() + static_cast<std::ptrdiff_t>(3 * begin);
    const auto last = proof->triangle_corner.begin() + static_cast<std::ptrdiff_t>(3 * end);
    const Index first_corner = *std::min_element(first, last);
    for (auto corner = first; corner != last; ++corner) *corner -= first_corner;
  }
}

void NumberAsInFile(const Surface& surface, InfeasibilityCertificate* proof) {
  for (Index& v : proof->constrained_vertex) v = surface.soup_vertex[v];
  for (Index& v : proof->carrying_vertices) v = surface.soup_vertex[v];
}

}  // namespace cirque
