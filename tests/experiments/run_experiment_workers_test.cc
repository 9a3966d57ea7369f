#include <chrono>
#include <filesystem>
#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cirque/io/io.h"

#include "experiments/run_experiment/run/runner.h"
#include "experiments/run_experiment/run/worker_pool.h"
#include "tests/common/paths.h"
#include "tests/common/temporary_folder.h"

namespace cirque {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

MeshSpec Generated(const std::string& generator, Index triangles) {
  MeshSpec mesh;
  mesh.generator = generator;
  mesh.name = generator + "-" + std::to_string(triangles);
  mesh.generator_options.triangles = triangles;
  return mesh;
}

std::vector<std::string> Shell(const std::string& script) {
  return {"/bin/sh", "-c", "cat > /dev/null; " + script};
}

/// A few small surfaces, run in processes of their own.
class RunExperimentWorkers : public ::testing::Test {
 protected:
  RunExperimentWorkers() {
    config_.name = "test";
    config_.output = folder_.path() + "/out";
    config_.runs =
        PlanRuns({Generated("bumpy_terrain", 100), Generated("torus", 400)}, {{"a", {}}}, 2);
    options_.parallel_runs = 2;
    options_.worker = {ProgramFolder() + "/run_experiment", "--worker"};
  }

  RunSummary Run() {
    const auto summary = RunExperiment(config_, config_.runs, options_, ParameterizeRun);
    EXPECT_TRUE(summary.ok()) << summary.status().message();
    return summary.ok() ? *summary : RunSummary();
  }

  Record RunOne() {
    config_.runs.resize(1);
    const RunSummary summary = Run();
    EXPECT_EQ(summary.records.size(), 1u);
    return summary.records.empty() ? Record() : summary.records[0];
  }

  TemporaryFolder folder_;
  ExperimentConfig config_;
  RunnerOptions options_;
};

TEST_F(RunExperimentWorkers, RecordWhatARunInThisProcessRecords) {
  config_.runs[0].measures = {"cut_length"};
  const RunSummary apart = Run();
  EXPECT_TRUE(apart.AllSettled());
  options_.parallel_runs = 0;
  config_.output = folder_.path() + "/here";
  const RunSummary here = Run();
  ASSERT_EQ(apart.records.size(), 4u);
  ASSERT_EQ(here.records.size(), 4u);
  for (std::size_t i = 0; i < 4; ++i) {
    for (const char* part :
         {"mesh", "method", "repeat", "outcome", "overlap", "values", "history"}) {
      EXPECT_EQ(apart.records[i][part], here.records[i][part]) << part;
    }
    EXPECT_LT(apart.records[i]["values"]["radii_gradient"], 1e-9);
    EXPECT_GT(apart.records[i]["peak_memory_mib"], 1);
    EXPECT_EQ(apart.records[i]["provenance"]["blas_threads"], 1);
    EXPECT_EQ(apart.records[i]["provenance"]["threads"], 1);
  }
}

TEST_F(RunExperimentWorkers, HistoryFallsFromTheStartToTheSolution) {
  const Record record = RunOne();
  for (const char* stage : {"angles", "radii"}) {
    const nlohmann::json history = record["history"][stage];
    ASSERT_GE(history.size(), 2u) << stage;
    EXPECT_LT(history.back().get<double>(), 1e-3 * history.front().get<double>());
  }
  // The certificate's gradient is that of the radii after the shift to a mean of 0, which rounds.
  EXPECT_NEAR(record["history"]["radii"].back().get<double>(),
              record["values"]["radii_gradient"].get<double>(), 1e-13);
  EXPECT_EQ(record["history"]["radii"].size(), 1 + record["values"]["radii_iterations"].get<int>());
}

TEST_F(RunExperimentWorkers, ACrashIsARecordWithTheLastWords) {
  options_.worker = Shell("echo first; echo out of luck >&2; kill -SEGV $$");
  const Record record = RunOne();
  EXPECT_EQ(record["outcome"], "crash");
  EXPECT_EQ(record["message"],
            "the run's process ended by signal 11 (Segmentation fault) without a record; it said: "
            "out of luck");
  EXPECT_EQ(Run().ran, 0);
}

TEST_F(RunExperimentWorkers, ARunThatSomebodyKilledIsMadeAgain) {
  const auto worker = options_.worker;
  options_.worker = Shell("kill -KILL $$");
  const Record record = RunOne();
  EXPECT_EQ(record["outcome"], "killed");
  EXPECT_EQ(record["message"], "the run's process ended by signal 9 (Killed) without a record");
  options_.worker = worker;
  const RunSummary again = Run();
  EXPECT_EQ(again.ran, 1);
  EXPECT_EQ(again.records.at(0)["outcome"], "ok");
}

TEST_F(RunExperimentWorkers, WhatCouldNotBeKeptIsTheMachinesFaultAndMadeAgain) {
  config_.runs.resize(1);
  config_.runs[0].keep_map = true;
  folder_.Write("out/maps", "a file where the folder of maps should be");
  const RunSummary failed = Run();
  ASSERT_EQ(failed.records.size(), 1u);
  EXPECT_EQ(failed.records[0]["outcome"], "resource");
  EXPECT_THAT(std::string(failed.records[0]["message"]), HasSubstr("/maps: cannot create"));
  std::filesystem::remove(folder_.Path("out/maps"));
  const RunSummary again = Run();
  EXPECT_EQ(again.ran, 1);
  EXPECT_EQ(again.records.at(0)["outcome"], "ok");
}

TEST_F(RunExperimentWorkers, AnythingButTheRunsOwnRecordIsACrash) {
  for (const std::string script :
       {"exit 3", "true", "echo '{}'", "echo '{\"key\":\"x\",\"outcome\":\"ok\"}'", "echo 7",
        "echo '{\"key\":3,\"outcome\":\"ok\"}'"}) {
    SCOPED_TRACE(script);
    options_.fresh = true;
    options_.worker = Shell(script);
    EXPECT_EQ(RunOne()["outcome"], "crash");
  }
  options_.worker = {"/nowhere/program"};
  EXPECT_THAT(RunOne()["message"], HasSubstr("exit status 127"));
}

TEST_F(RunExperimentWorkers, TheTimeLimitEndsARunAndAHigherOneMakesItAgain) {
  config_.runs[0].limits.seconds = 0.1;
  options_.worker = Shell("sleep 60");
  const auto begin = std::chrono::steady_clock::now();
  const Record record = RunOne();
  EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::seconds(30));
  EXPECT_EQ(record["outcome"], "time_limit");
  EXPECT_EQ(record["message"], "ended at its limit of 0.1 s");
  EXPECT_GE(record["seconds"]["total"], 0.1);
  EXPECT_EQ(Run().ran, 0);
  config_.runs[0].limits.seconds = 0.2;
  EXPECT_EQ(Run().ran, 1);
  EXPECT_EQ(Run().ran, 0);
  config_.runs[0].limits.seconds = 0;
  options_.worker = {ProgramFolder() + "/run_experiment", "--worker"};
  EXPECT_EQ(RunOne()["outcome"], "ok");
}

TEST_F(RunExperimentWorkers, TheMemoryLimitEndsARunAndAHigherOneMakesItAgain) {
  config_.runs[0].limits.memory_mib = 2;
  const Record record = RunOne();
  EXPECT_EQ(record["outcome"], "memory_limit");
  EXPECT_THAT(record["message"].get<std::string>(),
              AllOf(HasSubstr("ended at "), HasSubstr(" MiB, its limit is 2 MiB")));
  EXPECT_GT(record["peak_memory_mib"], 2);
  config_.runs[0].limits.memory_mib = 4000;
  EXPECT_EQ(RunOne()["outcome"], "ok");
  EXPECT_EQ(Run().ran, 0);
}

TEST_F(RunExperimentWorkers, KeptMapsAreTheMeshWithItsMap) {
  config_.runs[0].keep_map = true;
  const Record record = Run().records[0];
  const std::string key = record["key"];
  ASSERT_EQ(record["map"], "maps/" + key + ".obj");
  const auto map = ReadMesh(config_.output + "/maps/" + key + ".obj");
  ASSERT_TRUE(map.ok()) << map.status().message();
  EXPECT_EQ(map->num_polygons(), record["mesh"]["triangles"]);
  EXPECT_THAT(folder_.Read("out/maps/" + key + ".obj"), HasSubstr("\nvt "));
  const auto json = nlohmann::json::parse(folder_.Read("out/maps/" + key + ".certificate.json"));
  EXPECT_EQ(json["values"]["radii_gradient"], record["values"]["radii_gradient"]);
  EXPECT_EQ(Run().ran, 0);
}

TEST_F(RunExperimentWorkers, ARunWhoseMapIsMissingIsMadeAgain) {
  EXPECT_FALSE(RunOne().contains("map"));
  config_.runs[0].keep_map = true;
  const Record record = RunOne();
  ASSERT_TRUE(record.contains("map"));
  EXPECT_EQ(Run().ran, 0);
  std::filesystem::remove(config_.output + "/" + record["map"].get<std::string>());
  EXPECT_EQ(Run().ran, 1);
}

TEST_F(RunExperimentWorkers, StoppingEndsWhatGoesOnAndLeavesNoRecordOfIt) {
  options_.worker = Shell("sleep 60");
  int asked = 0;
  options_.stop = [&] { return ++asked > 10; };
  const RunSummary summary = Run();
  EXPECT_TRUE(summary.stopped);
  EXPECT_EQ(summary.ran, 0);
  EXPECT_TRUE(summary.records.empty());
}

TEST(RunExperimentReadyRuns, KeepTheirBytesAndDigits) {
  PlannedRun run = PlanRuns({Generated("torus", 7)}, {{"m,epsilon=1", {}}}, 3)[2];
  run.mesh.file = "/a/\xff\xfe.obj";
  run.mesh.known_boundary = true;
  run.mesh.generator_options.seed = 4294967295u;
  run.method.options.epsilon = 0.1 + 0.2;
  run.method.options.radii_solver = "newton_cg";
  run.method.domain = "disk";
  run.mesh.family = "torus";
  run.mesh.subdivisions = 3;
  run.mesh.subdivision = "loop";
  run.mesh.decimate = 12;
  run.reference = true;
  run.measures = {"cut_length"};
  run.limits = {1.0 / 3, 1e-300};
  run.keep_map = true;
  const StatusOr<ReadyRun> ready =
      UnpackRun(PackRun({"key", run, {"/b/\x80", "hash"}, "/c", {{"code", "x"}}}));
  ASSERT_TRUE(ready.ok()) << ready.status().message();
  EXPECT_EQ(ready->run.Label(), "torus-7/m,epsilon=1#3");
  EXPECT_EQ(ready->run.mesh.file, run.mesh.file);
  EXPECT_EQ(ready->run.mesh.generator_options.seed, 4294967295u);
  EXPECT_TRUE(ready->run.mesh.known_boundary);
  EXPECT_EQ(MethodJson(ready->run.method), MethodJson(run.method));
  EXPECT_EQ(ready->run.measures, run.measures);
  EXPECT_EQ(ready->run.limits.seconds, 1.0 / 3);
  EXPECT_EQ(ready->run.limits.memory_mib, 1e-300);
  EXPECT_TRUE(ready->run.keep_map);
  EXPECT_TRUE(ready->run.reference);
  EXPECT_EQ(ready->run.mesh.subdivisions, 3);
  EXPECT_EQ(ready->run.mesh.subdivision, "loop");
  EXPECT_EQ(ready->run.mesh.decimate, 12);
  EXPECT_EQ(ready->run.mesh.family, "torus");
  EXPECT_EQ(ready->run.method.domain, "disk");
  EXPECT_EQ(ready->mesh.path, "/b/\x80");
  EXPECT_EQ(ready->folder, "/c");
  EXPECT_EQ(ready->provenance["code"], "x");
  EXPECT_FALSE(UnpackRun("nonsense").ok());
}

}  // namespace
}  // namespace cirque
