#include <memory>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "cirque/solver/solver_strategy.h"

#include "experiments/common/process.h"
#include "experiments/common/solver_problem.h"
#include "experiments/run_experiment/config/energy_figures.h"
#include "experiments/run_experiment/run/carry_out.h"

namespace cirque {
namespace {

/// Whose minimiser others start from and are compared with.
constexpr char kReference[] = "newton";

using Strategy = std::shared_ptr<const SolverStrategy>;

/// The run's outcome in the words of its certificate.
void SetOutcome(const SolveSummary& solve, Certificate* certificate) {
  certificate->message = solve.message;
  switch (solve.termination) {
    case Termination::kConverged:
      certificate->outcome = ToString(StatusCode::kOk);
      certificate->message = "";
      return;
    case Termination::kUnsupported:
      certificate->outcome = kUnsupported;
      return;
    default:
      certificate->outcome = ToString(StatusCode::kNotConverged);
      certificate->message = ToString(solve.termination) + ": " + solve.message;
  }
}

void SetFigures(const EnergyOutcome& outcome, RunResult* result) {
  const bool ran = outcome.solve.termination != Termination::kUnsupported;
  for (const EnergyFigure& figure : EnergyFigures()) {
    if (ran) result->figures[figure.name] = figure.of(outcome);
  }
  for (const IterationRecord& iterate : outcome.solve.iterations) {
    result->energy_gradients.push_back(iterate.gradient_max);
  }
}

/// The minimiser by which the run's is judged.
StatusOr<Eigen::VectorXd> ReferenceMinimizer(const Energy& energy, const EnergyInput& input) {
  const StatusOr<Strategy> newton = MakeSolverStrategy(kReference);
  if (!newton.ok()) return newton.status();
  Eigen::VectorXd x = StartOf(energy, input);
  const SolveSummary solve = (*newton)->Minimize(energy, SolveControl(), &x);
  if (solve.Converged() || solve.termination == Termination::kStalled) return x;
  return Status(StatusCode::kNotConverged,
                fmt::format("{}, by whose minimiser strategies are judged: {}: {}", kReference,
                            ToString(solve.termination), solve.message));
}

}  // namespace

Status EnergyRun(const PlannedRun& run, const Surface& surface, RunResult* result) {
  const EnergyTrial& trial = run.method.trial;
  const auto factory = Energies().Find(trial.energy);
  if (!factory.ok()) return factory.status();
  const StatusOr<Strategy> strategy = MakeSolverStrategy(trial.solver);
  if (!strategy.ok()) return strategy.status();
  const auto start = EnergyStarts().Find(trial.start);
  if (!start.ok()) return start.status();
  const auto problem = MakeProblem(run.mesh.name, surface, run.method.options.epsilon);
  if (!problem.ok()) return problem.status();
  const EnergyInput& input = (*problem)->input;
  const std::unique_ptr<Energy> energy = (*factory)(input);
  const StatusOr<Eigen::VectorXd> reference = ReferenceMinimizer(*energy, input);
  if (!reference.ok()) return reference.status();

  Eigen::VectorXd x = (*start)(*energy, input, *reference);
  const double cpu_before = ProcessCpuSeconds();
  EnergyOutcome outcome{(*strategy)->Minimize(*energy, SolveControl(), &x)};
  result->cpu_seconds = result->map_cpu_seconds = ProcessCpuSeconds() - cpu_before;
  result->seconds = outcome.solve.total_seconds;
  result->peak_memory_mib = PeakMemoryMib();
  outcome.parameters = energy->NumParameters();
  outcome.difference = (ComparableSolution(*energy, x) - ComparableSolution(*energy, *reference))
                           .lpNorm<Eigen::Infinity>();
  SetOutcome(outcome.solve, &result->certificate);
  SetFigures(outcome, result);
  return Status();
}

}  // namespace cirque
