// Minimises every energy by every strategy and writes the tables of results/strategies.md.
#include <cstdio>
#include <filesystem>

#include <fmt/format.h>
#include <gflags/gflags.h>
#include <glog/logging.h>

#include "cirque/core/atomic_file.h"

#include "experiments/common/flag_parsing.h"
#include "experiments/common/interrupt.h"
#include "experiments/energy_strategies/tables.h"

DEFINE_double(max_seconds, cirque::TimeLimits().other, "limit of each solve");
DEFINE_double(max_first_order_seconds, cirque::TimeLimits().first_order,
              "limit of each solve by L-BFGS or nonlinear CG");
DEFINE_string(output, "", "file for the tables, Markdown; empty: standard output");
DEFINE_string(json, "", "file for the same and more, JSON");
DECLARE_bool(help);

namespace cirque {
namespace {

constexpr char kSource[] = "experiments/energy_strategies/";
constexpr char kMeshFolder[] = "../shared/meshes/";
constexpr const char* kMeshes[] = {"bff-spothead", "xuan-max", "cid-fertility_tri", "bff-face",
                                   "flipfree-car"};
constexpr char kUsage[] =
    "energy_strategies [FLAGS] [MESH ...]\n"
    "Minimises every energy of each mesh, which is to be a disk, by every strategy, and compares\n"
    "Ceres on edge residuals with Newton and with Ceres on gradient residuals. Without MESH: "
    "those\n"
    "of ../shared/meshes that results/strategies.md is about, as far as present.\n"
    "Exit status: 0 done, 1 interrupted, 2 bad input.\n\n";
constexpr int kInterrupted = 1, kBadInput = 2;

int Refuse(const Status& status) {
  fmt::print(stderr, "energy_strategies: {}\n", status.message());
  return kBadInput;
}

std::vector<std::string> DefaultMeshes() {
  std::vector<std::string> paths;
  for (const char* name : kMeshes) {
    const std::string path = fmt::format("{}{}.obj", kMeshFolder, name);
    if (std::filesystem::exists(path)) paths.push_back(path);
  }
  return paths;
}

void Tell(const Trial& trial) {
  fmt::print(stderr, "{} {} {}: {}\n", trial.mesh, trial.energy, trial.method,
             trial.solve.BriefReport());
}

struct Results {
  std::vector<Trial> strategies, least_squares;
};

void Append(std::vector<Trial> more, std::vector<Trial>* trials) {
  trials->insert(trials->end(), more.begin(), more.end());
}

void Study(const StudyProblem& problem, Results* results) {
  const SolveControl control{{}, InterruptFlag()};
  const TimeLimits limits{FLAGS_max_first_order_seconds, FLAGS_max_seconds};
  for (const std::string& energy : Energies().Names()) {
    Append(CompareMethods(problem, energy, AllMethods(limits), control, Tell),
           &results->strategies);
  }
  Append(CompareMethods(problem, "circle_pattern", LeastSquaresMethods(limits), control, Tell),
         &results->least_squares);
}

std::string Document(const Results& results, const std::string& command) {
  return fmt::format(
      "# Strategies on energies\n\nMade by `{}`.\n\n"
      "Every solve starts at zero, or at coherent angles where zero is outside the domain; L-BFGS "
      "and nonlinear CG are limited to {:g} s, others to {:g} s. *gradient*: largest entry at the "
      "end, of the energy itself; *difference*: largest, from newton's minimiser, in rad or log "
      "radii, gauge removed, multipliers compared by the angles they stand for; *CPU s*: what to "
      "go by where the machine was busy.\n"
      "{}\n## Least-squares forms of the circle-pattern energy\n\n{}",
      command, FLAGS_max_first_order_seconds, FLAGS_max_seconds, StrategyTables(results.strategies),
      LeastSquaresTable(results.least_squares));
}

Status Write(const Results& results, const std::string& command) {
  if (!FLAGS_json.empty()) {
    const Status written =
        WriteFileAtomically(FLAGS_json, ToJson(results.strategies, results.least_squares));
    if (!written.ok()) return written;
  }
  const std::string document = Document(results, command);
  if (!FLAGS_output.empty()) return WriteFileAtomically(FLAGS_output, document);
  fmt::print("{}", document);
  return Status();
}

int Run(const std::vector<std::string>& paths, const std::string& command) {
  if (paths.empty()) {
    return Refuse(Status::InvalidInput(fmt::format("no mesh given, none in {}", kMeshFolder)));
  }
  CatchInterrupts();
  Results results;
  for (const std::string& path : paths) {
    const auto problem = LoadProblem(path);
    if (!problem.ok()) return Refuse(problem.status());
    Study(**problem, &results);
    if (IsInterrupted()) return kInterrupted;
  }
  const Status written = Write(results, command);
  return written.ok() ? 0 : Refuse(written);
}

int Main(int argc, char** argv) {
  FLAGS_logtostderr = true;
  FLAGS_minloglevel = google::GLOG_ERROR;  // Ceres warns of what the summaries say
  google::InitGoogleLogging(argv[0]);
  const StatusOr<std::vector<std::string>> meshes = ParseFlags(argc, argv, kSource);
  if (!meshes.ok()) return Refuse(meshes.status());
  if (FLAGS_help) {
    fmt::print("{}{}", kUsage, FlagHelp(kSource));
    return 0;
  }
  std::string command = "energy_strategies";
  for (int i = 1; i < argc; ++i) {
    const std::string argument = argv[i];
    if (!argument.starts_with("--json")) command += " " + argument;
  }
  return Run(meshes->empty() ? DefaultMeshes() : *meshes, command);
}

}  // namespace
}  // namespace cirque

int main(int argc, char** argv) { return cirque::Main(argc, argv); }
