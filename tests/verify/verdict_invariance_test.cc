// What a verdict must not depend on: where and how large the map lies, how the file numbers things,
// and what the map looks like turned; and what it must depend on.
#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/verify/fixtures.h"

namespace cirque::verify {
namespace {

PolygonSoup FlatMap(int n) { return WithVertexUv(Sheet(n), Flattened(Sheet(n))); }

/// A map that overlaps itself, one with a flip, and a good one.
std::vector<PolygonSoup> Maps() {
  PolygonSoup flipped = FlatMap(4);
  flipped.texture[6] = {2.2, 1.5};
  return {FlatMap(4), flipped, SquareStrip({{0, 0}, {1, 0}, {1, 1}, {0, 1}, {0, 0}, {0, -1}})};
}

/// The mesh with vertex v renamed number[v].
PolygonSoup Renumbered(const PolygonSoup& mesh, const std::vector<Index>& number) {
  PolygonSoup result = mesh;
  for (std::size_t v = 0; v < number.size(); ++v) {
    result.position[number[v]] = mesh.position[v];
    result.texture[number[v]] = mesh.texture[v];
  }
  for (Index& v : result.corner) v = number[v];
  result.corner_texture = result.corner;
  return result;
}

struct Findings {
  bool valid, judged, overlaps;
  std::size_t flipped;

  explicit Findings(const MapReport& report)
      : valid(report.valid()),
        judged(report.overlap.has_value()),
        overlaps(judged && report.overlap->overlaps()),
        flipped(report.orientations->flipped.size()) {}
  bool operator==(const Findings& other) const = default;
};

Findings FindingsOf(const PolygonSoup& map) { return Findings(Judge(map, map)); }

TEST(Verdict, DependsOnlyOnWhatTheMapIs) {
  const std::vector<PolygonSoup> maps = Maps();
  EXPECT_EQ(FindingsOf(maps[0]).valid, true);
  EXPECT_EQ(FindingsOf(maps[1]).flipped, 1u);
  EXPECT_EQ(FindingsOf(maps[2]).overlaps, true);
  std::mt19937 random(9);
  for (const PolygonSoup& map : maps) {
    std::vector<Index> number(map.position.size());
    std::iota(number.begin(), number.end(), 0);
    std::shuffle(number.begin(), number.end(), random);
    EXPECT_EQ(FindingsOf(Renumbered(map, number)), FindingsOf(map));
  }
}

// Powers of two and quarter turns are exact, so the findings must be equal and not only close.
TEST(Verdict, DoesNotChangeUnderSimilaritiesOfTheImage) {
  for (const PolygonSoup& map : Maps()) {
    for (const double scale : {0x1p-900, 1.0, 0x1p900}) {
      PolygonSoup moved = map;
      for (Eigen::Vector2d& p : moved.texture) p = scale * Eigen::Vector2d(-p.y(), p.x());
      EXPECT_EQ(FindingsOf(moved), FindingsOf(map)) << scale;
    }
  }
}

TEST(Verdict, TurnsOverWithTheImage) {
  const PolygonSoup map = FlatMap(4);
  PolygonSoup mirrored = map;
  for (Eigen::Vector2d& p : mirrored.texture) std::swap(p.x(), p.y());
  EXPECT_EQ(FindingsOf(mirrored).flipped, static_cast<std::size_t>(map.num_polygons()));
  EXPECT_FALSE(FindingsOf(mirrored).valid);
}

// A fault planted at any one vertex of a good map is found.
TEST(Verdict, FindsAFaultAtEveryVertex) {
  const PolygonSoup in = Sheet(3);
  for (Index v = 0; v < static_cast<Index>(in.position.size()); ++v) {
    PolygonSoup out = FlatMap(3);
    out.texture[v].x() = std::nan("");
    EXPECT_FALSE(Judge(in, out).valid()) << v;
    out = FlatMap(3);
    out.position[v].z() += 1;
    EXPECT_FALSE(Judge(in, out).valid()) << v;
  }
  for (const Index inner : {5, 6, 9, 10}) {  // out of its star a triangle round it turns over
    PolygonSoup out = FlatMap(3);
    out.texture[inner] = {-7, 40};
    EXPECT_FALSE(Judge(in, out).orientations->flipped.empty()) << inner;
  }
}

// However the vertices of a valid map lie, the triangles close round each.
TEST(Verdict, AngleSumsOfAValidMapAreExactlyTwoPiInside) {
  PolygonSoup map = FlatMap(6);
  std::mt19937 random(2);
  std::uniform_real_distribution<double> shift(-0.2, 0.2);
  for (Eigen::Vector2d& p : map.texture) p += Eigen::Vector2d(shift(random), shift(random));
  const MapReport report = Judge(map, map);
  ASSERT_TRUE(report.valid()) << report.Verdict();
  EXPECT_EQ(report.angles->num_plain, 25);
  EXPECT_LT(report.angles->largest_plain_deviation, 1e-13);
  EXPECT_THAT(report.angles->wrapped, testing::IsEmpty());
}

}  // namespace
}  // namespace cirque::verify
