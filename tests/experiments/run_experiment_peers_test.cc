// Other programs beside ours in one experiment: `peer`. The peers are scripts that write what a test
// needs.
#include <chrono>
#include <filesystem>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cirque/io/io.h"

#include "experiments/run_experiment/config/config.h"
#include "experiments/run_experiment/config/peer_programs.h"
#include "experiments/run_experiment/results/columns.h"
#include "experiments/run_experiment/run/ready_run.h"
#include "experiments/run_experiment/run/runner.h"
#include "tests/common/paths.h"
#include "tests/common/run_program.h"
#include "tests/common/temporary_folder.h"

namespace cirque {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::SizeIs;

/// Takes a mesh in the plane as its own map, x times FACTOR; lives long enough to be looked at.
std::string Projection(const std::string& factor) {
  return "#!/bin/sh\n"
         "awk -v k=" +
         factor +
         " '/^v /{print; print \"vt\", k*$2, $3} /^f /{print \"f\", $2 \"/\" $2, $3 \"/\" $3, $4 "
         "\"/\" $4}' \"$1\" > \"$2\"\nsleep 0.05\n";
}

class RunExperimentPeers : public ::testing::Test {
 protected:
  std::string Script(const std::string& name, const std::string& text) {
    const std::string path = folder_.Write(name, text);
    std::filesystem::permissions(path, std::filesystem::perms::owner_all);
    return path;
  }

  StatusOr<ExperimentConfig> Load(const std::string& peer, const std::string& rest = "") {
    return LoadConfig(folder_.Write(
        "a.yaml",
        "question: why?\nmeshes:\n  - {generator: flat_delaunay_patch, triangles: 200}\n"
        "methods:\n  - name: ours\n" +
            peer + "output: out\n" + rest));
  }

  std::vector<Record> Run(const std::string& peer, const std::string& rest = "") {
    const auto config = Load(peer, rest);
    EXPECT_TRUE(config.ok()) << config.status().message();
    if (!config.ok()) return {};
    const auto summary = RunExperiment(*config, config->runs, {}, ParameterizeRun);
    EXPECT_TRUE(summary.ok()) << summary.status().message();
    return summary.ok() ? summary->records : std::vector<Record>();
  }

  TemporaryFolder folder_;
};

TEST_F(RunExperimentPeers, AMapIsJudgedAndMeasuredInTheSameTable) {
  Script("flat.sh", Projection("1"));
  const auto records = Run("peer: {name: flat, command: \"./flat.sh {in} {out}\"}\n",
                           "keep_maps: true\nmeasures: [angle_error_max]\n");
  ASSERT_THAT(records, SizeIs(2));
  const Record& peer = records[1];
  EXPECT_EQ(peer["outcome"], "ok") << peer["message"];
  EXPECT_EQ(peer["method"]["name"], "flat");
  EXPECT_EQ(peer["overlap"], "injective");
  EXPECT_EQ(peer["values"]["flipped_triangles"], 0);
  // The plane is its own map: the six digits that are printed are all that differs.
  EXPECT_NEAR(peer["values"]["quasi_conformal_mean"].get<double>(), 1, 1e-4);
  EXPECT_LT(peer["values"]["angle_error_max"], 1e-2);
  EXPECT_GT(peer["seconds"]["total"], 0);
  EXPECT_GT(peer["cpu_seconds"], 0);
  EXPECT_GT(peer["peak_memory_mib"], 0.1);
  EXPECT_LT(peer["peak_memory_mib"], 100);
  EXPECT_TRUE(ReadMesh(folder_.path() + "/out/" + peer["map"].get<std::string>()).ok());
  EXPECT_THAT(ToTable(records), AllOf(HasSubstr("flat "), HasSubstr("ours")));
}

TEST_F(RunExperimentPeers, AWrongMapIsNoMap) {
  Script("mirror.sh", Projection("-1"));
  const Record peer = Run("peer:\n  - {name: mirror, command: \"./mirror.sh {in} {out}\"}\n").at(1);
  EXPECT_EQ(peer["outcome"], "invalid_map");
  EXPECT_EQ(peer["values"]["flipped_triangles"], peer["mesh"]["triangles"]);
  EXPECT_FALSE(IsSettled(peer));
  EXPECT_THAT(peer["message"], Not(::testing::IsEmpty()));
}

TEST_F(RunExperimentPeers, AProgramThatFailsSaysSo) {
  const std::pair<std::string, std::string> failures[] = {
      {"#!/bin/sh\necho no such luck >&2\nexit 3\n", "exit status 3; it said: no such luck"},
      {"#!/bin/sh\nexit 0\n", "what it wrote: "},
      {"#!/bin/sh\necho 'v 1' > \"$2\"\n", "what it wrote: "},
      {"#!/bin/sh\nkill -SEGV $$\n", "signal 11"},
  };
  for (const auto& [script, message] : failures) {
    Script("bad.sh", script);
    const Record peer = Run("peer: {name: bad, command: \"./bad.sh {in} {out}\"}\n").at(1);
    EXPECT_EQ(peer["outcome"], "peer_failed");
    EXPECT_THAT(peer["message"], HasSubstr(message));
  }
}

bool SomethingRuns(const std::string& word) {
  return RunShell("pgrep -f '" + word + "'").exit_status == 0;
}

// What the program has started ends with it.
TEST_F(RunExperimentPeers, ALimitEndsAllThatTheProgramStarted) {
  Script("slow.sh", "#!/bin/sh\nsleep 87.125 &\nsleep 87.125\n");
  const auto begin = std::chrono::steady_clock::now();
  const Record peer =
      Run("peer: {name: slow, command: \"./slow.sh {in} {out}\"}\n", "time_limit: 0.4\n").at(1);
  EXPECT_EQ(peer["outcome"], "time_limit");
  EXPECT_NEAR(peer["seconds"]["total"].get<double>(), 0.4, 0.3);
  EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::seconds(10));
  EXPECT_FALSE(SomethingRuns("[s]leep 87.125"));
}

// The child holds its memory long enough to be seen on a machine at its limit: where this process
// has been larger than the child, looking at it is the only way to know.
TEST_F(RunExperimentPeers, TimeAndMemoryAreOfTheProgramAndItsChildren) {
  const std::string large =
      R"(awk 'BEGIN { s = "x"; while (length(s) < 150e6) s = s s; system("sleep 1") }')";
  Script("large.sh", "#!/bin/sh\n" + large + "\n" + Projection("1").substr(10));
  const std::string peer = "peer: {name: large, command: \"./large.sh {in} {out}\"}\n";
  const Record limited = Run(peer, "memory_limit: 100\n").at(1);
  EXPECT_EQ(limited["outcome"], "memory_limit") << limited["message"];
  const Record record = Run(peer).at(1);
  EXPECT_EQ(record["outcome"], "ok") << record["message"];
  EXPECT_GT(record["peak_memory_mib"], 140);
}

TEST_F(RunExperimentPeers, OurOwnProgramIsFoundBesideUs) {
  const auto records =
      Run("peer: {name: whole process, command: \"circle_patterns -io {in} -oo {out}\"}\n");
  ASSERT_THAT(records, SizeIs(2));
  EXPECT_EQ(records[1]["outcome"], "ok") << records[1]["message"];
  EXPECT_NEAR(records[1]["values"]["quasi_conformal_mean"].get<double>(),
              records[0]["values"]["quasi_conformal_mean"].get<double>(), 1e-9);
}

TEST_F(RunExperimentPeers, AnotherProgramOfTheNameMakesTheRunAnew) {
  Script("flat.sh", Projection("1"));
  const std::string peer = "peer: {name: flat, command: \"./flat.sh {in} {out}\"}\n";
  const std::string key = Run(peer).at(1)["key"];
  EXPECT_EQ(Run(peer).at(1)["key"], key);
  Script("flat.sh", Projection("2"));
  EXPECT_NE(Run(peer).at(1)["key"], key);
}

TEST_F(RunExperimentPeers, MistakesAreSaidWhereTheyStand) {
  const std::pair<const char*, const char*> mistakes[] = {
      {"peer: {name: a, command: \"nowhere-program {in} {out}\"}\n",
       "a.yaml:6:26: there is no program 'nowhere-program' in PATH"},
      {"peer: {name: a, command: \"true {in}\"}\n", "'command' needs {out}"},
      {"peer: {name: a, command: \"true {out}\"}\n", "'command' needs {in}"},
      {"peer: {name: a, command: \"true '{in} {out}\"}\n", "the quote ' is not closed"},
      {"peer: {name: a}\n", "the key 'command' is missing"},
      {"peer: {name: a, comand: b}\n", "did you mean 'command'?"},
      {"peer: bff\n", "'peer' must be"},
      {"peer: {name: ours, command: \"true {in} {out}\"}\n", "two runs are called"},
  };
  for (const auto& [peer, message] : mistakes) {
    EXPECT_THAT(Load(peer).status().message(), HasSubstr(message)) << peer;
  }
  const auto optional =
      Load("peer: {name: a, command: \"nowhere-program {in} {out}\", optional: true}\n");
  ASSERT_TRUE(optional.ok()) << optional.status().message();
  EXPECT_THAT(optional->runs, SizeIs(1));
  EXPECT_THAT(optional->notes, ElementsAre(HasSubstr("peer 'a' left out")));
}

TEST(PeerPrograms, CommandsAreSplitAtBlanksOutsideQuotes) {
  EXPECT_THAT(*SplitCommand("  a 'b c'  \"d'e\" f\"\"g ''"),
              ElementsAre("a", "b c", "d'e", "fg", ""));
  EXPECT_FALSE(SplitCommand("  ").ok());
  EXPECT_FALSE(SplitCommand("'' a").ok());
  EXPECT_FALSE(SplitCommand("a \"b").ok());
}

TEST(PeerPrograms, ARunGoesToAnotherProcessAsItIs) {
  PlannedRun run;
  run.method = {.name = "p", .options = {}, .peer = {"/bin/true", "{in}", "a b"}};
  const auto unpacked = UnpackRun(PackRun({"k", run, {}, "f", {}}));
  ASSERT_TRUE(unpacked.ok()) << unpacked.status().message();
  EXPECT_EQ(unpacked->run.method.peer, run.method.peer);
}

}  // namespace
}  // namespace cirque
