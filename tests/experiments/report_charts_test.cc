// The charts of experiment_report: as many marks as there is to show, at their places.
#include <cmath>
#include <limits>
#include <regex>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "experiments/experiment_report/axis.h"
#include "experiments/experiment_report/charts.h"
#include "experiments/experiment_report/figures.h"
#include "tests/experiments/report_fixtures.h"

namespace cirque::experiment_report {
namespace {

using testing::HasSubstr;
using testing::Not;

int Count(const std::string& text, const std::string& part) {
  int count = 0;
  for (auto at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++count;
  return count;
}

constexpr char kMark[] = "class=\"mark ";

TEST(Axis, TicksAreRoundAndHoldTheValues) {
  const Axis linear("x", AxisKind::kLinear, {0.13, 0.92});
  EXPECT_EQ(linear.low(), 0);
  EXPECT_EQ(linear.high(), 1);
  EXPECT_EQ(linear.ticks()[1].label, "0.2");
  EXPECT_DOUBLE_EQ(linear.Position(0.25), 0.25);
  const Axis logarithmic("x", AxisKind::kLogarithmic, {0, -1, 0.02, 30});
  EXPECT_DOUBLE_EQ(logarithmic.low(), 0.01);
  EXPECT_DOUBLE_EQ(logarithmic.high(), 100);
  EXPECT_DOUBLE_EQ(logarithmic.Position(1), 0.5);
  const Axis tiny("x", AxisKind::kLogarithmic, {1e-12, 1});
  EXPECT_EQ(tiny.ticks().front().label, "10⁻¹²");
}

TEST(Axis, OneValueOrNoneGivesARange) {
  for (const AxisKind kind : {AxisKind::kLinear, AxisKind::kWhole, AxisKind::kLogarithmic}) {
    for (const std::vector<double>& values :
         {std::vector<double>{}, {0}, {1}, {-3}, {std::numeric_limits<double>::quiet_NaN()}}) {
      const Axis axis("x", kind, values);
      EXPECT_LT(axis.low(), axis.high());
      EXPECT_GE(axis.ticks().size(), 2u);
    }
  }
}

TEST(ScatterChart, OneMarkARecordAndTheRestIsCounted) {
  std::vector<Point> points;
  for (int i = 0; i < 37; ++i) points.push_back({i % 2, 10.0 + i, 1.0 + i, "run"});
  points.push_back({0, 0, 1, "no logarithm"});
  points.push_back({0, std::nan(""), 1, "missing"});
  const ChartText text{"T", "x", "y", AxisKind::kLogarithmic, AxisKind::kLogarithmic, ""};
  const std::string html = ScatterChart(text, {"one", "two"}, points);
  EXPECT_EQ(Count(html, kMark), 37);
  EXPECT_EQ(Count(html, "class=\"mark s1 n1\""), 18);
  EXPECT_THAT(html, HasSubstr("2 of 39 runs are not shown"));
  EXPECT_THAT(html, Not(HasSubstr("nan")));
}

TEST(HistogramChart, BarsAddUpToTheSamples) {
  std::vector<Sample> samples;
  for (int i = 0; i < 50; ++i) samples.push_back({i % 3, 1 + 0.01 * i * i});
  const std::string html = HistogramChart({"T", "x", "runs"}, {"a", "b", "c"}, samples);
  const std::regex number("<title>[abc]: (\\d+) between");
  int total = 0;
  for (std::sregex_iterator bar(html.begin(), html.end(), number), end; bar != end; ++bar) {
    total += std::stoi((*bar)[1]);
  }
  EXPECT_EQ(total, 50);
}

TEST(CurveChart, StepsGoRightThenUp) {
  const std::string html =
      CurveChart({"T", "x", "y"}, {"a"}, {{0, {0, 10}, {0, 5}, "curve"}}, true);
  EXPECT_EQ(Count(html, kMark), 1);
  EXPECT_TRUE(std::regex_search(html, std::regex("d=\"M[0-9. ]+H[0-9.]+V[0-9.]+\""))) << html;
}

TEST(CurveChart, ManyCurvesAreMediansAndBands) {
  std::vector<Curve> curves;
  for (int i = 1; i <= 11; ++i) curves.push_back({0, {0, 1}, {1.0 * i, 10.0 * i}, ""});
  curves.push_back({1, {0}, {7}, ""});
  curves.push_back({1, {0, 1, 2}, {7, 5, 3}, ""});
  const SeriesNames names = {"a", "b", "without"};
  const Summary summary = Summarize(names, curves);
  ASSERT_EQ(summary.medians.size(), 2u);
  EXPECT_EQ(summary.medians[0].y, (std::vector<double>{6, 60}));
  EXPECT_EQ(summary.bands[0].low, (std::vector<double>{2, 20}));
  EXPECT_EQ(summary.bands[0].high, (std::vector<double>{10, 100}));
  // The one that has ended keeps its height.
  EXPECT_EQ(summary.medians[1].y, (std::vector<double>{7, 6, 5}));
  const std::string html =
      CurveChart({"t", "x", "y"}, names, summary.medians, false, summary.bands);
  EXPECT_EQ(Count(html, " band\""), 2);
}

TEST(Figures, MoreSolvesThanAnEyeCanFollowAreMedians) {
  std::vector<nlohmann::json> records;
  for (int i = 0; i < 161; ++i) {
    records.push_back(ReportRecord("mesh" + std::to_string(i), "m", 1));
    records.back()["history"] = {{"angles", {1.0, 0.1 * (i + 1), 1e-9}}};
  }
  EXPECT_THAT(FiguresHtml(ResultsOf(records).runs), HasSubstr("Medians of 161 solves"));
  records.pop_back();
  EXPECT_THAT(FiguresHtml(ResultsOf(records).runs), Not(HasSubstr("Medians of")));
}

TEST(Figures, MarksFollowTheRecords) {
  std::vector<nlohmann::json> records;
  for (const std::string mesh : {"a", "b", "c"}) {
    records.push_back(ReportRecord(mesh, "fast", 1));
    records.push_back(ReportRecord(mesh, "slow", 3));
  }
  const std::string html = FiguresHtml(ResultsOf(records).runs);
  // 6 points in each scatter chart, 2 profiles, 3 histograms of one bin with 2 series, 6 + 6
  // curves.
  EXPECT_EQ(Count(html, kMark), 6 + 6 + 2 + 3 * 2 + 12);
}

TEST(Figures, WithoutValuesEachSaysWhy) {
  const std::string html = FiguresHtml(ResultsOf({{{"key", "k"}, {"outcome", "crash"}}}).runs);
  EXPECT_EQ(Count(html, kMark), 0);
  EXPECT_EQ(Count(html, "class=\"empty missing\""), 8);
}

TEST(ScatterChart, SeriesThatShareAColourDifferInShape) {
  SeriesNames names;
  std::vector<Point> points;
  for (int i = 0; i < 10; ++i) {
    names.push_back("n" + std::to_string(i));
    points.push_back({i, 1, 1, names.back()});
  }
  const std::string html = ScatterChart({"t", "x", "y"}, names, points);
  std::vector<std::string> marks;  // of the series 0 and 8, without the title
  for (const std::string mark : {"class=\"mark s0 n0\" ", "class=\"mark s0 again n8\" "}) {
    const std::size_t at = html.find(mark);
    ASSERT_NE(at, std::string::npos) << mark;
    marks.push_back(html.substr(at + mark.size(), html.find('>', at) - at - mark.size()));
  }
  EXPECT_NE(marks[0], marks[1]);
}

TEST(ScatterChart, ItsLegendNamesWhatVaries) {
  const std::vector<Point> points = {{0, 1, 1, ""}, {1, 2, 2, ""}};
  const auto legend = [&](const SeriesNames& names) {
    return ScatterChart({"t", "x", "y"}, names, points);
  };
  const std::string html = legend({"raw,layout=a,epsilon=1", "raw,layout=b,epsilon=1"});
  EXPECT_THAT(html, HasSubstr("</svg>layout=a</button>"));
  EXPECT_THAT(html, HasSubstr("data-series=\"n1\" title=\"raw,layout=b,epsilon=1\""));
  // One has no part of its own: then the names stay whole.
  EXPECT_THAT(legend({"raw", "raw,layout=b"}), HasSubstr("</svg>raw</button>"));
}

}  // namespace
}  // namespace cirque::experiment_report
