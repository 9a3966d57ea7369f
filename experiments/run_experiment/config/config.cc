#include "experiments/run_experiment/config/config.h"

#include <algorithm>
#include <filesystem>
#include <optional>
#include <set>

#include <fmt/format.h>
#include <yaml-cpp/yaml.h>

#include "experiments/run_experiment/config/config_text.h"
#include "experiments/run_experiment/config/entries.h"
#include "experiments/run_experiment/config/file_content.h"
#include "experiments/run_experiment/config/peer_programs.h"
#include "experiments/run_experiment/config/schema.h"
#include "experiments/run_experiment/config/yaml_document.h"

namespace cirque {
namespace {

namespace fs = std::filesystem;

/// Beyond this, a list of values is more likely a slip than a study.
constexpr double kMaxRuns = 100000;

/// The folder that holds configs/, or the config's own folder when it lies elsewhere.
std::string RootOf(const std::string& path) {
  const fs::path folder = fs::absolute(path).lexically_normal().parent_path();
  for (fs::path p = folder; p.has_relative_path(); p = p.parent_path()) {
    if (p.filename() == "configs") return p.parent_path().string();
  }
  return folder.string();
}

/// Counts the entries' combinations before anything is expanded, so that a slip cannot fill the
/// memory.
bool IsExpandable(const YAML::Node& document, Diagnostics* problems) {
  for (const char* list : {"meshes", "methods"}) {
    const YAML::Node entries = document[list];
    if (!entries || !entries.IsSequence()) continue;
    double count = 0;
    for (const YAML::Node& entry : entries) {
      if (!entry.IsMap()) continue;
      const double seeds = entry["generator"] ? ItemsOf(document["seeds"]).size() : 1;
      count += std::max(seeds, 1.0) * CountCombinations(AxesOf(entry, ConfigSchema(), list));
      if (count <= kMaxRuns) continue;
      problems->Add(PlaceOf(entry), fmt::format("with this entry '{}' makes {} combinations; at "
                                                "most {} are allowed",
                                                list, count, kMaxRuns));
      return false;
    }
  }
  return true;
}

/// The list `seeds`, checked where it stands.
std::vector<std::string> ReadSeeds(const YAML::Node& value, const YAML::Node& meshes,
                                   Diagnostics* problems) {
  if (!value) return {};
  std::vector<std::string> seeds = DistinctItems(value, problems);
  const bool some_generated =
      meshes && meshes.IsSequence() &&
      std::any_of(meshes.begin(), meshes.end(),
                  [](const YAML::Node& entry) { return entry.IsMap() && entry["generator"]; });
  if (!some_generated) {
    problems->Add(PlaceOf(value),
                  "'seeds' has a meaning for generated meshes only: nothing here is random");
  }
  return seeds;
}

void CheckRuns(const ExperimentConfig& config, Diagnostics* problems) {
  if (config.runs.empty()) {
    problems->Add({}, "nothing to run: every mesh was skipped");
  }
  std::set<std::string> labels;
  for (const PlannedRun& run : config.runs) {
    if (!labels.insert(run.Label()).second) {
      problems->Add({},
                    fmt::format("two runs are called '{}'; is a value listed twice?", run.Label()));
    }
  }
}

void Fill(const YAML::Node& document, Diagnostics* problems, ExperimentConfig* config) {
  const std::string root = RootOf(config->path);
  const auto seeds = ReadSeeds(document["seeds"], document["meshes"], problems);
  MeshEntries entries = ResolveMeshes(document["meshes"], root, seeds, problems);
  if (!problems->empty()) return;
  config->figures = ReadFigures(document["figures"], problems);
  std::vector<MethodSpec> methods = ReadMethods(document["methods"], root, problems);
  const auto peers = ReadPeers(document["peer"], root, problems, &entries.notes);
  methods.insert(methods.end(), peers.begin(), peers.end());
  const int repeats = static_cast<int>(*ParseInteger(TextOr(document, "repeats", "1")));
  const double count = static_cast<double>(entries.meshes.size() * methods.size()) * repeats;
  if (count > kMaxRuns) {
    return problems->Add({}, fmt::format("{} runs; at most {} are allowed", count, kMaxRuns));
  }
  config->question = document["question"].Scalar();
  config->notes = std::move(entries.notes);
  config->runs = PlanRuns(entries.meshes, methods, repeats);
  const std::string output = TextOr(document, "output", "results/runs/" + config->name);
  config->output = (fs::path(root) / output).lexically_normal().string();
  if (problems->empty()) CheckRuns(*config, problems);
  if (problems->empty()) ApplyRunSettings(document, entries.some_skipped, problems, config);
}

}  // namespace

StatusOr<ExperimentConfig> ParseConfig(const std::string& path, const std::string& text) {
  ExperimentConfig config;
  config.path = path;
  config.name = fs::path(path).stem().string();
  config.hash = HashOf(text);
  Diagnostics problems(path, text);
  if (const std::optional<YAML::Node> document = ParseYaml(text, &problems)) {
    config.renamed = UseNewWords(*document, ConfigSchema(), problems);
    Validate(*document, ConfigSchema(), &problems);
    if (document->IsMap() && IsExpandable(*document, &problems)) {
      Fill(*document, &problems, &config);
    }
  }
  if (!problems.empty()) return Status::InvalidInput(problems.Text());
  return config;
}

StatusOr<ExperimentConfig> LoadConfig(const std::string& path) {
  const StatusOr<std::string> text = ReadWholeFile(path);
  return text.ok() ? ParseConfig(path, *text) : text.status();
}

}  // namespace cirque
