// What a report says of methods beside each other, by records whose figures are known.
#include <cmath>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "experiments/experiment_report/comparison.h"
#include "experiments/experiment_report/page.h"
#include "tests/experiments/report_fixtures.h"

namespace cirque {
namespace {

using experiment_report::CompareMethods;
using experiment_report::Comparison;
using experiment_report::MedianInterval;
using experiment_report::VerdictsOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

nlohmann::json Map(const std::string& mesh, const std::string& method, double distortion,
                   double cpu) {
  nlohmann::json record = ReportRecord(mesh, method, cpu);
  record["values"]["quasi_conformal_mean"] = 1 + distortion;
  record["values"].erase("log_area_ratio_l2");
  record["cpu_seconds"] = cpu;
  return record;
}

/// Twenty meshes, on which b distorts half as much as a and takes twice as long.
std::vector<nlohmann::json> Halves() {
  std::vector<nlohmann::json> records;
  for (int i = 0; i < 20; ++i) {
    const std::string mesh = "m" + std::to_string(i);
    records.push_back(Map(mesh, "a", 0.1 * (i + 1), 1));
    records.push_back(Map(mesh, "b", 0.05 * (i + 1), 2));
  }
  return records;
}

TEST(MedianInterval, IsOfOrderStatistics) {
  // Of 10 values the second and the ninth: P(X <= 1) = 11 / 1024 <= 0.025 < P(X <= 2).
  const auto [low, high] = MedianInterval({10, 9, 8, 7, 6, 5, 4, 3, 2, 1});
  EXPECT_EQ(low, 2);
  EXPECT_EQ(high, 9);
  EXPECT_EQ(MedianInterval({1, 2, 3, 4, 5}).second, INFINITY);  // 1 / 32 > 0.025
  EXPECT_EQ(MedianInterval({1, 2, 3, 4, 5, 6}).first, 1);       // 1 / 64
}

TEST(CompareMethods, CountsWinsAndPairsMeshByMesh) {
  const std::vector<Comparison> comparisons = CompareMethods(ResultsOf(Halves()).runs);
  ASSERT_EQ(comparisons.size(), 2u);  // no run has an area distortion
  const Comparison& distortion = comparisons[0];
  EXPECT_THAT(distortion.methods, ElementsAre("a", "b"));
  EXPECT_EQ(distortion.common, 20);
  EXPECT_EQ(distortion.scores[0].wins, 0);
  EXPECT_EQ(distortion.scores[1].wins, 20);
  EXPECT_NEAR(distortion.scores[1].ratio, 0.5, 1e-12);
  EXPECT_NEAR(distortion.scores[1].ratio_high, 0.5, 1e-12);
  EXPECT_NEAR(distortion.scores[0].median, 1.05, 1e-12);
  EXPECT_EQ(comparisons[1].scores[0].wins, 20);  // by time
  EXPECT_THAT(
      VerdictsOf(comparisons),
      ElementsAre("Mean quasi-conformal distortion - 1: least by b on 20 of 20 meshes; b has "
                  "0.5 times that of a in the median of 20 (95 %: 0.5 to 0.5).",
                  "CPU time [s]: least by a on 20 of 20 meshes."));
}

/// Where a method has no map, its mesh counts for no win; where there is no distortion, for no ratio.
TEST(CompareMethods, LeavesOutWhatCannotBeCompared) {
  std::vector<nlohmann::json> records = Halves();
  records[0]["outcome"] = "infeasible";
  records[2]["values"]["quasi_conformal_mean"] = 1 + 1e-9;
  const Comparison distortion = CompareMethods(ResultsOf(records).runs)[0];
  EXPECT_EQ(distortion.common, 19);
  EXPECT_EQ(distortion.scores[0].maps, 19);
  EXPECT_EQ(distortion.scores[0].wins, 1);
  EXPECT_EQ(distortion.scores[1].wins, 18);
  EXPECT_EQ(distortion.scores[1].pairs, 18);
  EXPECT_THAT(CompareMethods(ResultsOf({Map("m", "a", 1, 1)}).runs), IsEmpty());
}

/// A method that maps hardly anything would leave hardly a mesh to compare the others on.
TEST(CompareMethods, AMethodWithFewMapsIsNoContender) {
  std::vector<nlohmann::json> records = Halves();
  for (int i = 0; i < 20; ++i) {
    records.push_back(Map("m" + std::to_string(i), "c", 0.01, 0.1));
    if (i >= 9) records.back()["outcome"] = "not_converged";
  }
  const std::vector<Comparison> comparisons = CompareMethods(ResultsOf(records).runs);
  const Comparison& distortion = comparisons[0];
  EXPECT_FALSE(distortion.scores[2].contends);
  EXPECT_EQ(distortion.scores[2].maps, 9);
  EXPECT_EQ(distortion.scores[2].wins, 0);
  EXPECT_EQ(distortion.scores[2].pairs, 9);
  EXPECT_EQ(distortion.common, 20);
  EXPECT_EQ(distortion.scores[1].wins, 20);
  EXPECT_THAT(VerdictsOf(comparisons)[0],
              ::testing::AllOf(HasSubstr("least by b on 20 of 20 meshes"),
                               HasSubstr(" c maps 9 of 20 and does not count.")));
}

TEST(CompareMethods, RepeatsCountByTheirMedian) {
  std::vector<nlohmann::json> records = {Map("m", "a", 1, 1), Map("m", "b", 1, 3)};
  for (int repeat = 1; repeat < 3; ++repeat) {
    records.push_back(Map("m", "a", 1, 1));
    records.back()["repeat"] = repeat;
    records.back()["key"] = "again" + std::to_string(repeat);
    records.back()["cpu_seconds"] = 100.0 * repeat;
  }
  const auto comparisons = CompareMethods(ResultsOf(records).runs);
  EXPECT_EQ(comparisons.back().value[0][0], 100);
}

TEST(ReportPage, AnswersFirstAndMarksTheBest) {
  const auto results = ResultsOf(Halves());
  const std::string page = experiment_report::ReportHtml("t", results, {});
  EXPECT_THAT(page,
              HasSubstr("<p class=\"answer\">Mean quasi-conformal distortion - 1: least by b"));
  EXPECT_THAT(page, HasSubstr("<td class=\"number best\" data-value=\"0.05"));
  EXPECT_LT(page.find("class=\"answer\""), page.find("class=\"tiles\""));
  const auto one = ResultsOf({Map("m", "a", 1, 1)});
  EXPECT_THAT(experiment_report::ReportHtml("t", one, {}), Not(HasSubstr("id=\"comparison\"")));
}

}  // namespace
}  // namespace cirque
