// The results of an experiment as one page to look at, and as flat tables.
#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gflags/gflags.h>

#include "cirque/core/atomic_file.h"
#include "cirque/core/count.h"

#include "experiments/common/flag_parsing.h"
#include "experiments/common/manual.h"
#include "experiments/common/program.h"
#include "experiments/experiment_report/figures.h"
#include "experiments/experiment_report/flat_tables.h"
#include "experiments/experiment_report/page.h"

DEFINE_string(output, "", "where to write the page; empty: RESULTS_DIR/report.html");
DEFINE_bool(pdf, false, "figures for papers too, as PDF, by Python's matplotlib");
DEFINE_double(max_megabytes, 15, "maps that would make the page larger than this are left out");

namespace cirque::experiment_report {
namespace {

namespace fs = std::filesystem;

constexpr char kSource[] = "experiments/experiment_report/";
constexpr int kBadInput = 2;
constexpr double kMegabyte = 1e6;
constexpr double kWithoutMaps = 1;  // [MB] of the page left for all else

Manual ProgramManual() {
  return {"experiment_report",
          "writes the results of an experiment, finished or under way, as one page and as tables",
          {{"[FLAGS] RESULTS_DIR", "RESULTS_DIR/report.html, which needs no other file"}},
          {"Beside it: report.csv and report.json (a row a run), convergence.csv and "
           "convergence.json (a row an iteration), report_figures.json (the points of the figures "
           "that the config asks for)."},
          {{"0", "written"}, {"2", "bad input, or the machine failed"}}};
}

int Refuse(const Status& status) {
  fmt::print(stderr, "experiment_report: {}\n", status.message());
  return kBadInput;
}

/// STEM.csv and STEM.json.
Status WriteTable(const fs::path& stem, const FlatTable& table) {
  const Status written = WriteFileAtomically(stem.string() + ".csv", table.Csv());
  return written.ok() ? WriteFileAtomically(stem.string() + ".json", table.Json()) : written;
}

Status WriteReport(const std::string& folder, const fs::path& page) {
  StatusOr<Results> results = ReadResults(folder);
  if (!results.ok()) return results.status();
  const double bytes = std::max(0.0, FLAGS_max_megabytes - kWithoutMaps) * kMegabyte;
  const ShownMaps maps = CollectMaps(folder, results->runs, static_cast<std::size_t>(bytes));
  LinkRuns(maps, &results->runs);
  const std::string title = fs::weakly_canonical(folder).filename();
  const StatusOr<std::vector<ConfigFigure>> figures = ReadConfigFigures(folder);
  if (!figures.ok()) return figures.status();
  const std::string html = ReportHtml(title, *results, maps, *figures);
  if (Status s = WriteFileAtomically(page.string(), html); !s.ok()) return s;
  fs::path stem = page;
  if (Status s = WriteTable(stem.replace_extension(), RunTable(results->runs)); !s.ok()) return s;
  const fs::path convergence = page.parent_path() / "convergence";
  if (Status s = WriteTable(convergence, ConvergenceTable(results->runs)); !s.ok()) return s;
  fmt::print("report: {} ({}, {}, {:.1f} MB)\n", page.string(), Count(results->runs.size(), "run"),
             Count(maps.keys.size(), "map"), static_cast<double>(html.size()) / kMegabyte);
  const std::string points = (page.parent_path() / "report_figures.json").string();
  if (Status s = WriteFileAtomically(points, ConfigFiguresJson(*figures, results->runs)); !s.ok()) {
    return s;
  }
  return FLAGS_pdf
             ? DrawPaperFigures(stem.string() + ".json", convergence.string() + ".json", points)
             : Status();
}

int Main(int argc, char** argv) {
  CommandLine line = GflagsOf(kSource);
  const StatusOr<std::vector<std::string>> arguments = line.Parse({argv + 1, argv + argc});
  if (!arguments.ok()) return Refuse(arguments.status());
  if (const auto answered = AnswerQuestions(ProgramManual(), line, *arguments)) return *answered;
  if (arguments->size() != 1) {
    return Refuse(
        Status::InvalidInput("usage: experiment_report [FLAGS] RESULTS_DIR (see --help)"));
  }
  const fs::path folder = arguments->front();
  const fs::path page = FLAGS_output.empty() ? folder / "report.html" : fs::path(FLAGS_output);
  const Status status = WriteReport(folder.string(), page);
  return status.ok() ? 0 : Refuse(status);
}

}  // namespace
}  // namespace cirque::experiment_report

int main(int argc, char** argv) {
  return cirque::RunMain("experiment_report", argc, argv, cirque::experiment_report::Main);
}
