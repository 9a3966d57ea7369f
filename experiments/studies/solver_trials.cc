#include "experiments/studies/solver_trials.h"

#include <cmath>
#include <ctime>

#include <fmt/format.h>
#include <glog/logging.h>
#include <nlohmann/json.hpp>

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

namespace {

std::string Scientific(double number) {
  return std::isfinite(number) ? fmt::format("{:.1e}", number) : std::string();
}

/// Why a method did not converge; empty if it did.
std::string Remark(const SolveSummary& solve) {
  if (solve.Converged()) return "";
  return fmt::format("{}: {}", ToString(solve.termination), solve.message);
}

std::string Row(const std::string& leading, const Trial& trial) {
  const SolveSummary& s = trial.solve;
  if (s.termination == Termination::kUnsupported) {
    return fmt::format("| {} | {} | | | | | | | | {} |\n", leading, trial.method, Remark(s));
  }
  return fmt::format("| {} | {} | {} | {} | {} | {:.3f} | {:.3f} | {} | {} | {} |\n", leading,
                     trial.method, s.num_iterations(), s.factorizations, s.cg_iterations,
                     s.total_seconds, trial.cpu_seconds, Scientific(s.final_gradient_max),
                     Scientific(trial.difference), Remark(s));
}

std::string Header(const std::string& leading) {
  return fmt::format(
      "| {} | method | iterations | factorizations | CG | seconds | CPU s | gradient | difference "
      "| why "
      "not "
      "converged |\n"
      "|---|---|--:|--:|--:|--:|--:|--:|--:|---|\n",
      leading);
}

nlohmann::json Number(double number) {
  return std::isfinite(number) ? nlohmann::json(number) : nlohmann::json();
}

nlohmann::json Record(const Trial& trial) {
  const SolveSummary& s = trial.solve;
  return {{"mesh", trial.mesh},
          {"triangles", trial.triangles},
          {"parameters", trial.parameters},
          {"energy", trial.energy},
          {"method", trial.method},
          {"termination", ToString(s.termination)},
          {"message", s.message},
          {"iterations", s.num_iterations()},
          {"value_evaluations", s.value_evaluations},
          {"gradient_evaluations", s.gradient_evaluations},
          {"hessian_evaluations", s.hessian_evaluations},
          {"symbolic_analyses", s.symbolic_analyses},
          {"factorizations", s.factorizations},
          {"linear_solves", s.linear_solves},
          {"cg_iterations", s.cg_iterations},
          {"seconds",
           {{"total", s.total_seconds},
            {"cpu", trial.cpu_seconds},
            {"evaluation", s.evaluation_seconds},
            {"factorization", s.factorization_seconds},
            {"solve", s.solve_seconds}}},
          {"value", Number(s.final_value)},
          {"gradient_max", Number(s.final_gradient_max)},
          {"difference", Number(trial.difference)}};
}

nlohmann::json Records(const std::vector<Trial>& trials) {
  nlohmann::json records = nlohmann::json::array();
  for (const Trial& trial : trials) records.push_back(Record(trial));
  return records;
}

}  // namespace

std::string StrategyTables(const std::vector<Trial>& trials) {
  std::string text, mesh;
  for (const Trial& trial : trials) {
    if (trial.mesh != mesh) {
      mesh = trial.mesh;
      text += fmt::format("\n### {}, {} triangles\n\n{}", mesh, trial.triangles, Header("energy"));
    }
    text += Row(trial.energy, trial);
  }
  return text;
}

std::string LeastSquaresTable(const std::vector<Trial>& trials) {
  std::string text = Header("mesh");
  for (const Trial& trial : trials) {
    text += Row(fmt::format("{}, {} triangles", trial.mesh, trial.triangles), trial);
  }
  return text;
}

std::string ToJson(const std::vector<Trial>& strategies, const std::vector<Trial>& least_squares) {
  const nlohmann::json all = {{"strategies", Records(strategies)},
                              {"least_squares", Records(least_squares)}};
  return all.dump(2) + "\n";
}

}  // namespace cirque
