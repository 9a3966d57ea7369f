// The benchmark programs, where they are built: each registers benchmarks, and a short one of each
// runs and ends in the JSON that bench/compare reads.
#include <filesystem>
#include <sstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cirque/cones/registry.h"
#include "cirque/energy/angle_objective.h"
#include "cirque/energy/registry.h"
#include "cirque/generators/generators.h"
#include "cirque/io/io.h"
#include "cirque/solver/solver_strategy.h"

#include "tests/common/paths.h"
#include "tests/common/run_program.h"
#include "tests/common/temporary_folder.h"

namespace cirque {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

std::vector<std::string> BenchPrograms() {
  std::vector<std::string> programs;
  for (const auto& entry : std::filesystem::directory_iterator(ProgramFolder())) {
    const std::string name = entry.path().filename();
    if (name.starts_with("bench_")) programs.push_back(name);
  }
  return programs;
}

class BenchProgramsTest : public ::testing::Test {
 protected:
  void SetUp() override {
    if (BenchPrograms().empty()) GTEST_SKIP() << "the benchmarks are not built (target all)";
  }

  static std::string List(const std::string& program) {
    const ProgramResult listed = RunProgram(program + " --benchmark_list_tests");
    EXPECT_EQ(listed.exit_status, 0) << program << listed.output;
    return listed.output;
  }
};

TEST_F(BenchProgramsTest, OneOfEachRunsAndComparesWithItself) {
  const TemporaryFolder folder;
  for (const std::string& program : BenchPrograms()) {
    SCOPED_TRACE(program);
    std::istringstream names(List(program));
    std::string first;
    ASSERT_TRUE(std::getline(names, first));
    const std::string run = folder.Path(program + ".json");
    const ProgramResult ran = RunProgram(program +
                                         " --benchmark_min_time=0 --benchmark_repetitions=2 "
                                         "--benchmark_filter='^" +
                                         first + "$' --benchmark_out=" + run);
    ASSERT_EQ(ran.exit_status, 0) << ran.output;
    // Read by compare, not here: the variation of counters that are 0 is NaN, which is no JSON.
    EXPECT_THAT(folder.Read(program + ".json"), Not(HasSubstr("error_occurred")));
    const ProgramResult compared = RunShell(ProjectPath("bench/compare") + " " + run + " " + run);
    EXPECT_EQ(compared.exit_status, 0);
    EXPECT_THAT(compared.output, HasSubstr("geometric mean")) << compared.output;
    EXPECT_THAT(compared.output, HasSubstr("  1.000")) << compared.output;
  }
}

/// That the program has a benchmark with each of these in its name.
void ExpectAll(const std::string& list, const std::vector<std::string>& names) {
  for (const std::string& name : names) EXPECT_THAT(list, HasSubstr(name));
}

TEST_F(BenchProgramsTest, EverythingRegisteredIsMeasured) {
  ExpectAll(List("bench_energy"), Energies().Names());
  ExpectAll(List("bench_solver"), SolverStrategies().Names());
  ExpectAll(List("bench_angle_fits"), AngleObjectives().Names());
  ExpectAll(List("bench_pipeline"), MeshGenerators().Names());
  const std::string io = List("bench_io");
  for (const std::string& format : ReadableExtensions())
    EXPECT_THAT(io, HasSubstr("read/" + format));
  for (const std::string& format : WritableExtensions())
    EXPECT_THAT(io, HasSubstr("write/" + format));
  const std::string cones = List("bench_cones");
  for (const std::string& name : ConeHeuristics().Names()) {
    if (!MakeConeHeuristic(name, {{"cones", "8"}}).ok()) continue;
    EXPECT_THAT(cones, HasSubstr(name));
  }
}

}  // namespace
}  // namespace cirque
