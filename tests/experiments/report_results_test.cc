// What experiment_report reads, and the flat tables that it writes.
#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "experiments/common/records.h"
#include "experiments/experiment_report/charts.h"
#include "experiments/experiment_report/flat_tables.h"
#include "experiments/experiment_report/runs.h"
#include "tests/experiments/report_fixtures.h"

namespace cirque::experiment_report {
namespace {

using nlohmann::json;
using testing::ElementsAre;
using testing::HasSubstr;

TEST(ReportResults, TornLineIsCountedAndShardsAreJoined) {
  const TemporaryFolder folder;
  folder.Write("results.jsonl", JsonLines({ReportRecord("a", "m", 1)}) + R"({"key": "torn)");
  folder.Write("results.shard-2.jsonl", JsonLines({ReportRecord("b", "m", 2)}));
  folder.Write("results.shard-1.jsonl", JsonLines({ReportRecord("c", "m", 3)}));
  folder.Write("results.csv", "not,a,log\n");
  const StatusOr<Results> results = ReadResults(folder.path());
  ASSERT_TRUE(results.ok()) << results.status().message();
  EXPECT_EQ(results->skipped_lines, 1);
  ASSERT_EQ(results->runs.size(), 3u);
  EXPECT_EQ(results->runs[0].mesh, "a");
  EXPECT_EQ(results->runs[1].mesh, "c");
  EXPECT_EQ(results->runs[2].seconds, 2);
}

TEST(ReportResults, LaterRecordOfTheSameRunHolds) {
  json earlier = ReportRecord("a", "m", 1), later = ReportRecord("a", "m", 2);
  later["provenance"]["started"] = "2026-01-02T00:00:00Z";
  later["key"] = "other code";
  const Results results = ResultsOf({later, earlier});
  ASSERT_EQ(results.runs.size(), 1u);
  EXPECT_EQ(results.runs[0].seconds, 2);
  EXPECT_EQ(results.superseded, 1);
  later["method"]["epsilon"] = 0.01;
  EXPECT_EQ(ResultsOf({later, earlier}).runs.size(), 2u);
}

TEST(ReportResults, WhoChoseAnOptionMakesNoOtherRun) {
  json earlier = ReportRecord("a", "m", 1), later = ReportRecord("a", "m", 2);
  earlier["method"]["angle_objective"] = later["method"]["angle_objective"] = "entropy";
  later["method"]["recommended"] = {{"angle_objective", "entropy"}};
  later["provenance"]["started"] = "2026-01-02T00:00:00Z";
  later["key"] = "other code";
  const Results results = ResultsOf({earlier, later});
  ASSERT_EQ(results.runs.size(), 1u);
  EXPECT_EQ(results.runs[0].seconds, 2);
}

TEST(ReportResults, RaisedLimitReplacesTheRecordOfItsKey) {
  json stopped = ReportRecord("a", "m", 9), again = ReportRecord("a", "m", 20);
  stopped["outcome"] = "time_limit";
  stopped["limits"] = {{"seconds", 9}};
  stopped["mesh"]["triangles"] = 0;
  const Results results = ResultsOf({stopped, again});
  ASSERT_EQ(results.runs.size(), 1u);
  EXPECT_EQ(results.runs[0].outcome, "ok");
  EXPECT_EQ(results.superseded, 0);
}

TEST(ReportResults, RecordsMayLackEverythingButKeyAndOutcome) {
  const Results results = ResultsOf({{{"key", "k"}, {"outcome", "exception"}, {"mesh", 7}}});
  ASSERT_EQ(results.runs.size(), 1u);
  EXPECT_TRUE(std::isnan(results.runs[0].seconds));
  EXPECT_TRUE(std::isnan(results.runs[0].Value("quasi_conformal_mean")));
  EXPECT_EQ(results.runs[0].mesh, "");
}

TEST(ReportResults, NothingToReportIsSaid) {
  const TemporaryFolder folder;
  EXPECT_THAT(ReadResults(folder.path()).status().message(), HasSubstr("holds no results.jsonl"));
  folder.Write("results.jsonl", "{\"key\"");
  EXPECT_THAT(ReadResults(folder.path()).status().message(), HasSubstr("no record yet"));
  EXPECT_THAT(ReadResults(folder.Path("no")).status().message(), HasSubstr("no such folder"));
}

TEST(FlatTables, EveryRowHasEveryColumn) {
  json second = ReportRecord("b, \"quoted\"", "m", 2);
  second["values"] = {{"flips", 3}};
  const FlatTable table = RunTable(ResultsOf({ReportRecord("a", "m", 1), second}).runs);
  const json rows = json::parse(table.Json());
  ASSERT_EQ(rows.size(), 2u);
  for (const json& row : rows) {
    EXPECT_EQ(row.size(), table.columns.size());
    for (const json& value : row) EXPECT_FALSE(value.is_structured());
  }
  EXPECT_EQ(rows[0]["mesh"], "a");
  EXPECT_EQ(rows[0]["quasi_conformal_mean"], 1.25);
  EXPECT_TRUE(rows[0]["flips"].is_null());
  EXPECT_EQ(rows[1]["seconds_total"], 2);
  EXPECT_THAT(table.Csv(), HasSubstr("\n\"b, \"\"quoted\"\"\",100,m,0,ok,,2.0,"));
}

TEST(FlatTables, ConvergenceHasARowAnIteration) {
  const FlatTable table = ConvergenceTable(ResultsOf({ReportRecord("a", "m", 1)}).runs);
  EXPECT_EQ(table.Csv(),
            "key,mesh,method,stage,strategy,iteration,gradient\n"
            "a-m,a,m,angles,newton,0,1.0\na-m,a,m,angles,newton,1,1e-08\n"
            "a-m,a,m,radii,newton,0,10.0\na-m,a,m,radii,newton,1,1.0\n"
            "a-m,a,m,radii,newton,2,1e-09\n");
}

TEST(PerformanceProfiles, KnownAnswer) {
  const double never = std::numeric_limits<double>::infinity();
  const Profiles profiles = PerformanceProfiles({
      {"p", "x", 1},
      {"p", "y", 2},  // x wins by 2
      {"q", "x", 6},
      {"q", "y", 2},  // y wins by 3
      {"r", "x", 5},
      {"r", "y", never},  // only x
      {"s", "x", never},
      {"s", "y", never},  // nobody: does not count
      {"t", "x", 1},      // y has not run: does not count
      {"u", "x", 9},
      {"u", "x", 4},
      {"u", "x", 1},
      {"u", "y", 4},  // x's median is 4: a tie
  });
  EXPECT_EQ(profiles.problems, 4);
  ASSERT_EQ(profiles.methods.size(), 2u);
  EXPECT_EQ(profiles.methods[0].method, "x");
  EXPECT_THAT(profiles.methods[0].ratios, ElementsAre(1, 1, 1, 3));
  EXPECT_THAT(profiles.methods[1].ratios, ElementsAre(1, 1, 2));
}

}  // namespace
}  // namespace cirque::experiment_report
