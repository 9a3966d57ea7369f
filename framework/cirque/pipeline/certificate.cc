#include "cirque/pipeline/certificate.h"

#include <cmath>
#include <map>
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
  return json;
}

nlohmann::ordered_json LadderToJson(const LadderSummary& ladder) {
  auto tried = nlohmann::ordered_json::array();
  for (const RungSummary& rung : ladder.tried) {
    tried.push_back({{"rung", rung.rung}, {"outcome", rung.outcome}, {"message", rung.message}});
  }
  return {{"made_with", ladder.made_with}, {"since", ladder.since}, {"tried", std::move(tried)}};
}

}  // namespace

std::string Certificate::ToJson() const {
  nlohmann::ordered_json json = {{"schema", kCertificateSchema},
                                 {"version", kCertificateVersion},
                                 {"outcome", outcome},
                                 {"message", message},
                                 {"overlap", overlap},
                                 {"values", NumbersToJson(NumbersOf(*this))},
                                 {"seconds", NumbersToJson(SecondsOf(*this))},
                                 {"solvers", nlohmann::ordered_json::object()},
                                 {"history", nlohmann::ordered_json::object()}};
  if (angle_fit) {
    json["solvers"]["angles"] = angle_fit->solver;
    json["history"]["angles"] = NumbersToJson(angle_fit->gradients);
  }
  if (radii) {
    json["solvers"]["radii"] = radii->solver;
    json["history"]["radii"] = NumbersToJson(radii->gradients);
  }
  if (ladder) json["ladder"] = LadderToJson(*ladder);
  if (!infeasibility.empty()) json["infeasibility"] = InfeasibilityToJson(infeasibility);
  return json.dump(1, ' ', false, nlohmann::json::error_handler_t::replace) + "\n";
}

std::string Inaccuracy(const Certificate& certificate) {
  const double closure = certificate.layout ? certificate.layout->layout_closure : 0;
  const double lengths = certificate.seams ? certificate.seams->seam_length_mismatch : 0;
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
  if (!certificate->message.empty()) certificate->outcome = kInaccurate;
  return status;
}

void NumberAsInFile(const Surface& surface, InfeasibilityCertificate* proof) {
  for (Index& v : proof->constrained_vertex) v = surface.soup_vertex[v];
  for (Index& v : proof->carrying_vertices) v = surface.soup_vertex[v];
}

}  // namespace cirque
