#include "experiments/run_experiment/run/job.h"

#include <exception>
#include <filesystem>

#include "cirque/core/atomic_file.h"
#include "cirque/core/solve_summary.h"
#include "cirque/io/io.h"

namespace cirque {
namespace {

namespace fs = std::filesystem;

RunResult RunCaught(const Job& job, const RunCell& run_cell) {
  RunResult result;
  const Timer timer;
  try {
    result = run_cell(job.cell, job.mesh.path);
  } catch (const std::exception& error) {
    result.certificate.outcome = kException;
    result.certificate.message = error.what();
  }
  result.certificate.seconds.total = result.seconds > 0 ? result.seconds : timer.Seconds();
  return result;
}

/// `name` inside the job's folder, the folders above it made.
StatusOr<std::string> MakePath(const Job& job, const std::string& name) {
  const fs::path path = fs::path(job.folder) / name;
  std::error_code error;
  fs::create_directories(path.parent_path(), error);
  if (!error) return path.string();
  return Status::InvalidInput(path.parent_path().string() + ": cannot create: " + error.message());
}

Status WriteCertificate(const Job& job, const std::string& name, const Certificate& certificate) {
  const StatusOr<std::string> path = MakePath(job, name);
  return path.ok() ? WriteFileAtomically(*path, certificate.ToJson()) : path.status();
}

Status WriteMap(const Job& job, const std::string& stem, const RunResult& result) {
  const StatusOr<std::string> path = MakePath(job, stem + ".obj");
  if (!path.ok()) return path.status();
  if (Status status = WriteMesh(*path, result.map); !status.ok()) return status;
  return WriteCertificate(job, stem + ".certificate.json", result.certificate);
}

}  // namespace

StatusOr<Record> CarryOut(const Job& job, const RunCell& run_cell) {
  RunResult result = RunCaught(job, run_cell);
  Record record = MakeRecord(job.key, job.cell, job.mesh, result, job.provenance);
  // The record's message is valid UTF-8, whatever file names were in it.
  result.certificate.message = record["message"];
  // The files first: a record is the sign that the run is complete.
  if (OutcomeOf(record) == ToString(StatusCode::kInfeasible)) {
    const Status status =
        WriteCertificate(job, "certificates/" + job.key + ".json", result.certificate);
    if (!status.ok()) return status;
  }
  if (job.cell.keep_map && result.map.num_polygons() > 0) {
    const std::string stem = "maps/" + job.key;
    if (Status status = WriteMap(job, stem, result); !status.ok()) return status;
    record["map"] = stem + ".obj";
  }
  return record;
}

Record FailedRecord(const Job& job, const std::string& outcome, const std::string& message,
                    double seconds) {
  RunResult result;
  result.certificate.outcome = outcome;
  result.certificate.message = message;
  result.certificate.seconds.total = seconds;
  return MakeRecord(job.key, job.cell, job.mesh, result, job.provenance);
}

}  // namespace cirque
