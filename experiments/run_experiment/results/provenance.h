#pragma once

#include <string>

#include <nlohmann/json.hpp>

#include "experiments/run_experiment/config/config.h"

namespace cirque {

/// What names the code: the git commit, and where that says too little (changes not committed, no
/// git) also the hash of this program's own file.
std::string CodeVersion();

/// What every record tells about where it comes from: version, commit, compiler, libraries, CPU,
/// threads, the config and its hash.
nlohmann::json Provenance(const ExperimentConfig& config);

/// The present time as ISO 8601 in UTC.
std::string UtcNow();

}  // namespace cirque
