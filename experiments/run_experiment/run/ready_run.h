#pragma once

#include <string>

#include "cirque/core/status.h"

#include "experiments/run_experiment/results/record.h"

namespace cirque {

/// A planned run with all that a process needs to carry it out.
struct ReadyRun {
  std::string key;
  PlannedRun run;
  LocatedMesh mesh;
  std::string folder;  ///< of the results
  nlohmann::json provenance;
};

/// A run as bytes and back, for a process of its own. Names keep their bytes, numbers all digits.
std::string PackRun(const ReadyRun& ready);
StatusOr<ReadyRun> UnpackRun(const std::string& bytes);

/// Carries out a run and returns its record. First writes what belongs to it into the folder:
/// certificates/KEY.json of an infeasible run, and where the run keeps its map maps/KEY.obj and
/// maps/KEY.certificate.json. Whatever the run throws is a record with outcome "exception".
StatusOr<Record> CarryOut(const ReadyRun& ready, const RunFunction& carry_out);

/// The record of a run whose process ended without one.
Record FailedRecord(const ReadyRun& ready, const std::string& outcome, const std::string& message,
                    double seconds);

}  // namespace cirque
