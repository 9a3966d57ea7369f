#include <cstdio>
#include <cstring>
#include <filesystem>

#include <fmt/format.h>
#include <gflags/gflags.h>

#include "cirque/core/count.h"
#include "cirque/linear/blas_threads.h"

#include "experiments/common/flag_parsing.h"
#include "experiments/common/manual.h"
#include "experiments/common/process.h"
#include "experiments/common/program.h"
#include "experiments/run_experiment/config/config.h"
#include "experiments/run_experiment/config/schema.h"
#include "experiments/run_experiment/results/columns.h"
#include "experiments/run_experiment/run/runner.h"
#include "experiments/run_experiment/run/worker_pool.h"

DEFINE_bool(help_config, false, "explain every key of a config and exit");
DEFINE_bool(dry_run, false, "check the config, list its runs, write nothing");
DEFINE_string(only, "",
              "make only the runs with this in their name, or matching the pattern (* ?)");
DEFINE_int32(parallel_runs, 1, "runs side by side, each a process with one BLAS thread");
DEFINE_string(shard, "", "i/n: make only the i-th of n parts of the runs");
DEFINE_bool(merge, false, "make no run: collect what the shards have recorded");
DEFINE_bool(markdown, false, "with --help_config: as experiments/CONFIG.md");
DEFINE_bool(fresh, false, "make finished runs again");
DEFINE_string(output, "", "the folder of the results, instead of the config's");
DEFINE_bool(report, true, "write report.html, report.csv and report.json at the end");

namespace cirque {
namespace {

constexpr char kSource[] = "experiments/run_experiment/";

Manual ProgramManual() {
  return {
      "run_experiment",
      "maps every mesh of an experiment by every method of it and keeps what comes out",
      {{"[FLAGS] CONFIG.yaml", "a table, a record a run in results.jsonl, and the report"},
       {"--help_config", "every key of a config"}},
      {"Runs that are finished already are not made again: after an interruption the same command "
       "goes on."},
      {{"0", "every run ended in a map or in a proof that there is none"},
       {"1", "some run failed, or was not made"},
       {"2", "bad input, or the machine failed"}}};
}

constexpr char kWorkerArgument[] = "--worker";
constexpr int kMaxParallelRuns = 1024;
constexpr int kSomeRunFailed = 1;
constexpr int kBadInput = 2;

int Refuse(const Status& status) {
  fmt::print(stderr, "{}{}", status.message(), status.message().ends_with('\n') ? "" : "\n");
  return kBadInput;
}

StatusOr<std::vector<PlannedRun>> Select(const ExperimentConfig& config) {
  std::vector<PlannedRun> runs = SelectRuns(config.runs, FLAGS_only);
  if (!runs.empty()) return runs;
  return Status::InvalidInput(
      fmt::format("--only={}: no run of {} has a name with that in it; --dry_run lists them",
                  FLAGS_only, config.path));
}

void PrintRuns(const std::vector<PlannedRun>& runs) {
  for (const PlannedRun& run : runs) fmt::print("{}\n", run.Label());
  fmt::print("{}\n", Count(runs.size(), "run"));
}

void PrintSummary(const RunSummary& summary, std::size_t selected, const std::string& file) {
  fmt::print("\n{}\n", ToTable(summary.records));
  if (summary.skipped_lines > 0) {
    fmt::print("{} of results.jsonl could not be read and were passed over.\n",
               Count(summary.skipped_lines, "line"));
  }
  if (summary.stopped) {
    fmt::print("{} with {} of {}; {} goes on from here.\n", FLAGS_merge ? "Merged" : "Stopped",
               Count(summary.records.size(), "record"), selected,
               FLAGS_merge ? "submitting the shards again" : "the same command");
  }
  fmt::print("{}, {} kept: {}\n", Count(summary.ran, "new run"),
             summary.records.size() - summary.ran, file);
}

StatusOr<RunnerOptions> ChooseOptions() {
  RunnerOptions options;
  if (FLAGS_parallel_runs < 1 || FLAGS_parallel_runs > kMaxParallelRuns) {
    return Status::InvalidInput(fmt::format("--parallel_runs={}: expected a number from 1 to {}",
                                            FLAGS_parallel_runs, kMaxParallelRuns));
  }
  if (!FLAGS_shard.empty()) {
    const StatusOr<Shard> shard = ParseShard(FLAGS_shard);
    if (!shard.ok()) return shard.status();
    options.shard = *shard;
  }
  if (FLAGS_merge && (!FLAGS_shard.empty() || FLAGS_fresh)) {
    return Status::InvalidInput("--merge collects all shards: leave out --shard and --fresh");
  }
  options.fresh = FLAGS_fresh;
  options.progress = stdout;
  options.stop = [] { return FLAGS_merge || IsInterrupted(); };
  options.parallel_runs = FLAGS_parallel_runs;
  options.worker = {"/proc/self/exe", kWorkerArgument};
  return options;
}

/// Has the program experiment_report, where it lies beside this one, write its page of the results
/// in `folder` and say where it is. Whether it did.
bool WriteReport(const std::string& folder) {
  namespace fs = std::filesystem;
  std::error_code error;
  const fs::path here = fs::read_symlink("/proc/self/exe", error).parent_path();
  if (!fs::exists(here / "experiment_report", error)) return true;
  std::fflush(stdout);  // its lines come after ours
  if (RunAndWait({here / "experiment_report", folder}) == 0) return true;
  fmt::print(stderr, "the report of {} was not written\n", folder);
  return false;
}

int Run(ExperimentConfig config) {
  if (!FLAGS_output.empty()) config.output = FLAGS_output;
  for (const std::string& note : config.renamed) fmt::print(stderr, "{}\n", note);
  for (const std::string& note : config.notes) fmt::print("{}\n", note);
  const StatusOr<std::vector<PlannedRun>> runs = Select(config);
  if (!runs.ok()) return Refuse(runs.status());
  const StatusOr<RunnerOptions> chosen = ChooseOptions();
  if (!chosen.ok()) return Refuse(chosen.status());
  const RunnerOptions& options = *chosen;
  const std::vector<PlannedRun> own = SelectShard(*runs, options.shard);
  if (FLAGS_dry_run) {
    PrintRuns(own);
    return 0;
  }
  fmt::print("{}\n", config.question);
  CatchInterrupts();
  const StatusOr<RunSummary> summary = RunExperiment(config, *runs, options, ParameterizeRun);
  if (!summary.ok()) return Refuse(summary.status());
  PrintSummary(*summary, own.size(), config.output + "/" + options.shard.FileName());
  const bool wants_report = FLAGS_report && options.shard.IsWhole() && !IsInterrupted();
  if (wants_report && !summary->records.empty() && !WriteReport(config.output)) return kBadInput;
  return summary->AllSettled() ? 0 : kSomeRunFailed;
}

int Main(int argc, char** argv) {
  if (argc == 2 && std::strcmp(argv[1], kWorkerArgument) == 0) return RunWorker(ParameterizeRun);
  CommandLine line = GflagsOf(kSource, {}, {{"jobs", "parallel_runs"}});
  const StatusOr<std::vector<std::string>> arguments = line.Parse({argv + 1, argv + argc});
  if (!arguments.ok()) return Refuse(arguments.status());
  if (const auto answered = AnswerQuestions(ProgramManual(), line, *arguments)) return *answered;
  if (FLAGS_help_config) {
    fmt::print("{}", FLAGS_markdown ? ConfigMarkdown(ConfigSchema()) : ConfigHelp(ConfigSchema()));
    return 0;
  }
  if (arguments->size() != 1) {
    return Refuse(Status::InvalidInput("usage: run_experiment [FLAGS] CONFIG.yaml (see --help)"));
  }
  StatusOr<ExperimentConfig> config = LoadConfig(arguments->front());
  return config.ok() ? Run(*std::move(config)) : Refuse(config.status());
}

}  // namespace
}  // namespace cirque

int main(int argc, char** argv) {
  return cirque::RunMain("run_experiment", argc, argv, cirque::Main);
}
