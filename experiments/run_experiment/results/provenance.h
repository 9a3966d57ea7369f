#pragma once

#include <string>

#include <nlohmann/json.hpp>

#include "experiments/run_experiment/config/config.h"

namespace cirque {

/// What every record tells about where it comes from: version, commit, compiler, libraries, CPU,
/// threads, the config and its hash.
nlohmann::json Provenance(const ExperimentConfig& config);

/// The present time as ISO 8601 in UTC.
std::string UtcNow();

}  // namespace cirque
