#include <sys/wait.h>

#include <cstdio>
#include <filesystem>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/common/paths.h"
#include "tests/common/temporary_folder.h"

namespace cirque {
namespace {

using ::testing::HasSubstr;

struct Ended {
  int status = -1;
  std::string output;  ///< of both streams
};

Ended RunProgram(const std::string& arguments) {
  const std::string command = ProgramFolder() + "/run_experiment " + arguments + " 2>&1";
  Ended ended;
  std::FILE* pipe = popen(command.c_str(), "r");
  if (pipe == nullptr) return ended;
  char buffer[4096];
  while (const std::size_t size = std::fread(buffer, 1, sizeof(buffer), pipe)) {
    ended.output.append(buffer, size);
  }
  const int status = pclose(pipe);
  ended.status = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  return ended;
}

TEST(RunExperimentProgram, MistakesOnTheCommandLineEndWithStatusTwo) {
  const std::string config = ProjectPath("configs/quickstart.yaml");
  const std::pair<std::string, std::string> mistakes[] = {
      {"", "usage: run_experiment [FLAGS] CONFIG.yaml (see --help)"},
      {"a b", "usage: run_experiment"},
      {"/nowhere/a.yaml", "/nowhere/a.yaml: cannot open: No such file or directory"},
      {"--fresj " + config, "unknown flag 'fresj'; did you mean 'fresh'?"},
      {"--fresh=maybe " + config, "--fresh expects a value of type bool, not 'maybe'"},
      {config + " --only", "--only needs a value"},
      {config + " --only=zzz", "--only=zzz: no run of "},
      {config + " --only='z*z'", "--only=z*z: no run of "},
      {config + " --parallel_runs=0", "--parallel_runs=0: expected a number from 1 to 1024"},
      {config + " --shard=3/2", "--shard=3/2: expected i/n with i from 1 to n"},
      {config + " --merge --shard=1/2", "--merge collects all shards: leave out --shard"},
  };
  for (const auto& [arguments, message] : mistakes) {
    const Ended ended = RunProgram(arguments);
    EXPECT_EQ(ended.status, 2) << arguments;
    EXPECT_THAT(ended.output, HasSubstr(message));
  }
}

TEST(RunExperimentProgram, AnOldFlagWorksAndSaysItsNewName) {
  const Ended ended = RunProgram("--dry_run --jobs=2 " + ProjectPath("configs/quickstart.yaml"));
  EXPECT_EQ(ended.status, 0);
  EXPECT_THAT(ended.output, HasSubstr("note: --jobs is called --parallel_runs now"));
}

TEST(RunExperimentProgram, HelpIsShortAndNamesEveryFlag) {
  const Ended ended = RunProgram("--help");
  EXPECT_EQ(ended.status, 0);
  for (const char* flag : {"--dry_run", "--only", "--fresh", "--help_config", "--output"}) {
    EXPECT_THAT(ended.output, HasSubstr(flag));
  }
  EXPECT_LT(ended.output.size(), 1800u);
  EXPECT_THAT(RunProgram("--help_config").output, HasSubstr("bumpy_terrain"));
}

TEST(RunExperimentProgram, ABadConfigWritesNothing) {
  const TemporaryFolder folder;
  const std::string config = folder.Write("bad.yaml", "question: why\n");
  const Ended ended = RunProgram(config);
  EXPECT_EQ(ended.status, 2);
  EXPECT_THAT(ended.output, HasSubstr("bad.yaml:1:1: the key 'meshes' is missing"));
  EXPECT_FALSE(std::filesystem::exists(folder.path() + "/results"));
}

TEST(RunExperimentProgram, DryRunListsTheRunsOfEveryShippedConfigAndWritesNothing) {
  const TemporaryFolder folder;
  for (const auto& entry : std::filesystem::directory_iterator(ProjectPath("configs"))) {
    if (entry.path().extension() != ".yaml") continue;
    const Ended ended =
        RunProgram("--dry_run --output=" + folder.path() + "/out " + entry.path().string());
    EXPECT_EQ(ended.status, 0) << ended.output;
    EXPECT_THAT(ended.output, HasSubstr("/"));
    EXPECT_THAT(ended.output, ::testing::ContainsRegex(" runs?\n$"));
  }
  EXPECT_FALSE(std::filesystem::exists(folder.path() + "/out"));
}

}  // namespace
}  // namespace cirque
