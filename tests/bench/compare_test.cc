// bench/compare: ratios and intervals against hand-made runs.
#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/common/paths.h"
#include "tests/common/run_program.h"
#include "tests/common/temporary_folder.h"

namespace cirque {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

class CompareTest : public ::testing::Test {
 protected:
  /// A run in which NAME took these times [ms].
  static nlohmann::json Run(const std::map<std::string, std::vector<double>>& times) {
    nlohmann::json entries = nlohmann::json::array();
    for (const auto& [name, values] : times) {
      for (const double value : values) {
        entries.push_back({{"name", name},
                           {"run_type", "iteration"},
                           {"cpu_time", value},
                           {"real_time", 10 * value},
                           {"time_unit", "ms"}});
      }
      entries.push_back({{"name", name + "_mean"}, {"run_type", "aggregate"}, {"cpu_time", 1}});
    }
    return {{"benchmarks", entries}};
  }

  ProgramResult Compare(const std::string& before, const std::string& after,
                        const std::string& flags = "") const {
    return RunShell(ProjectPath("bench/compare") + " " + folder_.Write("a.json", before) + " " +
                    folder_.Write("b.json", after) + " " + flags);
  }
  ProgramResult Compare(const nlohmann::json& before, const nlohmann::json& after,
                        const std::string& flags = "") const {
    return Compare(before.dump(), after.dump(), flags);
  }

  TemporaryFolder folder_;
};

// Logarithms 0, 1, 2 against 1, 2, 3 (times 1e0.. e): difference 1, variances 1 / 3 each, 4 degrees
// of freedom, t(0.95; 4) = 2.776445: the interval is e^(1 -+ 2.776445 sqrt(2 / 3)).
TEST_F(CompareTest, TheIntervalIsWelchsOfTheLogarithms) {
  const auto e = [](double x) { return std::exp(x); };
  const ProgramResult result =
      Compare(Run({{"a", {e(0), e(1), e(2)}}}), Run({{"a", {e(1), e(2), e(3)}}}));
  EXPECT_EQ(result.exit_status, 0);
  EXPECT_THAT(result.output, HasSubstr("a               2.718  0.282 to 26.231\n"))
      << result.output;
}

TEST_F(CompareTest, CertainChangesAreMarkedAndAThresholdFails) {
  const auto before = Run({{"fast", {10, 10.1, 9.9}}, {"same", {1, 2, 1}}, {"slow", {1, 1.01, 1}}});
  const auto after = Run({{"fast", {5, 5.1, 4.9}}, {"same", {2, 1, 1}}, {"slow", {2, 2.02, 2}}});
  const ProgramResult result = Compare(before, after);
  EXPECT_EQ(result.exit_status, 0);
  EXPECT_THAT(result.output, testing::ContainsRegex("fast  *0.500 .* -\n"));
  EXPECT_THAT(result.output, testing::ContainsRegex("same  *1.000 [^+-]*\n"));
  EXPECT_THAT(result.output, testing::ContainsRegex("slow  *2.000 .* \\+\n"));
  EXPECT_THAT(result.output, testing::ContainsRegex("geometric mean  *1.000\n"));
  EXPECT_EQ(Compare(before, after, "--threshold 50").exit_status, 1);
  EXPECT_EQ(Compare(before, after, "--threshold 150").exit_status, 0);
}

TEST_F(CompareTest, WithoutRepetitionsTheIntervalIsUnknown) {
  const ProgramResult result = Compare(Run({{"a", {1}}, {"gone", {1}}}), Run({{"a", {2}}}));
  EXPECT_EQ(result.exit_status, 0);
  EXPECT_THAT(result.output, HasSubstr("2.000  unknown: repeat it"));
  EXPECT_THAT(result.output, HasSubstr("only in BEFORE: gone"));
}

TEST_F(CompareTest, UnitsAndErrorsAreSeen) {
  nlohmann::json after = Run({{"a", {2000}}});
  after["benchmarks"][0]["time_unit"] = "us";
  after["benchmarks"].push_back({{"name", "b"}, {"error_occurred", true}});
  const ProgramResult result = Compare(Run({{"a", {1}}}), after);
  EXPECT_THAT(result.output, HasSubstr("2.000"));
  EXPECT_THAT(result.output, HasSubstr("ended in an error: b"));
}

TEST_F(CompareTest, BadInputEndsWithStatusTwoAndSaysWhat) {
  const std::string good = Run({{"a", {1}}}).dump();
  nlohmann::json negative = Run({{"a", {-1}}}), unitless = Run({{"a", {1}}});
  unitless["benchmarks"][0].erase("time_unit");
  const std::pair<std::string, std::string> bad[] = {
      {"{", "not the JSON of a Google Benchmark run"},
      {"[]", "not the JSON of a Google Benchmark run"},
      {R"({"benchmarks": []})", "holds no benchmark"},
      {R"({"benchmarks": [3]})", "an entry without a usable cpu_time"},
      {negative.dump(), "an entry without a usable cpu_time"},
      {unitless.dump(), "an entry without a usable cpu_time"},
      {Run({{"z", {1}}}).dump(), "no benchmark in common"}};
  for (const auto& [text, message] : bad) {
    const ProgramResult result = Compare(good, text);
    EXPECT_EQ(result.exit_status, 2) << text;
    EXPECT_THAT(result.output, HasSubstr(message)) << text;
    EXPECT_THAT(result.output, Not(HasSubstr("Traceback")));
  }
  EXPECT_EQ(Compare(good, good, "--confidence 2").exit_status, 2);
  EXPECT_EQ(Compare(good, good, "--metric size").exit_status, 2);
  EXPECT_EQ(RunShell(ProjectPath("bench/compare") + " /nowhere.json /nowhere.json").exit_status, 2);
}

}  // namespace
}  // namespace cirque
