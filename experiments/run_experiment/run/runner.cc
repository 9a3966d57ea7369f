#include "experiments/run_experiment/run/runner.h"

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <map>
#include <utility>

#include "cirque/core/atomic_file.h"

#include "experiments/run_experiment/results/columns.h"
#include "experiments/run_experiment/results/provenance.h"
#include "experiments/run_experiment/results/record.h"
#include "experiments/run_experiment/results/results_log.h"
#include "experiments/run_experiment/results/run_code.h"
#include "experiments/run_experiment/run/mesh_files.h"
#include "experiments/run_experiment/run/progress.h"
#include "experiments/run_experiment/run/ready_run.h"
#include "experiments/run_experiment/run/worker_pool.h"

namespace cirque {
namespace {

namespace fs = std::filesystem;

/// Reads every file, so that nothing has been run when one of them turns out to be missing.
StatusOr<std::vector<ReadyRun>> Plan(const std::vector<PlannedRun>& runs, const std::string& folder,
                                     const nlohmann::json& provenance) {
  const std::string cache = (fs::path(folder) / "meshes").string();
  std::vector<MeshSpec> meshes;
  for (const PlannedRun& run : runs) meshes.push_back(run.mesh);
  if (Status s = ExtractMembers(meshes, cache); !s.ok()) return s;
  std::map<std::string, LocatedMesh> located;
  std::vector<ReadyRun> plan;
  for (const PlannedRun& run : runs) {
    if (!located.contains(run.mesh.name)) {
      const StatusOr<LocatedMesh> mesh = LocateMesh(run.mesh, cache);
      if (!mesh.ok()) return mesh.status();
      located[run.mesh.name] = *mesh;
    }
    const LocatedMesh& mesh = located[run.mesh.name];
    const StatusOr<nlohmann::json> method = MethodByContent(run.method);
    if (!method.ok()) return method.status();
    nlohmann::json origin = provenance;
    origin["code"] = RunCode(run.method);
    const std::string key = RunKey(run, mesh.hash, *method, origin["code"]);
    plan.push_back({key, run, mesh, folder, std::move(origin)});
  }
  return plan;
}

/// A run that was begun without the map kept, or whose map was removed, has to be made again.
bool IsComplete(const ReadyRun& ready, const Record& record) {
  std::error_code error;
  return IsFinished(record, ready.run) &&
         (!ready.run.keep_map || !record.contains("map") ||
          fs::exists(fs::path(ready.folder) / record["map"].get<std::string>(), error));
}

class Runner {
 public:
  Runner(const RunnerOptions& options, const RunFunction& carry_out, ResultsLog* log,
         Progress* progress)
      : options_(options), carry_out_(carry_out), log_(*log), progress_(*progress) {}

  /// Makes the runs, one after the other or side by side.
  Status Run(const std::vector<ReadyRun>& ready_runs) {
    return options_.parallel_runs == 0 ? RunHere(ready_runs) : RunInProcesses(ready_runs);
  }
  int ran() const { return ran_; }

 private:
  Status RunHere(const std::vector<ReadyRun>& ready_runs);
  Status RunInProcesses(const std::vector<ReadyRun>& ready_runs);
  ReadyRun Begin(ReadyRun ready) const;
  Status Keep(const EndedRun& run);

  const RunnerOptions& options_;
  const RunFunction& carry_out_;
  ResultsLog& log_;
  Progress& progress_;
  int ran_ = 0;
};

Status Runner::RunHere(const std::vector<ReadyRun>& ready_runs) {
  for (const ReadyRun& ready : ready_runs) {
    if (options_.stop()) break;
    StatusOr<Record> record = CarryOut(Begin(ready), carry_out_);
    if (!record.ok()) return record.status();
    if (Status s = Keep({ready.run.Label(), *std::move(record)}); !s.ok()) return s;
  }
  return Status();
}

Status Runner::RunInProcesses(const std::vector<ReadyRun>& ready_runs) {
  WorkerPool pool(options_.parallel_runs, options_.worker);
  auto next = ready_runs.begin();
  while ((next != ready_runs.end() || !pool.is_idle()) && !options_.stop()) {
    while (next != ready_runs.end() && pool.has_room()) {
      if (Status status = pool.Start(Begin(*next++)); !status.ok()) return status;
    }
    for (const EndedRun& run : pool.TakeEnded()) {
      if (Status status = Keep(run); !status.ok()) return status;
    }
  }
  return Status();
}

ReadyRun Runner::Begin(ReadyRun ready) const {
  progress_.Start(ready.run.Label());
  ready.provenance["started"] = UtcNow();
  return ready;
}

Status Runner::Keep(const EndedRun& run) {
  if (Status status = log_.Append(run.record); !status.ok()) return status;
  ++ran_;
  progress_.Finish(run.label, run.record);
  return Status();
}

RunSummary Summarize(const std::vector<ReadyRun>& plan, const ResultsLog& log) {
  RunSummary summary;
  summary.skipped_lines = log.skipped_lines();
  for (const ReadyRun& ready : plan) {
    if (const Record* record = log.Find(ready.key)) summary.records.push_back(*record);
  }
  return summary;
}

/// What the log does not hold yet.
std::vector<ReadyRun> Left(const std::vector<ReadyRun>& plan, const ResultsLog& log, bool fresh) {
  std::vector<ReadyRun> left;
  std::copy_if(plan.begin(), plan.end(), std::back_inserter(left), [&](const ReadyRun& ready) {
    const Record* record = log.Find(ready.key);
    return fresh || record == nullptr || !IsComplete(ready, *record);
  });
  return left;
}

}  // namespace

bool RunSummary::AllSettled() const {
  return !stopped && std::all_of(records.begin(), records.end(), IsSettled);
}

StatusOr<RunSummary> RunExperiment(const ExperimentConfig& config,
                                   const std::vector<PlannedRun>& runs,
                                   const RunnerOptions& options, const RunFunction& carry_out) {
  const fs::path folder = config.output;
  const StatusOr<std::vector<ReadyRun>> plan =
      Plan(SelectShard(runs, options.shard), folder.string(), Provenance(config));
  if (!plan.ok()) return plan.status();
  std::error_code error;
  fs::create_directories(folder, error);
  if (error) return Status::InvalidInput(folder.string() + ": cannot create: " + error.message());
  StatusOr<ResultsLog> log = ResultsLog::Open(folder.string(), options.shard);
  if (!log.ok()) return log.status();
  const std::string figures =
      config.figures.dump(1, ' ', false, nlohmann::json::error_handler_t::replace);
  if (Status s = WriteFileAtomically(folder / "figures.json", figures + "\n"); !s.ok()) return s;
  const bool is_whole = options.shard.IsWhole();
  if (Status s = is_whole ? log->Merge() : Status(); !s.ok()) return s;

  const std::vector<ReadyRun> left = Left(*plan, *log, options.fresh);
  Progress progress(options.progress, static_cast<int>(plan->size()),
                    static_cast<int>(plan->size() - left.size()));
  Runner runner(options, carry_out, &*log, &progress);
  if (Status s = runner.Run(left); !s.ok()) return s;
  RunSummary summary = Summarize(*plan, *log);
  summary.ran = runner.ran();
  summary.stopped = summary.ran < static_cast<int>(left.size());
  // The parts of one table are no table.
  if (!is_whole) return summary;
  const Status written = WriteFileAtomically(folder / "results.csv", ToCsv(log->Records()));
  return written.ok() ? StatusOr<RunSummary>(std::move(summary)) : written;
}

}  // namespace cirque
