#include "experiments/experiment_report/runs.h"

#include <filesystem>
#include <fstream>
#include <map>
#include <optional>

#include <fmt/format.h>

#include "experiments/common/records.h"

namespace cirque::experiment_report {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

/// Records of earlier releases have the methods' keys by their old names.
void UseNewNames(json* record) {
  const auto method = record->find("method");
  if (method == record->end() || !method->is_object()) return;
  for (const auto& [former, now] : {std::pair{"angle_fit", "angle_objective"},
                                    {"angle_strategy", "angle_solver"},
                                    {"strategy", "radii_solver"}}) {
    if (!method->contains(former)) continue;
    (*method)[now] = std::move((*method)[former]);
    method->erase(former);
  }
}

Run MakeRun(json record) {
  UseNewNames(&record);
  Run run;
  run.key = TextAt(record, "/key");
  run.mesh = TextAt(record, "/mesh/name");
  run.mesh_hash = TextAt(record, "/mesh/hash");
  run.method = TextAt(record, "/method/name");
  run.radii_solver = TextAt(record, "/method/radii_solver");
  run.angle_solver = TextAt(record, "/method/angle_solver");
  run.outcome = TextAt(record, "/outcome");
  run.message = TextAt(record, "/message");
  run.map = TextAt(record, "/map");
  run.triangles = NumberAt(record, "/mesh/triangles");
  run.seconds = NumberAt(record, "/seconds/total");
  run.record = std::move(record);
  return run;
}

std::string Started(const Run& run) { return TextAt(run.record, "/provenance/started"); }

/// What a run is of, whichever code made it: the record without what came out.
std::string Identity(const Run& run) {
  json identity = run.record;
  for (const char* name :
       {"key", "outcome", "message", "overlap", "values", "seconds", "history", "map", "provenance",
        "peak_memory_mib", "cpu_seconds", "map_cpu_seconds", "reference", "limits"}) {
    identity.erase(name);
  }
  // In older records: who chose an option, which is no part of what the method is.
  if (identity.contains("method") && identity["method"].is_object()) {
    identity["method"].erase("recommended");
  }
  identity["mesh"] = {run.mesh, run.mesh_hash};
  return run.mesh.empty() || run.method.empty() ? run.key : identity.dump();
}

class Collector {
 public:
  void Add(const std::string& file) {
    std::ifstream stream(file, std::ios::binary);
    for (std::string line; std::getline(stream, line);) {
      if (line.empty()) continue;
      if (std::optional<json> record = ParseRecord(line)) {
        Keep(MakeRun(*std::move(record)));
      } else {
        ++results_.skipped_lines;
      }
    }
  }
  Results Take() { return std::move(results_); }

 private:
  void Keep(Run run) {
    const std::string identity = Identity(run);
    auto found = position_.find("key " + run.key);
    if (found == position_.end()) found = position_.find(identity);
    const std::size_t place = found == position_.end() ? results_.runs.size() : found->second;
    position_["key " + run.key] = position_[identity] = place;
    if (place == results_.runs.size()) {
      results_.runs.push_back(std::move(run));
      return;
    }
    Run& kept = results_.runs[place];
    if (kept.key != run.key) ++results_.superseded;
    if (Started(run) >= Started(kept)) kept = std::move(run);
  }

  Results results_;
  std::map<std::string, std::size_t> position_;  ///< of keys and of identities
};

}  // namespace

double Run::Value(const std::string& name) const {
  return NumberAt(record, (json::json_pointer("/values") / name).to_string());
}

StatusOr<Results> ReadResults(const std::string& folder) {
  std::error_code error;
  if (!fs::is_directory(folder, error)) {
    return Status::InvalidInput(
        fmt::format("{}: no such folder; name the `output` of an experiment's config", folder));
  }
  const std::vector<std::string> files = RecordFiles(folder);
  Collector collector;
  for (const std::string& file : files) collector.Add(file);
  Results results = collector.Take();
  if (!results.runs.empty()) return results;
  return Status::InvalidInput(
      files.empty() ? fmt::format("{}: holds no results.jsonl: run_experiment has not run there, "
                                  "or no run of it has ended yet",
                                  folder)
                    : fmt::format("{}: holds no record yet ({} unreadable): wait for the first run "
                                  "to end",
                                  files.front(), results.skipped_lines));
}

}  // namespace cirque::experiment_report
