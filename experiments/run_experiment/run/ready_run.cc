#include "experiments/run_experiment/run/ready_run.h"

#include <exception>
#include <filesystem>
#include <new>

#include "cirque/core/atomic_file.h"
#include "cirque/core/solve_summary.h"
#include "cirque/io/io.h"

namespace cirque {
namespace {

namespace fs = std::filesystem;

RunResult RunCaught(const ReadyRun& ready, const RunFunction& carry_out) {
  RunResult result;
  const Timer timer;
  try {
    result = carry_out(ready.run, ready.mesh.path);
  } catch (const std::bad_alloc&) {
    result.certificate.outcome = ToString(StatusCode::kResource);
    result.certificate.message = "out of memory";
  } catch (const std::exception& error) {
    result.certificate.outcome = kException;
    result.certificate.message = error.what();
  }
  result.certificate.seconds.total = result.seconds > 0 ? result.seconds : timer.Seconds();
  return result;
}

/// `name` inside the run's folder, the folders above it made.
StatusOr<std::string> MakePath(const ReadyRun& ready, const std::string& name) {
  const fs::path path = fs::path(ready.folder) / name;
  std::error_code error;
  fs::create_directories(path.parent_path(), error);
  if (!error) return path.string();
  return Status::InvalidInput(path.parent_path().string() + ": cannot create: " + error.message());
}

Status WriteCertificate(const ReadyRun& ready, const std::string& name,
                        const Certificate& certificate) {
  const StatusOr<std::string> path = MakePath(ready, name);
  return path.ok() ? WriteFileAtomically(*path, certificate.ToJson()) : path.status();
}

Status WriteMap(const ReadyRun& ready, const std::string& stem, const RunResult& result) {
  const StatusOr<std::string> path = MakePath(ready, stem + ".obj");
  if (!path.ok()) return path.status();
  if (Status status = WriteMesh(*path, result.map); !status.ok()) return status;
  return WriteCertificate(ready, stem + ".certificate.json", result.certificate);
}

}  // namespace

StatusOr<Record> CarryOut(const ReadyRun& ready, const RunFunction& carry_out) {
  RunResult result = RunCaught(ready, carry_out);
  Record record = MakeRecord(ready.key, ready.run, ready.mesh, result, ready.provenance);
  // The record's message is valid UTF-8, whatever file names were in it.
  result.certificate.message = record["message"];
  // The files first: a record is the sign that the run is complete.
  if (OutcomeOf(record) == ToString(StatusCode::kInfeasible)) {
    const Status status =
        WriteCertificate(ready, "certificates/" + ready.key + ".json", result.certificate);
    if (!status.ok()) return status;
  }
  if (ready.run.keep_map && result.map.num_polygons() > 0) {
    const std::string stem = "maps/" + ready.key;
    if (Status status = WriteMap(ready, stem, result); !status.ok()) return status;
    record["map"] = stem + ".obj";
  }
  return record;
}

Record FailedRecord(const ReadyRun& ready, const std::string& outcome, const std::string& message,
                    double seconds) {
  RunResult result;
  result.certificate.outcome = outcome;
  result.certificate.message = message;
  result.certificate.seconds.total = seconds;
  return MakeRecord(ready.key, ready.run, ready.mesh, result, ready.provenance);
}

}  // namespace cirque
