#include <cstdio>

#include <fmt/format.h>
#include <gflags/gflags.h>
#include <glog/logging.h>

#include "experiments/common/blas_threads.h"
#include "experiments/common/flag_parsing.h"
#include "experiments/common/interrupt.h"
#include "experiments/run_experiment/columns.h"
#include "experiments/run_experiment/config.h"
#include "experiments/run_experiment/report_program.h"
#include "experiments/run_experiment/runner.h"
#include "experiments/run_experiment/schema.h"

DEFINE_bool(help_config, false, "explain every key of a config and exit");
DEFINE_bool(dry_run, false, "check the config, list its runs, write nothing");
DEFINE_string(only, "", "make only the runs whose name (see --dry_run) contains this");
DEFINE_bool(fresh, false, "make finished runs again");
DEFINE_string(output, "", "the folder of the results, instead of the config's");
DEFINE_bool(report, true, "write report.html, report.csv and report.json at the end");
DECLARE_bool(help);

namespace cirque {
namespace {

constexpr char kSource[] = "experiments/run_experiment/";
constexpr char kUsage[] =
    "run_experiment [FLAGS] CONFIG.yaml\n"
    "Parameterizes every mesh of an experiment by every method of it and keeps what comes out.\n"
    "Runs that are finished already are not made again.\n\n";

constexpr int kSomeRunFailed = 1;
constexpr int kBadInput = 2;

int Refuse(const Status& status) {
  fmt::print(stderr, "{}{}", status.message(), status.message().ends_with('\n') ? "" : "\n");
  return kBadInput;
}

std::string Plural(std::size_t count, const std::string& noun) {
  return fmt::format("{} {}{}", count, noun, count == 1 ? "" : "s");
}

StatusOr<std::vector<Cell>> Select(const ExperimentConfig& config) {
  std::vector<Cell> cells = SelectCells(config.cells, FLAGS_only);
  if (!cells.empty()) return cells;
  return Status::InvalidInput(
      fmt::format("--only={}: no run of {} has a name with that in it; --dry_run lists them",
                  FLAGS_only, config.path));
}

void PrintCells(const std::vector<Cell>& cells) {
  for (const Cell& cell : cells) fmt::print("{}\n", cell.Label());
  fmt::print("{}\n", Plural(cells.size(), "run"));
}

void PrintSummary(const RunSummary& summary, std::size_t selected, const std::string& output) {
  fmt::print("\n{}\n", ToTable(summary.records));
  if (summary.skipped_lines > 0) {
    fmt::print("{} of results.jsonl could not be read and were passed over.\n",
               Plural(summary.skipped_lines, "line"));
  }
  if (summary.stopped) {
    fmt::print("Stopped with {} of {}; the same command goes on from here.\n",
               Plural(summary.records.size(), "record"), selected);
  }
  fmt::print("{} new, {} kept: {}/results.jsonl, results.csv\n", Plural(summary.ran, "run"),
             summary.records.size() - summary.ran, output);
}

int Run(ExperimentConfig config) {
  if (!FLAGS_output.empty()) config.output = FLAGS_output;
  for (const std::string& note : config.notes) fmt::print("{}\n", note);
  const StatusOr<std::vector<Cell>> cells = Select(config);
  if (!cells.ok()) return Refuse(cells.status());
  if (FLAGS_dry_run) {
    PrintCells(*cells);
    return 0;
  }
  fmt::print("{}\n", config.question);
  CatchInterrupts();
  const RunnerOptions options{FLAGS_fresh, stdout, IsInterrupted};
  const StatusOr<RunSummary> summary = RunExperiment(config, *cells, options, ParameterizeCell);
  if (!summary.ok()) return Refuse(summary.status());
  PrintSummary(*summary, cells->size(), config.output);
  if (FLAGS_report && !summary->records.empty()) WriteReport(config.output);
  return summary->AllSettled() ? 0 : kSomeRunFailed;
}

int Main(int argc, char** argv) {
  FLAGS_logtostderr = true;
  FLAGS_minloglevel = google::GLOG_ERROR;  // Ceres warns of what the summaries say
  google::InitGoogleLogging(argv[0]);
  UseOneBlasThread();
  const StatusOr<std::vector<std::string>> arguments = ParseFlags(argc, argv, kSource);
  if (!arguments.ok()) return Refuse(arguments.status());
  if (FLAGS_help) {
    fmt::print("{}{}", kUsage, FlagHelp(kSource));
    return 0;
  }
  if (FLAGS_help_config) {
    fmt::print("{}", ConfigHelp(ConfigSchema()));
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

int main(int argc, char** argv) { return cirque::Main(argc, argv); }
