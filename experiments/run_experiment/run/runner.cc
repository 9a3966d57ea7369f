#include "experiments/run_experiment/run/runner.h"

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <map>

#include "cirque/core/atomic_file.h"

#include "experiments/run_experiment/results/columns.h"
#include "experiments/run_experiment/results/method_content.h"
#include "experiments/run_experiment/results/provenance.h"
#include "experiments/run_experiment/results/results_log.h"
#include "experiments/run_experiment/run/job.h"
#include "experiments/run_experiment/run/mesh_files.h"
#include "experiments/run_experiment/run/progress.h"
#include "experiments/run_experiment/run/worker_pool.h"

namespace cirque {
namespace {

namespace fs = std::filesystem;

/// Reads every file, so that nothing has been run when one of them turns out to be missing.
StatusOr<std::vector<Job>> Plan(const std::vector<Cell>& cells, const std::string& folder,
                                const nlohmann::json& provenance) {
  std::map<std::string, LocatedMesh> located;
  std::vector<Job> plan;
  for (const Cell& cell : cells) {
    if (!located.contains(cell.mesh.name)) {
      const StatusOr<LocatedMesh> mesh =
          LocateMesh(cell.mesh, (fs::path(folder) / "meshes").string());
      if (!mesh.ok()) return mesh.status();
      located[cell.mesh.name] = *mesh;
    }
    const LocatedMesh& mesh = located[cell.mesh.name];
    const StatusOr<nlohmann::json> method = MethodByContent(cell.method);
    if (!method.ok()) return method.status();
    const std::string key = RunKey(cell, mesh.hash, *method, provenance["code"]);
    plan.push_back({key, cell, mesh, folder, provenance});
  }
  return plan;
}

/// A run that was begun without the map kept, or whose map was removed, has to be made again.
bool IsComplete(const Job& job, const Record& record) {
  std::error_code error;
  return IsFinished(record, job.cell) &&
         (!job.cell.keep_map || !record.contains("map") ||
          fs::exists(fs::path(job.folder) / record["map"].get<std::string>(), error));
}

class Runner {
 public:
  Runner(const RunnerOptions& options, const RunCell& run_cell, ResultsLog* log, Progress* progress)
      : options_(options), run_cell_(run_cell), log_(*log), progress_(*progress) {}

  /// Makes the runs, one after the other or side by side.
  Status Run(const std::vector<Job>& jobs) {
    return options_.jobs == 0 ? RunHere(jobs) : RunInProcesses(jobs);
  }
  int ran() const { return ran_; }

 private:
  Status RunHere(const std::vector<Job>& jobs);
  Status RunInProcesses(const std::vector<Job>& jobs);
  Job Begin(Job job) const;
  Status Keep(const EndedRun& run);

  const RunnerOptions& options_;
  const RunCell& run_cell_;
  ResultsLog& log_;
  Progress& progress_;
  int ran_ = 0;
};

Status Runner::RunHere(const std::vector<Job>& jobs) {
  for (const Job& job : jobs) {
    if (options_.stop()) break;
    StatusOr<Record> record = CarryOut(Begin(job), run_cell_);
    if (!record.ok()) return record.status();
    if (Status s = Keep({job.cell.Label(), *std::move(record)}); !s.ok()) return s;
  }
  return Status();
}

Status Runner::RunInProcesses(const std::vector<Job>& jobs) {
  WorkerPool pool(options_.jobs, options_.worker);
  auto next = jobs.begin();
  while ((next != jobs.end() || !pool.is_idle()) && !options_.stop()) {
    while (next != jobs.end() && pool.has_room()) {
      if (Status status = pool.Start(Begin(*next++)); !status.ok()) return status;
    }
    for (const EndedRun& run : pool.TakeEnded()) {
      if (Status status = Keep(run); !status.ok()) return status;
    }
  }
  return Status();
}

Job Runner::Begin(Job job) const {
  progress_.Start(job.cell.Label());
  job.provenance["started"] = UtcNow();
  return job;
}

Status Runner::Keep(const EndedRun& run) {
  if (Status status = log_.Append(run.record); !status.ok()) return status;
  ++ran_;
  progress_.Finish(run.label, run.record);
  return Status();
}

RunSummary Summarize(const std::vector<Job>& plan, const ResultsLog& log) {
  RunSummary summary;
  summary.skipped_lines = log.skipped_lines();
  for (const Job& job : plan) {
    if (const Record* record = log.Find(job.key)) summary.records.push_back(*record);
  }
  return summary;
}

/// What the log does not hold yet.
std::vector<Job> Left(const std::vector<Job>& plan, const ResultsLog& log, bool fresh) {
  std::vector<Job> left;
  std::copy_if(plan.begin(), plan.end(), std::back_inserter(left), [&](const Job& job) {
    const Record* record = log.Find(job.key);
    return fresh || record == nullptr || !IsComplete(job, *record);
  });
  return left;
}

}  // namespace

bool RunSummary::AllSettled() const {
  return !stopped && std::all_of(records.begin(), records.end(), IsSettled);
}

StatusOr<RunSummary> RunExperiment(const ExperimentConfig& config, const std::vector<Cell>& cells,
                                   const RunnerOptions& options, const RunCell& run_cell) {
  const fs::path folder = config.output;
  const StatusOr<std::vector<Job>> plan =
      Plan(SelectShard(cells, options.shard), folder.string(), Provenance(config));
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

  const std::vector<Job> left = Left(*plan, *log, options.fresh);
  Progress progress(options.progress, static_cast<int>(plan->size()),
                    static_cast<int>(plan->size() - left.size()));
  Runner runner(options, run_cell, &*log, &progress);
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
