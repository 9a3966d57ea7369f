#pragma once

#include <cstdio>
#include <functional>
#include <vector>

#include "cirque/core/status.h"

#include "experiments/run_experiment/config.h"
#include "experiments/run_experiment/record.h"
#include "experiments/run_experiment/run_cell.h"

namespace cirque {

struct RunnerOptions {
  bool fresh = false;                                 ///< run finished cells again
  std::FILE* progress = nullptr;                      ///< where progress is told, if anywhere
  std::function<bool()> stop = [] { return false; };  ///< asked before every run
};

/// How an experiment ended.
struct RunSummary {
  std::vector<Record> records;  ///< of the selected cells, in their order, as far as it came
  int ran = 0;                  ///< how many of them are new
  int skipped_lines = 0;        ///< unreadable lines found in results.jsonl
  bool stopped = false;         ///< whether it was asked to stop before the last run

  /// Whether all runs have been made and each ended in a map or a proof that there is none.
  bool AllSettled() const;
};

/// Makes the runs of `cells` that config.output does not hold yet and writes there: results.jsonl
/// (a line as soon as a run ends), results.csv, and certificates/KEY.json of infeasible runs.
/// Whatever a run throws becomes its record with outcome "exception".
StatusOr<RunSummary> RunExperiment(const ExperimentConfig& config, const std::vector<Cell>& cells,
                                   const RunnerOptions& options, const RunCell& run_cell);

}  // namespace cirque
