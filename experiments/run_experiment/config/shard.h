#pragma once

#include <string>
#include <vector>

#include "cirque/core/status.h"

#include "experiments/run_experiment/config/planned_run.h"

namespace cirque {

/// One of several parts of an experiment that are run apart, on machines that share the folder.
struct Shard {
  int index = 1, count = 1;  ///< from 1 to count

  bool IsWhole() const { return count == 1; }
  /// Where the part's records are kept: results.jsonl, or results.shard-2-of-8.jsonl.
  std::string FileName() const;
};

/// Reads "2/8".
StatusOr<Shard> ParseShard(const std::string& text);

/// The shard's runs in their order. Together the shards have every run once; which run goes
/// where hangs on its name alone, so that slow methods and large meshes are spread.
std::vector<PlannedRun> SelectShard(const std::vector<PlannedRun>& runs, const Shard& shard);

}  // namespace cirque
