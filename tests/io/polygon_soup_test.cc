#include "cirque/io/polygon_soup.h"

#include <cmath>
#include <map>
#include <random>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cirque/io/mesh_formats.h"
#include "cirque/io/text_writer.h"

#include "tests/mesh/meshes.h"

namespace cirque {
namespace {

using Eigen::Vector3d;
using ::testing::ElementsAre;

TEST(AddPolygon, TakesAPolygonOrSaysWhatIsWrong) {
  PolygonSoup soup;
  soup.position.assign(4, Vector3d::Zero());
  EXPECT_EQ(AddPolygon({0, 1, 2}, &soup), "");
  EXPECT_EQ(AddPolygon({3, 2, 1, 0}, &soup), "");
  EXPECT_EQ(AddPolygon({0, 1}, &soup),
            "a face needs at least 3 corners, this one has 2; complete or remove it");
  EXPECT_EQ(AddPolygon({0, 1, 4}, &soup),
            "expected a vertex index from 0 to 3, got 4; correct the index");
  EXPECT_EQ(AddPolygon({0, -1, 2}, &soup),
            "expected a vertex index from 0 to 3, got -1; correct the index");
  // What was refused has left no trace.
  EXPECT_THAT(soup.corner, ElementsAre(0, 1, 2, 3, 2, 1, 0));
  EXPECT_THAT(soup.first_corner, ElementsAre(0, 3, 7));
  EXPECT_EQ(soup.num_polygons(), 2);
}

TEST(FirstOfEqualPoints, ZeroHasNoSignAndNaNNoEqual) {
  const std::vector<Vector3d> points = {{0, 1, 2},        {-0.0, 1, 2},    {NAN, 0, 0},
                                        {NAN, 0, 0},      {1, 2, 0},       {0, 1, 2},
                                        {INFINITY, 0, 0}, {INFINITY, 0, 0}};
  EXPECT_THAT(FirstOfEqualPoints(points), ElementsAre(0, 0, 2, 3, 4, 0, 6, 7));
  EXPECT_TRUE(FirstOfEqualPoints({}).empty());
}

TEST(FirstOfEqualPoints, AgreesWithAnOrderedTable) {
  // Few different coordinates, so that most points have an equal before them; neighbours by an ulp.
  std::mt19937 random(2);
  std::vector<Vector3d> points;
  for (int i = 0; i < 3000; ++i) {
    Vector3d& p = points.emplace_back();
    for (double& x : p) {
      x = static_cast<double>(random() % 10) / 3;
      if (random() % 4 == 0) x = std::nextafter(x, 10);
    }
  }
  std::map<std::array<double, 3>, Index> table;
  const std::vector<Index> first = FirstOfEqualPoints(points);
  for (Index i = 0; i < 3000; ++i) {
    const Vector3d& p = points[i];
    EXPECT_EQ(first[i], table.emplace(std::array{p.x(), p.y(), p.z()}, i).first->second);
  }
  EXPECT_LT(table.size(), 3000u);
}

std::string Text(const TextPieces& pieces) {
  std::string text;
  for (const std::string& piece : pieces) text += piece;
  return text;
}

TEST(Writers, OffAndPlyShareTheirBody) {
  PolygonSoup soup = testing::OneTriangle();
  soup.position.emplace_back(1, 1, -0.5);
  ASSERT_EQ(AddPolygon({0, 1, 3, 2}, &soup), "");
  const std::string body = "0 0 0\n1 0 0\n0 1 0\n1 1 -0.5\n3 0 1 2\n4 0 1 3 2\n";
  EXPECT_EQ(Text(FormatOff(soup)), "OFF\n4 2 0\n" + body);
  EXPECT_THAT(Text(FormatPly(soup)), ::testing::EndsWith("vertex_indices\nend_header\n" + body));
}

TEST(Writers, PlyListsAreWideEnough) {
  PolygonSoup soup;
  soup.position.assign(256, Vector3d::Zero());
  std::vector<std::int64_t> corners;
  for (int i = 0; i < 255; ++i) corners.push_back(i);
  ASSERT_EQ(AddPolygon(corners, &soup), "");
  EXPECT_THAT(Text(FormatPly(soup)), ::testing::HasSubstr("list uchar int vertex_indices"));
  corners.push_back(255);
  ASSERT_EQ(AddPolygon(corners, &soup), "");
  EXPECT_THAT(Text(FormatPly(soup)), ::testing::HasSubstr("list int int vertex_indices"));
}

TEST(Writers, AColouredPlyIsTheMeshForEveryReader) {
  const PolygonSoup soup = testing::Tetrahedron();
  const std::vector<Colour> colours = {{0, 1, 2}, {255, 0, 0}, {9, 9, 9}, {1, 2, 3}};
  const std::string text =
      FormatColouredPly(soup.position, soup.corner, colours, {"first", "second"});
  EXPECT_THAT(text, ::testing::HasSubstr("\ncomment first\ncomment second\nelement vertex 4\n"));
  EXPECT_THAT(text, ::testing::EndsWith(" 1 2 3\n"));
  const StatusOr<PolygonSoup> read = ParsePly("m", text);
  ASSERT_TRUE(read.ok()) << read.status().message();
  EXPECT_EQ(read->position, soup.position);
  EXPECT_EQ(read->corner, soup.corner);
}

TEST(TextWriter, PiecesFollowEachOther) {
  TextWriter out;
  out.Text("head\n");
  out.Lines(5000, [](int i, TextWriter* line) {
    line->Number(i);
    line->Text("\n");
  });
  out.Text("tail");
  std::string expected = "head\n";
  for (int i = 0; i < 5000; ++i) expected += std::to_string(i) + "\n";
  EXPECT_EQ(Text(std::move(out).TakePieces()), expected + "tail");
}

}  // namespace
}  // namespace cirque
