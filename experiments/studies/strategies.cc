// Minimises every energy by every strategy and writes the tables of results/strategies.md.
#include <cstdio>

#include <fmt/format.h>
#include <gflags/gflags.h>

#include "cirque/core/atomic_file.h"

#include "experiments/common/process.h"
#include "experiments/studies/solver_trials.h"
#include "experiments/studies/studies.h"

DEFINE_double(max_seconds, cirque::TimeLimits().other, "limit of each solve");
DEFINE_double(max_first_order_seconds, cirque::TimeLimits().first_order,
              "limit of each solve by L-BFGS or nonlinear CG");
DEFINE_string(json, "", "file for the same and more, JSON");

namespace cirque {
namespace {

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

void Compare(const StudyProblem& problem, Results* results) {
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
  return Deliver(Document(results, command));
}

}  // namespace

Status RunStrategies(const StudyCall& call) {
  if (call.arguments.empty()) return Status::InvalidInput("no mesh given; see --help");
  CatchInterrupts();
  Results results;
  for (const std::string& path : call.arguments) {
    const auto problem = LoadProblem(path);
    if (!problem.ok()) return problem.status();
    Compare(**problem, &results);
    if (IsInterrupted()) return Status(StatusCode::kCancelled, "interrupted");
  }
  return Write(results, call.command);
}

}  // namespace cirque
