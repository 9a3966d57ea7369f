#pragma once

#include <string>
#include <vector>

#include <nlohmann/json.hpp>
#include <yaml-cpp/yaml.h>

#include "cirque/core/status.h"

#include "experiments/run_experiment/config/config_text.h"
#include "experiments/run_experiment/config/planned_run.h"

namespace cirque {

/// An experiment as its config file describes it, every reference resolved.
struct ExperimentConfig {
  std::string path;
  std::string name;  ///< of the file, without folder and extension
  std::string hash;  ///< of the file's content
  std::string question;
  std::vector<PlannedRun> runs;
  nlohmann::json figures = nlohmann::json::array();  ///< as ReadFigures makes them
  std::string output;                                ///< absolute folder
  std::vector<std::string> notes;                    ///< what was left out or chosen, and why
  std::vector<std::string> renamed;                  ///< where words stand that are others now
};

/// Reads and checks a config. The message of a failure lists every problem as
/// "file:line:column: ..." with the source line; nothing is written.
StatusOr<ExperimentConfig> LoadConfig(const std::string& path);

/// The same from the file's text; `path` says where it lies.
StatusOr<ExperimentConfig> ParseConfig(const std::string& path, const std::string& text);

/// Takes to the runs what a config says of them all: `include` and `exclude`, `time_limit` and
/// `memory_limit`, `keep_maps`, `reference`, `measures`. A pattern that names no run is a problem,
/// unless `some_skipped`: it may have meant runs on meshes that do not exist here.
void ApplyRunSettings(const YAML::Node& document, bool some_skipped, Diagnostics* problems,
                      ExperimentConfig* config);

}  // namespace cirque
