#include <fstream>
#include <limits>
#include <sstream>
#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "experiments/verify_map/infeasibility_check.h"

namespace cirque::verify_map {
namespace {

using Json = nlohmann::json;

StatusOr<double> ReadNumber(const Json& object, const std::string& key) {
  const auto found = object.find(key);
  if (found == object.end() || !found->is_number()) {
    return Status::InvalidInput(fmt::format("infeasibility.{}: a number is needed", key));
  }
  return found->get<double>();
}

/// Fills `values` from the array at `key`, whose elements must be numbers (Index: whole ones).
template <class T>
Status ReadArray(const Json& object, const std::string& key, std::vector<T>* values) {
  const auto found = object.find(key);
  if (found == object.end() || !found->is_array()) {
    return Status::InvalidInput(fmt::format("infeasibility.{}: an array is needed", key));
  }
  for (const Json& element : *found) {
    const bool fits = std::is_same_v<T, double> ? element.is_number() : element.is_number_integer();
    if (!fits) {
      return Status::InvalidInput(fmt::format("infeasibility.{}[{}]: {} is no {}", key,
                                              values->size(), element.dump(),
                                              std::is_same_v<T, double> ? "number" : "index"));
    }
    // An index beyond 32 bits must not come back as one that exists.
    if constexpr (!std::is_same_v<T, double>) {
      const auto wide = element.get<std::int64_t>();
      values->push_back(static_cast<T>(wide) == wide ? static_cast<T>(wide) : kNone);
    } else {
      values->push_back(element.get<double>());
    }
  }
  return {};
}

}  // namespace

StatusOr<InfeasibilityCertificate> ParseInfeasibilityCertificate(const std::string& json) {
  const Json root = Json::parse(json, nullptr, /*allow_exceptions=*/false);
  if (root.is_discarded() || !root.is_object()) return Status::InvalidInput("not a JSON object");
  const auto outcome = root.find("outcome");
  if (outcome == root.end() || *outcome != "infeasible") {
    return Status::InvalidInput(
        fmt::format("outcome: {} instead of \"infeasible\"; only such a certificate holds a proof",
                    outcome == root.end() ? "nothing" : outcome->dump()));
  }
  const auto proof_json = root.find("infeasibility");
  if (proof_json == root.end() || !proof_json->is_object()) {
    return Status::InvalidInput("infeasibility: an object is needed");
  }
  InfeasibilityCertificate proof;
  const StatusOr<double> epsilon = ReadNumber(*proof_json, "epsilon_over_pi");
  if (!epsilon.ok()) return epsilon.status();
  proof.epsilon_over_pi = *epsilon;
  if (proof_json->contains("removed_vertex")) {
    const Json& removed = (*proof_json)["removed_vertex"];
    if (!removed.is_number_integer()) {
      return Status::InvalidInput("infeasibility.removed_vertex: an index is needed");
    }
    // What is beyond 32 bits, or negative, is no vertex either.
    const auto wide = removed.get<std::int64_t>();
    proof.removed_vertex = std::in_range<Index>(wide) && wide >= 0
                               ? static_cast<Index>(wide)
                               : std::numeric_limits<Index>::max();
  }
  const Status statuses[] = {
      ReadArray(*proof_json, "face_multiplier", &proof.face_multiplier),
      ReadArray(*proof_json, "constrained_vertex", &proof.constrained_vertex),
      ReadArray(*proof_json, "lower_over_pi", &proof.lower_over_pi),
      ReadArray(*proof_json, "upper_over_pi", &proof.upper_over_pi),
      ReadArray(*proof_json, "vertex_multiplier", &proof.vertex_multiplier),
      ReadArray(*proof_json, "carrying_faces", &proof.carrying_faces),
      ReadArray(*proof_json, "carrying_vertices", &proof.carrying_vertices),
  };
  for (const Status& status : statuses) {
    if (!status.ok()) return status;
  }
  return proof;
}

StatusOr<InfeasibilityCertificate> ReadInfeasibilityCertificate(const std::string& path) {
  std::ifstream file(path);
  std::ostringstream content;
  if (!file || !(content << file.rdbuf())) {
    return Status::InvalidInput(fmt::format("{}: cannot be read", path));
  }
  StatusOr<InfeasibilityCertificate> proof = ParseInfeasibilityCertificate(content.str());
  if (!proof.ok()) return proof.status().In(path);
  return proof;
}

}  // namespace cirque::verify_map
