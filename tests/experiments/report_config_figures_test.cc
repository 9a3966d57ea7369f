// Figures that a config asks for, in the report.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "experiments/experiment_report/figures.h"
#include "tests/common/run_program.h"
#include "tests/experiments/report_fixtures.h"

namespace cirque::experiment_report {
namespace {

using testing::HasSubstr;
using testing::SizeIs;

nlohmann::json FigureJson(const std::string& kind, const std::string& scale = "log") {
  nlohmann::json figure = {
      {"kind", kind},
      {"title", "T & t"},
      {"scale", scale},
      {"x", {{"pointer", "/mesh/triangles"}, {"label", "how <many>"}, {"name", "triangles"}}},
      {"by", {{"pointer", "/method/name"}, {"label", "method"}, {"name", "method"}}}};
  if (kind != "histogram") {
    figure["y"] = {{"pointer", "/seconds/total"}, {"label", "time [s]"}, {"name", "seconds"}};
  }
  return figure;
}

StatusOr<std::vector<ConfigFigure>> Read(const std::string& text) {
  const TemporaryFolder folder;
  folder.Write("figures.json", text);
  return ReadConfigFigures(folder.path());
}

std::vector<ConfigFigure> ReadOne(const nlohmann::json& figure) {
  return *Read(nlohmann::json({figure}).dump());
}

TEST(ConfigFigures, NoFileIsNoFigureAndABadOneIsNamed) {
  EXPECT_THAT(*ReadConfigFigures("/nowhere"), SizeIs(0));
  nlohmann::json pointless = FigureJson("lines");
  pointless["x"]["pointer"] = "no pointer";
  for (const std::string& bad : {std::string("{"), std::string("[{}]"), std::string("[3]"),
                                 nlohmann::json({pointless}).dump()}) {
    const auto figures = Read(bad);
    ASSERT_FALSE(figures.ok()) << bad;
    EXPECT_THAT(figures.status().message(), HasSubstr("figures.json: not as run_experiment"));
  }
}

TEST(ConfigFigures, ALineGoesThroughTheMedianOfEqualX) {
  std::vector<nlohmann::json> records;
  for (const double seconds : {1.0, 2.0, 9.0}) {
    records.push_back(ReportRecord("m" + std::to_string(seconds), "a", seconds));
  }
  records.push_back(ReportRecord("large", "a", 5));
  records.back()["mesh"]["triangles"] = 400;
  records.push_back(ReportRecord("failed", "a", 7));
  records.back()["outcome"] = "crash";
  const auto runs = ResultsOf(records).runs;
  const auto points = PointsOf(ReadOne(FigureJson("lines"))[0], runs);
  ASSERT_THAT(points, SizeIs(2));
  EXPECT_EQ(points[0].x, 100);
  EXPECT_EQ(points[0].y, 2);
  EXPECT_EQ(points[1].y, 5);
  EXPECT_THAT(PointsOf(ReadOne(FigureJson("scatter"))[0], runs), SizeIs(4));
}

TEST(ConfigFigures, EveryKindDrawsItsMarks) {
  const auto runs =
      ResultsOf({ReportRecord("x", "a", 1), ReportRecord("x", "b", 4), ReportRecord("y", "b", 2)})
          .runs;
  const std::pair<std::string, std::string> marks[] = {
      {"scatter", "x - a: 100, 1"}, {"lines", "<path "}, {"histogram", "<rect "}};
  for (const auto& [kind, mark] : marks) {
    const std::string html = ConfigFiguresHtml(ReadOne(FigureJson(kind)), runs);
    EXPECT_THAT(html, HasSubstr("T &amp; t")) << kind;
    EXPECT_THAT(html, HasSubstr("how &lt;many&gt;")) << kind;
    EXPECT_THAT(html, HasSubstr(mark)) << kind;
  }
}

TEST(ConfigFigures, ArePdfsForPapersOnRequest) {
  if (RunShell("python3 -c 'import matplotlib' || /usr/bin/python3 -c 'import matplotlib'")
          .exit_status != 0) {
    GTEST_SKIP() << "matplotlib is not installed (Debian: apt-get install python3-matplotlib)";
  }
  const TemporaryFolder folder;
  folder.Write("results.jsonl", JsonLines({ReportRecord("x", "a", 1), ReportRecord("x", "b", 4)}));
  folder.Write("figures.json", nlohmann::json({FigureJson("lines"), FigureJson("histogram"),
                                               FigureJson("scatter", "linear")})
                                   .dump());
  const ProgramResult drawn = RunProgram("experiment_report --pdf " + folder.path());
  EXPECT_EQ(drawn.exit_status, 0) << drawn.output;
  for (const char* name : {"figure_1.pdf", "figure_2.pdf", "figure_3.pdf"}) {
    EXPECT_EQ(folder.Read(name).substr(0, 5), "%PDF-") << name << drawn.output;
  }
}

}  // namespace
}  // namespace cirque::experiment_report
