#include "cirque/pipeline/certificate.h"

#include <cmath>

#include <nlohmann/json.hpp>

namespace cirque {
namespace {

/// JSON has no NaN: what a run did not come to is null.
nlohmann::ordered_json NumbersToJson(const std::map<std::string, double>& numbers) {
  auto json = nlohmann::ordered_json::object();
  for (const auto& [name, value] : numbers) {
    json[name] = std::isfinite(value) ? nlohmann::ordered_json(value) : nullptr;
  }
  return json;
}

nlohmann::ordered_json HistoryToJson(const std::map<std::string, std::vector<double>>& history) {
  auto json = nlohmann::ordered_json::object();
  for (const auto& [stage, gradients] : history) {
    json[stage] = nlohmann::ordered_json::array();
    for (const double gradient : gradients) {
      json[stage].push_back(std::isfinite(gradient) ? nlohmann::ordered_json(gradient) : nullptr);
    }
  }
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

}  // namespace

std::string Certificate::ToJson() const {
  nlohmann::ordered_json json = {{"outcome", outcome}, {"message", message}};
  json["overlap"] = overlap;
  json["values"] = NumbersToJson(values);
  if (!strategies.empty()) json["strategies"] = strategies;
  json["seconds"] = NumbersToJson(seconds);
  if (!history.empty()) json["history"] = HistoryToJson(history);
  if (!infeasibility.empty()) json["infeasibility"] = InfeasibilityToJson(infeasibility);
  return json.dump(1, ' ', false, nlohmann::json::error_handler_t::replace) + "\n";
}

}  // namespace cirque
