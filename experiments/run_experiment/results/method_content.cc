#include "experiments/run_experiment/results/method_content.h"

#include <string>

#include "cirque/core/name_with_options.h"

#include "experiments/run_experiment/config/content_hash.h"
#include "experiments/run_experiment/results/record.h"

namespace cirque {
namespace {

StatusOr<std::string> HashOfFile(const std::string& path) {
  const StatusOr<std::string> content = ReadWholeFile(path);
  return content.ok() ? StatusOr<std::string>(HashOf(*content)) : content.status();
}

/// Puts the hash of the cone file into the place of its name, where the heuristic reads one. Words
/// that are no heuristic with options are the run's to refuse.
Status HashConeFile(const std::string& cones, nlohmann::json* method) {
  StatusOr<NameWithOptions> named = ParseNameWithOptions(cones);
  if (!named.ok() || named->name != "given" || !named->options.contains("file")) return Status();
  const StatusOr<std::string> hash = HashOfFile(named->options["file"]);
  if (!hash.ok()) return hash.status().In("cones");
  named->options["file"] = *hash;
  (*method)["cones"] = {{"name", named->name}, {"options", named->options}};
  return Status();
}

}  // namespace

StatusOr<nlohmann::json> MethodByContent(const MethodSpec& method) {
  nlohmann::json json = MethodJson(method);
  const ParameterizeOptions& options = method.options;
  if (!options.edge_costs.empty()) {
    const StatusOr<std::string> hash = HashOfFile(options.edge_costs);
    if (!hash.ok()) return hash.status().In("edge_costs");
    json["edge_costs"] = *hash;
  }
  if (Status status = HashConeFile(options.cones, &json); !status.ok()) return status;
  return json;
}

}  // namespace cirque
