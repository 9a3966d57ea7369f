#pragma once

#include <string>

#include <nlohmann/json.hpp>

#include "experiments/experiment_report/runs.h"
#include "tests/common/temporary_folder.h"

namespace cirque {

/// A record as run_experiment writes it, of a map, its key made of mesh and method.
nlohmann::json ReportRecord(const std::string& mesh, const std::string& method, double seconds);

/// The records as a results.jsonl.
std::string JsonLines(const std::vector<nlohmann::json>& records);

/// The runs read back from a folder that holds these records.
experiment_report::Results ResultsOf(const std::vector<nlohmann::json>& records);

/// A square pyramid without base, cut open along one of its edges and laid flat without distortion,
/// as an OBJ with vt: its apex is a cone of the given angle sum.
std::string PyramidObj(double apex_angle);

}  // namespace cirque
