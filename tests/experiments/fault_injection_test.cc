// One call of the system fails, wherever in a program it comes: nothing aborts, nothing is lost.
#include <algorithm>
#include <filesystem>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "cirque/generators/generators.h"
#include "cirque/io/io.h"

#include "tests/common/paths.h"
#include "tests/common/run_program.h"
#include "tests/common/temporary_folder.h"

namespace cirque {
namespace {

namespace fs = std::filesystem;

std::string Library() { return ProgramFolder() + "/libfailing_call.so"; }

/// 1, 2, 3, 4, 6, 8, ...: every early call, and samples of the later ones.
int NextCall(int call) { return call + 1 + call / 4; }

class FaultInjection : public ::testing::Test {
 protected:
  void SetUp() override {
    if (!fs::exists(Library())) GTEST_SKIP() << "calls cannot be replaced under a sanitizer";
  }

  std::string Mark() const { return folder_.Path("mark"); }

  /// The program with that call failing; whether the call came is WasReached().
  ProgramResult Run(const std::string& function, int call, const std::string& command) const {
    fs::remove(Mark());
    return RunShell(fmt::format("env LD_PRELOAD={} FAILING_CALL={}:{} FAILING_CALL_MARK={} {}/{}",
                                Library(), function, call, Mark(), ProgramFolder(), command));
  }

  bool WasReached() const { return fs::exists(Mark()); }

  /// The whole lines of results.jsonl that tell of a run that went well.
  std::set<std::string> GoodRecords() const {
    std::set<std::string> records;
    if (!fs::exists(folder_.Path("results/results.jsonl"))) return records;
    std::istringstream stream(folder_.Read("results/results.jsonl"));
    for (std::string line; std::getline(stream, line);) {
      const auto record = nlohmann::json::parse(line, nullptr, false);
      if (record.is_object() && record["outcome"] == "ok") records.insert(line);
    }
    return records;
  }

  TemporaryFolder folder_;
};

TEST_F(FaultInjection, AMapIsWrittenWholeOrNotAtAllAndTheStatusTells) {
  const std::string in = folder_.Path("in.obj");
  ASSERT_TRUE(WriteMesh(in, *GenerateMesh("bumpy_terrain", {1500, 1})).ok());
  const std::string reference = folder_.Path("reference/out.obj"),
                    out = folder_.Path("maps/out.obj");
  fs::create_directories(folder_.Path("reference"));
  const std::string command = "circle_patterns --threads=1 -io " + in + " -oo ";
  ASSERT_EQ(RunProgram(command + reference).exit_status, 0);
  for (const std::string function : {"malloc", "write", "fsync"}) {
    int call = 1;
    for (;; call = NextCall(call)) {
      fs::remove_all(folder_.Path("maps"));
      fs::create_directories(folder_.Path("maps"));
      const ProgramResult result = Run(function, call, command + out);
      SCOPED_TRACE(fmt::format("{} {}: {} {}", function, call, result.exit_status, result.output));
      if (!WasReached()) break;
      EXPECT_TRUE(result.exit_status >= 0 && result.exit_status <= 2);
      EXPECT_FALSE(result.output.empty());
      const bool has_map = fs::exists(out);
      EXPECT_TRUE(has_map || result.exit_status != 0);
      EXPECT_TRUE(!has_map || folder_.Read("maps/out.obj") == folder_.Read("reference/out.obj"));
      for (const auto& entry : fs::directory_iterator(folder_.Path("maps"))) {
        const std::string name = entry.path().filename();
        EXPECT_EQ(name, "out.obj");
      }
    }
    EXPECT_GT(call, 1) << function << " is never called";
  }
}

TEST_F(FaultInjection, ASweepLosesNothingAndGoesOnSlow) {
  const std::string config =
      folder_.Write("a.yaml",
                    "question: why\nmeshes:\n  - generator: bumpy_terrain\n    triangles: 100\n"
                    "    seed: [1, 2, 3, 4, 5, 6]\nmethods:\n  - name: a\n");
  const std::string command =
      fmt::format("run_experiment --report=false --output={} {}", folder_.Path("results"), config);
  int faults = 0;
  for (const std::string function : {"write", "fsync", "wait", "fork", "malloc"}) {
    int call = 1;
    for (; call < 2000; call = NextCall(call) + (function == "malloc" ? 4 : 0)) {
      fs::remove_all(folder_.Path("results"));
      const ProgramResult failed = Run(function, call, command);
      SCOPED_TRACE(fmt::format("{} {}: {} {}", function, call, failed.exit_status, failed.output));
      if (!WasReached()) break;
      ++faults;
      EXPECT_TRUE(failed.exit_status >= 0 && failed.exit_status <= 2);
      const std::set<std::string> kept = GoodRecords();
      const ProgramResult resumed = RunProgram(command);
      EXPECT_EQ(resumed.exit_status, 0) << resumed.output;
      const std::set<std::string> all = GoodRecords();
      EXPECT_EQ(all.size(), 6u);
      EXPECT_TRUE(std::includes(all.begin(), all.end(), kept.begin(), kept.end()));
      const std::string records = folder_.Read("results/results.csv");
      EXPECT_EQ(std::count(records.begin(), records.end(), '\n'), 7) << records;
    }
    EXPECT_GT(call, 1) << function << " is never called";
  }
  RecordProperty("faults", faults);
  EXPECT_GE(faults, 50);
}

}  // namespace
}  // namespace cirque
