#include "experiments/energy_strategies/study.h"

#include <ctime>

#include <fmt/format.h>
#include <glog/logging.h>

namespace cirque {
namespace {

SolveSummary Solve(const Energy& energy, const Method& method, const SolveControl& control,
                   Eigen::VectorXd* x) {
  const auto strategy = MakeSolverStrategy(method.strategy, method.options);
  CHECK(strategy.ok()) << strategy.status().message();
  return (*strategy)->Minimize(energy, control, x);
}

Method Limited(Method method, double seconds) {
  method.options["max_seconds"] = fmt::format("{}", seconds);
  return method;
}

}  // namespace

std::vector<Method> AllMethods(const TimeLimits& limits) {
  const OptionMap dogleg = {{"trust_region", "dogleg"}};
  const OptionMap nonlinear_cg = {{"direction", "nonlinear_conjugate_gradient"}};
  return {Limited({"newton", "newton", {}}, limits.other),
          Limited({"newton_cg", "newton_cg", {}}, limits.other),
          Limited({"ceres LM", "ceres_trust_region", {}}, limits.other),
          Limited({"ceres dogleg", "ceres_trust_region", dogleg}, limits.other),
          Limited({"ceres L-BFGS", "ceres_line_search", {}}, limits.first_order),
          Limited({"ceres nonlinear CG", "ceres_line_search", nonlinear_cg}, limits.first_order)};
}

std::vector<Method> LeastSquaresMethods(const TimeLimits& limits) {
  const OptionMap gradient = {{"residuals", "gradient"}};
  return {Limited({"newton", "newton", {}}, limits.other),
          Limited({"ceres LM, edge residuals", "ceres_trust_region", {}}, limits.other),
          Limited({"ceres LM, gradient residuals", "ceres_trust_region", gradient}, limits.other)};
}

std::vector<Trial> CompareMethods(const StudyProblem& problem, const std::string& energy_name,
                                  const std::vector<Method>& methods, const SolveControl& control,
                                  const TrialCallback& told) {
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
    trial.solve = Solve(*energy, method, control, &x);
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
