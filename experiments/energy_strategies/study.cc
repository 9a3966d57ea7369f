#include "experiments/energy_strategies/study.h"

#include <ctime>

#include <fmt/format.h>
#include <glog/logging.h>

namespace cirque {
namespace {

SolveSummary Solve(const Energy& energy, const Method& method, double max_seconds,
                   const SolveControl& control, Eigen::VectorXd* x) {
  OptionMap options = method.options;
  options["max_seconds"] = fmt::format("{}", max_seconds);
  const auto strategy = MakeSolverStrategy(method.strategy, options);
  CHECK(strategy.ok()) << strategy.status().message();
  return (*strategy)->Minimize(energy, control, x);
}

}  // namespace

std::vector<Method> AllMethods() {
  return {
      {"newton", "newton", {}},
      {"newton_cg", "newton_cg", {}},
      {"ceres LM", "ceres_trust_region", {}},
      {"ceres dogleg", "ceres_trust_region", {{"trust_region", "dogleg"}}},
      {"ceres L-BFGS", "ceres_line_search", {}},
      {"ceres nonlinear CG", "ceres_line_search", {{"direction", "nonlinear_conjugate_gradient"}}}};
}

std::vector<Method> LeastSquaresMethods() {
  return {{"newton", "newton", {}},
          {"ceres LM, edge residuals", "ceres_trust_region", {}},
          {"ceres LM, gradient residuals", "ceres_trust_region", {{"residuals", "gradient"}}}};
}

std::vector<Trial> CompareMethods(const StudyProblem& problem, const std::string& energy_name,
                                  const std::vector<Method>& methods, double max_seconds,
                                  const SolveControl& control, const TrialCallback& told) {
  const auto factory = Energies().Find(energy_name);
  CHECK(factory.ok()) << factory.status().message();
  const std::unique_ptr<Energy> energy = (*factory)(problem.input);
  const Eigen::VectorXd start = StartOf(*energy, problem.input);
  Eigen::VectorXd reference;
  std::vector<Trial> trials;
  for (const Method& method : methods) {
    if (control.cancelled && control.cancelled->load()) break;
    Trial trial;
    trial.mesh = problem.mesh;
    trial.triangles = problem.input.triangulation.num_faces();
    trial.parameters = energy->NumParameters();
    trial.energy = energy_name;
    trial.method = method.name;
    Eigen::VectorXd x = start;
    const std::clock_t before = std::clock();
    trial.solve = Solve(*energy, method, max_seconds, control, &x);
    trial.cpu_seconds = static_cast<double>(std::clock() - before) / CLOCKS_PER_SEC;
    const Eigen::VectorXd solution = ComparableSolution(*energy, x);
    if (trials.empty()) reference = solution;
    const bool ran = trial.solve.termination != Termination::kUnsupported;
    if (ran) trial.difference = (solution - reference).lpNorm<Eigen::Infinity>();
    if (told) told(trial);
    trials.push_back(std::move(trial));
  }
  return trials;
}

}  // namespace cirque
