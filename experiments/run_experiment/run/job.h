#pragma once

#include <string>

#include "cirque/core/status.h"

#include "experiments/run_experiment/results/record.h"

namespace cirque {

/// A planned run with all that a process needs to carry it out.
struct Job {
  std::string key;
  Cell cell;
  LocatedMesh mesh;
  std::string folder;  ///< of the results
  nlohmann::json provenance;
};

/// A job as bytes and back, for a process of its own. Names keep their bytes, numbers all digits.
std::string PackJob(const Job& job);
StatusOr<Job> UnpackJob(const std::string& bytes);

/// Carries out a job and returns its record. First writes what belongs to it into the folder:
/// certificates/KEY.json of an infeasible run, and where the cell keeps its map maps/KEY.obj and
/// maps/KEY.certificate.json. Whatever the run throws is a record with outcome "exception".
StatusOr<Record> CarryOut(const Job& job, const RunCell& run_cell);

/// The record of a run whose process ended without one.
Record FailedRecord(const Job& job, const std::string& outcome, const std::string& message,
                    double seconds);

}  // namespace cirque
