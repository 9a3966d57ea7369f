#include "experiments/energy_strategies/tables.h"

#include <cmath>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace cirque {
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
