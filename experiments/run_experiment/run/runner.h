#pragma once

#include <cstdio>
#include <functional>
#include <string>
#include <vector>

#include "cirque/core/status.h"

#include "experiments/run_experiment/config/config.h"
#include "experiments/run_experiment/config/planned_run.h"
#include "experiments/run_experiment/results/record.h"
#include "experiments/run_experiment/run/carry_out.h"

namespace cirque {

struct RunnerOptions {
  bool fresh = false;             ///< run finished runs again
  std::FILE* progress = nullptr;  ///< where progress is told, if anywhere
  /// Asked before every run and, where runs have processes of their own, while they go on: those
  /// are then ended without a record.
  std::function<bool()> stop = [] { return false; };
  Shard shard = {};       ///< the part of the runs to make
  int parallel_runs = 0;  ///< processes side by side; 0: all in this one, limits not held
  std::vector<std::string> worker = {};  ///< the command of such a process, see WorkerPool
};

/// How an experiment ended.
struct RunSummary {
  std::vector<Record> records;  ///< of the selected runs, in their order, as far as it came
  int ran = 0;                  ///< how many of them are new
  int skipped_lines = 0;        ///< unreadable lines found in results.jsonl
  bool stopped = false;         ///< whether it was asked to stop before the last run

  /// Whether all runs have been made and each ended in a map or an infeasibility certificate.
  bool AllSettled() const;
};

/// Makes the runs of the shard's `runs` that config.output does not hold yet and writes there:
/// results.jsonl or the shard's own file (a line as soon as a run ends), what CarryOut writes, and
/// figures.json, the figures that the config asks the report for.
/// Without a shard also results.csv, and the shards' records are taken into results.jsonl first.
StatusOr<RunSummary> RunExperiment(const ExperimentConfig& config,
                                   const std::vector<PlannedRun>& runs,
                                   const RunnerOptions& options, const RunFunction& carry_out);

}  // namespace cirque
