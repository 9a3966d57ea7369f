#include "cirque/metrics/measure_files.h"

#include <cmath>
#include <sstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "cirque/core/text.h"
#include "cirque/io/io.h"

#include "tests/common/run_program.h"
#include "tests/metrics/maps.h"

namespace cirque {
namespace {

using ::testing::HasSubstr;

std::vector<std::string> Split(const std::string& text, char separator) {
  std::vector<std::string> parts;
  std::istringstream in(text);
  for (std::string part; std::getline(in, part, separator);) parts.push_back(part);
  return parts;
}

/// A stretched grid whose first face has collapsed.
TestMap StretchedWithAHole() {
  TestMap map = MapOf(Grid(3, 2),
                      [](const Eigen::Vector3d& p) { return Eigen::Vector2d(1.1 * p.x(), p.y()); });
  for (Index h = 0; h < 3; ++h) map.uv.value[h] = Eigen::Vector2d(0, 0);
  return map;
}

TEST(MeasureFiles, ListsAreReadOrRefusedWithTheReason) {
  const auto files = ParseMeasureFiles("a.csv,b/c.json,d.ply,e.ply:log_area_ratio");
  ASSERT_TRUE(files.ok()) << files.status().message();
  ASSERT_EQ(files->size(), 4u);
  EXPECT_EQ((*files)[1].path, "b/c.json");
  EXPECT_EQ((*files)[2].colour_by, "quasi_conformal");
  EXPECT_EQ((*files)[3].path, "e.ply");
  EXPECT_EQ((*files)[3].colour_by, "log_area_ratio");
  EXPECT_TRUE(ParseMeasureFiles("")->empty());
  EXPECT_THAT(ParseMeasureFiles("a.txt").status().message(), HasSubstr("'a.txt'"));
  EXPECT_THAT(ParseMeasureFiles("a.csv,,b.csv").status().message(), HasSubstr("''"));
  EXPECT_THAT(ParseMeasureFiles("a.ply:log_area_ration").status().message(),
              HasSubstr("did you mean 'log_area_ratio'?"));
  EXPECT_THAT(ParseMeasureFiles("a.ply:overlap").status().message(),
              HasSubstr("unknown distortion measure with face values 'overlap'"));
}

TEST(MeasureFiles, CsvHasARowPerFaceAndNoNaN) {
  const MapMeasures m = StretchedWithAHole().Measure();
  const std::string text = MeasuresCsv(m);
  const std::vector<std::string> lines = Split(text, '\n');
  ASSERT_EQ(lines.size(), 13u);
  EXPECT_THAT(lines[0], testing::StartsWith("face,quasi_conformal,angle_error,"));
  EXPECT_EQ(lines[1], "0" + std::string(m.faces.size(), ','));
  const std::vector<std::string> cells = Split(lines[12], ',');
  ASSERT_EQ(cells.size(), m.faces.size() + 1);
  for (std::size_t i = 0; i < m.faces.size(); ++i) {
    EXPECT_EQ(std::stod(cells[i + 1]), m.faces[i].value[11]);
  }
  EXPECT_NEAR(std::stod(cells[1]), 1.1, 1e-12);
}

TEST(MeasureFiles, JsonHasEveryFigureAndNullWhereThereIsNone) {
  TestMap map = StretchedWithAHole();
  const auto json = nlohmann::json::parse(MeasuresJson(map.Measure()));
  EXPECT_EQ(json["measures"].size(), FigureNames().size());
  EXPECT_NEAR(json["measures"]["quasi_conformal_max"], 1.1, 1e-12);
  EXPECT_EQ(json["measures"]["degenerate_faces"], 1);
  EXPECT_EQ(json["meanings"]["cut_length"].get<std::string>().substr(0, 6), "length");
  for (Eigen::Vector2d& p : map.uv.value) p.setZero();
  const auto none = nlohmann::json::parse(MeasuresJson(map.Measure()));
  EXPECT_TRUE(none["measures"]["quasi_conformal_max"].is_null());
  EXPECT_EQ(none["measures"]["degenerate_faces"], 12);
}

TEST(MeasureFiles, PlyIsAMeshWithAColourPerFace) {
  const Surface grid = Grid(3, 2);
  const std::string text = MeasuresPly(grid.position, grid.triangulation.vertex,
                                       StretchedWithAHole().Measure(), "quasi_conformal");
  EXPECT_THAT(text, HasSubstr("comment colours: quasi_conformal = sigma_max / sigma_min, from 1 "));
  const std::vector<std::string> lines = Split(text, '\n');
  const Colour half = ColourOnScale(1.1, 1, 1.2);
  EXPECT_THAT(lines[lines.size() - 12], testing::EndsWith(" 128 128 128"));
  EXPECT_THAT(lines.back(),
              testing::EndsWith(" " + std::to_string(half[0]) + " " + std::to_string(half[1]) +
                                " " + std::to_string(half[2])));
  const TemporaryFolder folder;
  const Status written =
      WriteMeasureFiles(*ParseMeasureFiles(folder.Path("a.ply") + "," + folder.Path("a.csv")),
                        grid.position, grid.triangulation.vertex, StretchedWithAHole().Measure());
  ASSERT_TRUE(written.ok()) << written.message();
  EXPECT_EQ(ReadMesh(folder.Path("a.ply"))->corner, grid.triangulation.vertex);
}

TEST(ColourScale, LightnessGrowsWithTheValueOrFallsToBothSides) {
  const auto luminance = [](double value, double least) {
    const Colour c = ColourOnScale(value, least, 1);
    double sum = 0;
    const double weight[3] = {0.2126, 0.7152, 0.0722};  // of linear light, ITU-R BT.709
    for (std::size_t i = 0; i < 3; ++i) sum += weight[i] * std::pow(c[i] / 255.0, 2.2);
    return sum;
  };
  for (int i = 0; i < 20; ++i) {
    EXPECT_LT(luminance(i / 20.0, 0), luminance((i + 1) / 20.0, 0));
    EXPECT_GT(luminance(i / 20.0, -1), luminance((i + 1) / 20.0, -1));
    EXPECT_GT(luminance(-i / 20.0, -1), luminance(-(i + 1) / 20.0, -1));
  }
  EXPECT_EQ(ColourOnScale(-3, 0, 1), ColourOnScale(0, 0, 1));
  EXPECT_EQ(ColourOnScale(INFINITY, 0, 1), ColourOnScale(1, 0, 1));
  EXPECT_EQ(ColourOnScale(NAN, 0, 1), (Colour{128, 128, 128}));
}

}  // namespace
}  // namespace cirque
