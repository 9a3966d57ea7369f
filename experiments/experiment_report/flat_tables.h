#pragma once

#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "experiments/experiment_report/runs.h"

namespace cirque::experiment_report {

/// A table whose rows all have all columns, null where a run has no such value.
struct FlatTable {
  std::vector<std::string> columns;
  std::vector<std::vector<nlohmann::json>> rows;

  /// RFC 4180, numbers in shortest round-trip digits, null as nothing.
  std::string Csv() const;
  /// A list of objects, one a row: pandas.read_json and R's jsonlite::fromJSON make a frame of it.
  std::string Json() const;
};

/// One row a run: mesh, method, outcome, message, then all else, nested names joined by "_" (of
/// `values` and of `name` only the inner resp. the outer name stays). Histories are left out.
FlatTable RunTable(const std::vector<Run>& runs);

/// One row an iteration: key, mesh, method, stage, strategy, iteration, gradient.
FlatTable ConvergenceTable(const std::vector<Run>& runs);

}  // namespace cirque::experiment_report
