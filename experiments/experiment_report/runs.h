#pragma once

#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "cirque/core/status.h"

namespace cirque::experiment_report {

/// One record of an experiment. What a record lacks is empty, or NaN.
struct Run {
  nlohmann::json record;
  std::string key, mesh, mesh_hash, method, radii_solver, angle_solver, outcome, message;
  std::string map;  ///< of the kept map, relative to the folder of the results
  double triangles = 0, seconds = 0;
  std::string link =
      {};  ///< its place in the page: of its map where that is shown, else of its row

  bool IsOk() const { return outcome == "ok"; }
  /// `/values/NAME` of the record.
  double Value(const std::string& name) const;
};

struct Results {
  std::vector<Run> runs;
  int superseded = 0;     ///< records left out for later ones of the same run, made by other code
  int skipped_lines = 0;  ///< that are no records, as the torn last one of a running experiment
};

/// The records of FOLDER/results.jsonl and FOLDER/results.shard-*.jsonl. Of two with one key the
/// one started later holds, of two that tell no time the later line. Error: no folder, no record.
StatusOr<Results> ReadResults(const std::string& folder);

}  // namespace cirque::experiment_report
