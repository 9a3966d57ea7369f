#include "experiments/run_experiment/runner.h"

#include <algorithm>
#include <exception>
#include <filesystem>
#include <map>

#include "cirque/core/atomic_file.h"
#include "cirque/core/timer.h"

#include "experiments/run_experiment/columns.h"
#include "experiments/run_experiment/mesh_files.h"
#include "experiments/run_experiment/progress.h"
#include "experiments/run_experiment/provenance.h"
#include "experiments/run_experiment/results_log.h"

namespace cirque {
namespace {

namespace fs = std::filesystem;

struct PlannedRun {
  Cell cell;
  LocatedMesh mesh;
  std::string key;
};

/// Locates every mesh, so that nothing has been run when one of them turns out to be missing.
StatusOr<std::vector<PlannedRun>> Plan(const std::vector<Cell>& cells, const std::string& cache,
                                       const std::string& code_version) {
  std::map<std::string, LocatedMesh> located;
  std::vector<PlannedRun> plan;
  for (const Cell& cell : cells) {
    if (!located.contains(cell.mesh.name)) {
      const StatusOr<LocatedMesh> mesh = LocateMesh(cell.mesh, cache);
      if (!mesh.ok()) return mesh.status();
      located[cell.mesh.name] = *mesh;
    }
    const LocatedMesh& mesh = located[cell.mesh.name];
    plan.push_back({cell, mesh, RunKey(cell, mesh.hash, code_version)});
  }
  return plan;
}

RunResult RunCaught(const RunCell& run_cell, const PlannedRun& run) {
  RunResult result;
  const Timer timer;
  try {
    result = run_cell(run.cell, run.mesh.path);
  } catch (const std::exception& error) {
    result.certificate.outcome = "exception";
    result.certificate.message = error.what();
  }
  result.certificate.seconds["total"] = timer.Seconds();
  return result;
}

class Runner {
 public:
  Runner(const std::string& folder, nlohmann::json provenance, const RunnerOptions& options,
         const RunCell& run_cell, ResultsLog log)
      : options_(options),
        run_cell_(run_cell),
        log_(std::move(log)),
        folder_(folder),
        provenance_(std::move(provenance)) {}

  StatusOr<RunSummary> Run(const std::vector<PlannedRun>& plan);

 private:
  bool IsDone(const PlannedRun& run) const {
    const Record* record = options_.fresh ? nullptr : log_.Find(run.key);
    return record != nullptr && IsFinished(*record);
  }
  Status RunOne(const PlannedRun& run, Progress* progress);
  Status SaveCertificate(const PlannedRun& run, const Certificate& certificate) const;
  RunSummary Summarize(const std::vector<PlannedRun>& plan) const;

  const RunnerOptions& options_;
  const RunCell& run_cell_;
  ResultsLog log_;
  fs::path folder_;
  nlohmann::json provenance_;
};

StatusOr<RunSummary> Runner::Run(const std::vector<PlannedRun>& plan) {
  std::vector<PlannedRun> left;
  std::remove_copy_if(plan.begin(), plan.end(), std::back_inserter(left),
                      [&](const PlannedRun& run) { return IsDone(run); });
  Progress progress(options_.progress, static_cast<int>(plan.size()),
                    static_cast<int>(plan.size() - left.size()));
  int ran = 0;
  for (const PlannedRun& run : left) {
    if (options_.stop()) break;
    if (Status status = RunOne(run, &progress); !status.ok()) return status;
    ++ran;
  }
  const Status written =
      WriteFileAtomically((folder_ / "results.csv").string(), ToCsv(log_.Records()));
  if (!written.ok()) return written;
  RunSummary summary = Summarize(plan);
  summary.ran = ran;
  summary.stopped = ran < static_cast<int>(left.size());
  return summary;
}

Status Runner::RunOne(const PlannedRun& run, Progress* progress) {
  progress->Start(run.cell.Label());
  nlohmann::json provenance = provenance_;
  provenance["started"] = UtcNow();
  RunResult result = RunCaught(run_cell_, run);
  const Record record = MakeRecord(run.key, run.cell, run.mesh, result, provenance);
  // The certificate first: a record is the sign that the run is complete.
  if (OutcomeOf(record) == ToString(StatusCode::kInfeasible)) {
    // The record's message is valid UTF-8, whatever file names were in it.
    result.certificate.message = record["message"];
    if (Status status = SaveCertificate(run, result.certificate); !status.ok()) return status;
  }
  if (Status status = log_.Append(record); !status.ok()) return status;
  progress->Finish(run.cell.Label(), record);
  return Status();
}

Status Runner::SaveCertificate(const PlannedRun& run, const Certificate& certificate) const {
  const fs::path folder = folder_ / "certificates";
  std::error_code error;
  fs::create_directories(folder, error);
  return WriteFileAtomically((folder / (run.key + ".json")).string(), certificate.ToJson());
}

RunSummary Runner::Summarize(const std::vector<PlannedRun>& plan) const {
  RunSummary summary;
  summary.skipped_lines = log_.skipped_lines();
  for (const PlannedRun& run : plan) {
    if (const Record* record = log_.Find(run.key)) summary.records.push_back(*record);
  }
  return summary;
}

}  // namespace

bool RunSummary::AllSettled() const {
  return !stopped && std::all_of(records.begin(), records.end(), IsSettled);
}

StatusOr<RunSummary> RunExperiment(const ExperimentConfig& config, const std::vector<Cell>& cells,
                                   const RunnerOptions& options, const RunCell& run_cell) {
  const fs::path folder = config.output;
  nlohmann::json provenance = Provenance(config);
  const StatusOr<std::vector<PlannedRun>> plan =
      Plan(cells, (folder / "meshes").string(), provenance["code"]);
  if (!plan.ok()) return plan.status();
  std::error_code error;
  fs::create_directories(folder, error);
  if (error) return Status::InvalidInput(folder.string() + ": cannot create: " + error.message());
  StatusOr<ResultsLog> log = ResultsLog::Open((folder / "results.jsonl").string());
  if (!log.ok()) return log.status();
  return Runner(config.output, std::move(provenance), options, run_cell, *std::move(log))
      .Run(*plan);
}

}  // namespace cirque
