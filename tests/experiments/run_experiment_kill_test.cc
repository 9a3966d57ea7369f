#include <fcntl.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <filesystem>
#include <map>
#include <random>
#include <sstream>
#include <thread>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "experiments/run_experiment/results/record.h"
#include "tests/common/paths.h"
#include "tests/common/temporary_folder.h"

namespace cirque {
namespace {

constexpr int kSurfaces = 40, kRepeats = 4, kRuns = kSurfaces * kRepeats;

/// run_experiment as a child that a test may send signals.
class RunExperimentSignalsSlow : public ::testing::Test {
 protected:
  RunExperimentSignalsSlow() {
    std::string seeds;
    for (int seed = 1; seed <= kSurfaces; ++seed) seeds += std::to_string(seed) + ", ";
    config_ = folder_.Write("a.yaml",
                            "question: why\nmeshes:\n  - generator: bumpy_terrain\n"
                            "    triangles: 200\n    seed: [" +
                                seeds +
                                "]\n"
                                "methods:\n  - name: a\nrepeats: " +
                                std::to_string(kRepeats) + "\n");
  }

  pid_t Start() const {
    const std::string program = ProgramFolder() + "/run_experiment";
    const std::string output = "--output=" + folder_.path() + "/out";
    const pid_t child = fork();
    if (child != 0) {
      setpgid(child, child);
      return child;
    }
    setpgid(0, 0);
    const int nowhere = open("/dev/null", O_WRONLY);
    dup2(nowhere, STDOUT_FILENO);
    execl(program.c_str(), program.c_str(), config_.c_str(), output.c_str(), "--parallel_runs=2",
          nullptr);
    _exit(127);
  }

  static int Wait(pid_t child) {
    int status = 0;
    waitpid(child, &status, 0);
    return status;
  }

  /// The whole lines of results.jsonl by key; a key twice is a failure.
  std::map<std::string, std::string> Lines() const {
    std::map<std::string, std::string> lines;
    std::istringstream stream(folder_.Read("out/results.jsonl"));
    for (std::string line; std::getline(stream, line);) {
      const Record record = Record::parse(line, nullptr, false);
      if (!record.is_object()) continue;
      EXPECT_TRUE(lines.emplace(record["key"], line).second) << "twice: " << line;
      EXPECT_EQ(record["outcome"], "ok");
    }
    return lines;
  }

  TemporaryFolder folder_;
  std::string config_;
};

/// Whether every line is there again, unchanged.
void ExpectKept(const std::map<std::string, std::string>& before,
                const std::map<std::string, std::string>& after) {
  for (const auto& [key, line] : before) {
    const auto found = after.find(key);
    EXPECT_TRUE(found != after.end() && found->second == line) << "lost or changed: " << line;
  }
}

TEST_F(RunExperimentSignalsSlow, KilledAtAnyOfFiftyMomentsItLosesNoRecordAndMakesNoneTwice) {
  std::mt19937 random(7);
  std::uniform_int_distribution<int> delay(5, 300);
  std::map<std::string, std::string> before;
  int kills = 0, sweeps = 1;
  while (kills < 50 && !HasFailure()) {
    const pid_t child = Start();
    std::this_thread::sleep_for(std::chrono::milliseconds(delay(random)));
    // The runner alone, or all its processes, as who ends a cluster's job does.
    kill(kills % 2 == 0 ? child : -child, SIGKILL);
    const bool was_killed = WIFSIGNALED(Wait(child));
    const auto after = Lines();
    ExpectKept(before, after);
    before = after;
    kills += was_killed ? 1 : 0;
    if (was_killed) continue;
    ASSERT_EQ(before.size(), static_cast<std::size_t>(kRuns));
    std::filesystem::remove_all(folder_.Path("out"));  // it was done: another sweep to be killed
    before.clear();
    ++sweeps;
  }
  EXPECT_EQ(Wait(Start()), 0);
  ExpectKept(before, Lines());
  EXPECT_EQ(Lines().size(), static_cast<std::size_t>(kRuns));
  RecordProperty("kills", kills);
  RecordProperty("sweeps", sweeps);
}

TEST_F(RunExperimentSignalsSlow, CtrlCStopsCleanlyAndTheRestIsMadeLater) {
  const pid_t child = Start();
  while (Lines().size() < 2) std::this_thread::sleep_for(std::chrono::milliseconds(5));
  kill(-child, SIGINT);  // as the terminal does
  const int status = Wait(child);
  EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 1) << status;
  const std::size_t done = Lines().size();
  EXPECT_LT(done, static_cast<std::size_t>(kRuns));
  EXPECT_THAT(folder_.Read("out/results.csv"), ::testing::StartsWith("key,"));
  EXPECT_EQ(Wait(Start()), 0);
  EXPECT_EQ(Lines().size(), static_cast<std::size_t>(kRuns));
}

}  // namespace
}  // namespace cirque
