#include <fstream>
#include <limits>
#include <optional>
#include <sstream>
#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "cirque/io/json_input.h"
#include "cirque/verify/infeasibility_check.h"

namespace cirque::verify {
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
  const std::optional<Json> parsed = ParseJson(json);
  if (!parsed || !parsed->is_object()) return Status::InvalidInput("not a JSON object");
  const Json& root = *parsed;
  const auto outcome = root.find("outcome");
  if (outcome == root.end() || *outcome != "infeasible") {
    return Status::InvalidInput(
        fmt::format("outcome: {} instead of \"infeasible\"; no other shows infeasibility",
                    outcome == root.end() ? "nothing" : outcome->dump()));
  }
  const auto member = root.find("infeasibility");
  if (member == root.end() || !member->is_object()) {
    return Status::InvalidInput("infeasibility: an object is needed");
  }
  InfeasibilityCertificate certificate;
  const StatusOr<double> epsilon = ReadNumber(*member, "epsilon_over_pi");
  if (!epsilon.ok()) return epsilon.status();
  certificate.epsilon_over_pi = *epsilon;
  if (member->contains("removed_vertex")) {
    const Json& removed = (*member)["removed_vertex"];
    if (!removed.is_number_integer()) {
      return Status::InvalidInput("infeasibility.removed_vertex: an index is needed");
    }
    // What is beyond 32 bits, or negative, is no vertex either.
    const auto wide = removed.get<std::int64_t>();
    certificate.removed_vertex = std::in_range<Index>(wide) && wide >= 0
                                     ? static_cast<Index>(wide)
                                     : std::numeric_limits<Index>::max();
  }
  const Status statuses[] = {
      ReadArray(*member, "face_multiplier", &certificate.face_multiplier),
      ReadArray(*member, "constrained_vertex", &certificate.constrained_vertex),
      ReadArray(*member, "lower_over_pi", &certificate.lower_over_pi),
      ReadArray(*member, "upper_over_pi", &certificate.upper_over_pi),
      ReadArray(*member, "vertex_multiplier", &certificate.vertex_multiplier),
      ReadArray(*member, "carrying_faces", &certificate.carrying_faces),
      ReadArray(*member, "carrying_vertices", &certificate.carrying_vertices),
  };
  for (const Status& status : statuses) {
    if (!status.ok()) return status;
  }
  if (!member->contains("triangle_face")) return certificate;
  for (const auto& [key, values] : {std::pair("triangle_face", &certificate.triangle_face),
                                    std::pair("triangle_corner", &certificate.triangle_corner)}) {
    if (Status s = ReadArray(*member, key, values); !s.ok()) return s;
  }
  return certificate;
}

StatusOr<InfeasibilityCertificate> ReadInfeasibilityCertificate(const std::string& path) {
  std::ifstream file(path);
  std::ostringstream content;
  if (!file || !(content << file.rdbuf())) {
    return Status::InvalidInput(fmt::format("{}: cannot be read", path));
  }
  StatusOr<InfeasibilityCertificate> certificate = ParseInfeasibilityCertificate(content.str());
  if (!certificate.ok()) return certificate.status().In(path);
  return certificate;
}

}  // namespace cirque::verify
