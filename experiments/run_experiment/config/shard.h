#pragma once

#include <string>
#include <vector>

#include "cirque/core/status.h"

#include "experiments/run_experiment/config/cells.h"

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

/// The shard's cells in their order. Together the shards have every cell once; which cell goes
/// where hangs on its name alone, so that slow methods and large meshes are spread.
std::vector<Cell> SelectShard(const std::vector<Cell>& cells, const Shard& shard);

}  // namespace cirque
