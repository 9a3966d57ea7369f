// Methods that minimise an energy by itself: `energy`, `energy_solver`, `energy_start`.
#include <map>
#include <set>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cirque/core/text.h"
#include "cirque/energy/registry.h"
#include "cirque/solver/solver_strategy.h"

#include "experiments/common/solver_problem.h"
#include "experiments/run_experiment/config/config.h"
#include "experiments/run_experiment/config/energy_figures.h"
#include "experiments/run_experiment/run/ready_run.h"
#include "experiments/run_experiment/run/runner.h"
#include "tests/common/paths.h"
#include "tests/common/temporary_folder.h"

namespace cirque {
namespace {

using ::testing::HasSubstr;
using ::testing::SizeIs;

class RunExperimentEnergies : public ::testing::Test {
 protected:
  StatusOr<ExperimentConfig> Load(const std::string& method,
                                  const std::string& mesh = "bumpy_terrain") {
    return LoadConfig(folder_.Write("a.yaml", "question: why?\nmeshes:\n  - {generator: " + mesh +
                                                  ", triangles: 150}\nmethods:\n  - name: a\n" +
                                                  method + "output: out\n"));
  }

  std::vector<Record> Run(const std::string& method, const std::string& mesh = "bumpy_terrain") {
    const auto config = Load(method, mesh);
    EXPECT_TRUE(config.ok()) << config.status().message();
    if (!config.ok()) return {};
    const auto summary = RunExperiment(*config, config->runs, {}, ParameterizeRun);
    EXPECT_TRUE(summary.ok()) << summary.status().message();
    return summary.ok() ? summary->records : std::vector<Record>();
  }

  TemporaryFolder folder_;
};

std::string AllEnergies() { return "    energy: [" + Join(Energies().Names()) + "]\n"; }

// The second-order strategies end at one minimiser, whichever energy; a strategy that has no such form
// of it says so, and is no failure.
TEST_F(RunExperimentEnergies, EveryStrategyEndsAtTheMinimiserOfEveryEnergyOrSaysWhyNot) {
  const auto records =
      Run(AllEnergies() + "    energy_solver: [newton, newton_cg, ceres_trust_region, auto]\n");
  ASSERT_THAT(records, SizeIs(4 * Energies().Names().size()));
  int converged = 0;
  for (const Record& record : records) {
    SCOPED_TRACE(record["method"].dump());
    EXPECT_TRUE(IsSettled(record) || record["outcome"] == "not_converged") << record["message"];
    if (record["outcome"] == "unsupported") {
      EXPECT_EQ(record["method"]["energy_solver"], "ceres_trust_region");
      EXPECT_THAT(record["message"], HasSubstr("least-squares"));
      EXPECT_FALSE(record["values"].contains("energy_value"));
      continue;
    }
    converged += record["outcome"] == "ok";
    EXPECT_LT(record["values"]["energy_difference"], 1e-8);
    EXPECT_GT(record["values"]["energy_parameters"], 0);
    EXPECT_EQ(record["history"]["energy"].size(), record["values"]["energy_iterations"]);
    EXPECT_TRUE(record.contains("cpu_seconds"));
    for (const EnergyFigure& figure : EnergyFigures()) {
      EXPECT_TRUE(record["values"].contains(figure.name)) << figure.name;
    }
  }
  EXPECT_GE(converged, 25);
}

TEST_F(RunExperimentEnergies, StartsAreTheMinimiserNearItAndTheEnergysOwn) {
  const auto records = Run(
      "    energy: [circle_pattern, quadratic_dual]\n    energy_start: [own, solution, near]\n");
  ASSERT_THAT(records, SizeIs(6));
  std::map<std::string, std::map<std::string, int>> iterations;
  for (const Record& record : records) {
    EXPECT_EQ(record["outcome"], "ok") << record["message"];
    EXPECT_LT(record["values"]["energy_difference"], 1e-9);
    const auto& method = record["method"];
    iterations[method["energy"]][method["energy_start"]] = record["values"]["energy_iterations"];
  }
  for (const auto& [energy, of] : iterations) {
    EXPECT_LE(of.at("solution"), 1) << energy;
    EXPECT_GT(of.at("near"), of.at("solution")) << energy;
    EXPECT_GT(of.at("own"), of.at("solution")) << energy;
  }
}

// No closed surface but a torus is flat everywhere: its vertices share the curvature.
TEST_F(RunExperimentEnergies, ClosedSurfacesHaveAMinimumToo) {
  for (const std::string mesh : {"sphere", "torus", "double_torus"}) {
    const auto records = Run("    energy: [entropy_dual, circle_pattern]\n", mesh);
    ASSERT_THAT(records, SizeIs(2));
    for (const Record& record : records) EXPECT_EQ(record["outcome"], "ok") << record["message"];
  }
}

TEST_F(RunExperimentEnergies, LimitsOfTheStrategyAreOptionsOfIt) {
  const Record record =
      Run("    energy: circle_pattern\n    energy_solver: newton:max_iterations=1\n").at(0);
  EXPECT_EQ(record["outcome"], "not_converged");
  EXPECT_THAT(record["message"], HasSubstr("iteration_limit"));
  EXPECT_EQ(record["values"]["energy_iterations"], 1);
}

TEST_F(RunExperimentEnergies, MistakesAreSaidWhereTheyStand) {
  const std::pair<const char*, const char*> mistakes[] = {
      {"    energy: lorenz\n", "a.yaml:6:13: unknown energy 'lorenz'; did you mean 'lorentz'?"},
      {"    energy: lorentz\n    energy_solver: newtn\n", "did you mean 'newton'?"},
      {"    energy: lorentz\n    energy_solver: newton:max_iteration=1\n",
       "did you mean 'max_iterations'?"},
      {"    energy: lorentz\n    energy_start: middle\n", "unknown energy_start 'middle'"},
      {"    energy_solver: newton\n", "'energy_solver' has a meaning only beside 'energy'"},
      {"    energy: lorentz\n    cones: greedy\n", "a.yaml:7:5: 'cones' has no meaning beside"},
      {"    energy: lorentz\n    domain: disk\n", "'domain' has no meaning beside 'energy'"},
  };
  for (const auto& [method, message] : mistakes) {
    EXPECT_THAT(Load(method).status().message(), HasSubstr(message));
  }
}

TEST_F(RunExperimentEnergies, SeveralComponentsAreRefused) {
  folder_.Write("two.obj",
                "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 5 0 0\nv 6 0 0\nv 5 1 0\nf 1 2 3\nf 4 5 6\n");
  const auto config = LoadConfig(folder_.Write(
      "b.yaml",
      "question: why?\nmeshes:\n  - file: two.obj\nmethods:\n  - {name: a, energy: lorentz}\n"));
  ASSERT_TRUE(config.ok()) << config.status().message();
  const auto summary = RunExperiment(*config, config->runs, {}, ParameterizeRun);
  ASSERT_TRUE(summary.ok());
  EXPECT_EQ(summary->records.at(0)["outcome"], "invalid_input");
  EXPECT_THAT(summary->records[0]["message"], HasSubstr("components == 1"));
}

TEST_F(RunExperimentEnergies, ARunGoesToAnotherProcessAsItIs) {
  const auto config = Load(
      "    energy: lorentz\n    energy_solver: newton_cg\n    energy_start: near\n    epsilon: "
      "0.01\n");
  ASSERT_TRUE(config.ok()) << config.status().message();
  const auto unpacked = UnpackRun(PackRun({"k", config->runs.at(0), {}, "f", {}}));
  ASSERT_TRUE(unpacked.ok()) << unpacked.status().message();
  EXPECT_EQ(MethodJson(unpacked->run.method), MethodJson(config->runs[0].method));
  EXPECT_EQ(unpacked->run.method.options.epsilon, 0.01);
}

// configs/energies.yaml asks about all there are.
TEST(EnergiesConfig, NamesEveryEnergyAndEveryStrategy) {
  const auto config = LoadConfig(ProjectPath("configs/energies.yaml"));
  ASSERT_TRUE(config.ok()) << config.status().message();
  std::set<std::string> energies, strategies, starts;
  for (const PlannedRun& run : config->runs) {
    const EnergyTrial& trial = run.method.trial;
    energies.insert(trial.energy);
    strategies.insert(trial.solver.substr(0, trial.solver.find(':')));
    starts.insert(trial.start);
  }
  for (const std::string& name : Energies().Names()) EXPECT_TRUE(energies.contains(name)) << name;
  for (const std::string& name : EnergyStarts().Names()) EXPECT_TRUE(starts.contains(name)) << name;
  for (const std::string name :
       {"newton", "newton_cg", "ceres_trust_region", "ceres_line_search"}) {
    EXPECT_TRUE(strategies.contains(name)) << name;
  }
}

}  // namespace
}  // namespace cirque
