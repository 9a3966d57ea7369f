#include <filesystem>
#include <set>
#include <sstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "experiments/run_experiment/results/results_log.h"
#include "experiments/run_experiment/run/runner.h"
#include "tests/common/temporary_folder.h"

namespace cirque {
namespace {

using ::testing::HasSubstr;

std::vector<PlannedRun> ManyRuns() {
  std::vector<MeshSpec> meshes;
  for (unsigned seed = 1; seed <= 8; ++seed) {
    MeshSpec mesh;
    mesh.generator = "fake";
    mesh.name = "fake-s" + std::to_string(seed);
    mesh.generator_options.seed = seed;
    meshes.push_back(mesh);
  }
  return PlanRuns(meshes, {{"a", {}}, {"b", {}}, {"c", {}}}, 2);
}

TEST(RunExperimentShards, EveryRunIsInOneShardAndTheyAreEven) {
  const std::vector<PlannedRun> runs = ManyRuns();
  for (const int count : {1, 2, 3, 7, 48, 60}) {
    std::multiset<std::string> seen;
    for (int i = 1; i <= count; ++i) {
      const std::vector<PlannedRun> own = SelectShard(runs, {i, count});
      EXPECT_LE(own.size(), runs.size() / count + 1);
      for (const PlannedRun& run : own) seen.insert(run.Label());
    }
    EXPECT_EQ(seen.size(), runs.size());
    EXPECT_EQ(std::set<std::string>(seen.begin(), seen.end()).size(), runs.size());
  }
}

TEST(RunExperimentShards, SlowMethodsAreSpread) {
  for (int i = 1; i <= 3; ++i) {
    std::map<std::string, int> methods;
    for (const PlannedRun& run : SelectShard(ManyRuns(), {i, 3})) ++methods[run.method.name];
    EXPECT_EQ(methods.size(), 3u);
  }
}

TEST(RunExperimentShards, AreReadFromText) {
  const StatusOr<Shard> shard = ParseShard("2/8");
  ASSERT_TRUE(shard.ok());
  EXPECT_EQ(shard->index, 2);
  EXPECT_EQ(shard->count, 8);
  EXPECT_EQ(shard->FileName(), "results.shard-2-of-8.jsonl");
  EXPECT_EQ(ParseShard("1/1")->FileName(), "results.jsonl");
  for (const char* wrong :
       {"", "2", "0/3", "4/3", "-1/3", "1/", "/3", "1/3/3", "1/100001", "a/b"}) {
    EXPECT_EQ(ParseShard(wrong).status().code(), StatusCode::kInvalidInput) << wrong;
  }
}

class RunExperimentShardFiles : public ::testing::Test {
 protected:
  RunExperimentShardFiles() {
    config_.name = "test";
    config_.output = folder_.path() + "/out";
    config_.runs = ManyRuns();
  }

  RunSummary Run(const Shard& shard, const std::string& outcome = "ok") {
    const RunnerOptions options{.shard = shard};
    const auto summary = RunExperiment(config_, config_.runs, options,
                                       [&](const PlannedRun& run, const std::string& /*path*/) {
                                         ++calls_;
                                         RunResult result;
                                         result.certificate.outcome = outcome;
                                         result.figures["seed"] = run.mesh.generator_options.seed;
                                         return result;
                                       });
    EXPECT_TRUE(summary.ok()) << summary.status().message();
    return summary.ok() ? *summary : RunSummary();
  }

  std::set<std::string> KeysIn(const std::string& file) const {
    std::set<std::string> keys;
    std::istringstream lines(folder_.Read(file));
    for (std::string line; std::getline(lines, line);) {
      const auto [key, is_new] = keys.insert(Record::parse(line)["key"].get<std::string>());
      EXPECT_TRUE(is_new) << *key;
    }
    return keys;
  }

  TemporaryFolder folder_;
  ExperimentConfig config_;
  int calls_ = 0;
};

TEST_F(RunExperimentShardFiles, TogetherMakeTheWholeTable) {
  for (int i = 1; i <= 3; ++i) {
    EXPECT_EQ(Run({i, 3}).ran, 16);
    EXPECT_EQ(KeysIn("out/" + Shard{i, 3}.FileName()).size(), 16u);
  }
  EXPECT_FALSE(std::filesystem::exists(config_.output + "/results.jsonl"));
  EXPECT_FALSE(std::filesystem::exists(config_.output + "/results.csv"));
  const RunSummary whole = Run({});
  EXPECT_EQ(whole.ran, 0);
  EXPECT_EQ(whole.records.size(), 48u);
  EXPECT_TRUE(whole.AllSettled());
  EXPECT_EQ(KeysIn("out/results.jsonl").size(), 48u);
  const std::string merged = folder_.Read("out/results.jsonl");
  EXPECT_EQ(Run({}).ran, 0);
  EXPECT_EQ(folder_.Read("out/results.jsonl"), merged);
  EXPECT_EQ(calls_, 48);
}

TEST_F(RunExperimentShardFiles, WhatOneDividesTheNextDoesNotMakeAgain) {
  Run({1, 2});
  for (int i = 1; i <= 5; ++i) Run({i, 5});
  EXPECT_EQ(calls_, 48);
  Run({});
  EXPECT_EQ(calls_, 48);
}

TEST_F(RunExperimentShardFiles, TheWholeRunMakesWhatTheShardsLeft) {
  Run({2, 3});
  EXPECT_EQ(Run({}).ran, 32);
  EXPECT_EQ(KeysIn("out/results.jsonl").size(), 48u);
}

TEST_F(RunExperimentShardFiles, TheLaterRecordHoldsWhicheverFileItIsIn) {
  config_.runs.resize(1);
  const Record record = Run({}).records.at(0);
  const auto variant = [&](const std::string& started, const std::string& message) {
    Record changed = record;
    changed["provenance"]["started"] = started;
    changed["message"] = message;
    return ToLine(changed) + "\n";
  };
  folder_.Write("out/results.jsonl", variant("2030-01-02T00:00:00Z", "middle"));
  folder_.Write("out/results.shard-1-of-2.jsonl", variant("2030-01-03T00:00:00Z", "last"));
  folder_.Write("out/results.shard-2-of-2.jsonl", variant("2030-01-01T00:00:00Z", "first"));
  EXPECT_EQ(Run({}).records.at(0)["message"], "last");
  EXPECT_EQ(KeysIn("out/results.jsonl").size(), 1u);
}

TEST_F(RunExperimentShardFiles, AreEachWrittenByOneProcess) {
  std::filesystem::create_directories(config_.output);
  const auto whole = ResultsLog::Open(config_.output, {});
  const auto first = ResultsLog::Open(config_.output, {1, 2});
  const auto second = ResultsLog::Open(config_.output, {2, 2});
  EXPECT_TRUE(whole.ok() && first.ok() && second.ok());
  EXPECT_THAT(ResultsLog::Open(config_.output, {2, 2}).status().message(),
              HasSubstr("another run_experiment writes these results"));
}

}  // namespace
}  // namespace cirque
