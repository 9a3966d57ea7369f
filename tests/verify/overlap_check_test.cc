#include <cmath>
#include <random>
#include <set>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cirque/verify/map_check.h"

#include "tests/verify/fixtures.h"

namespace cirque::verify {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::StartsWith;

const char kInjective[] = "valid (injective)";
const char kOverlapping[] = "valid (locally injective, boundary overlaps itself)";

MapReport Judge(const PolygonSoup& map, bool require_injective = false) {
  VerifyOptions options;
  options.require_injective = require_injective;
  return verify::Judge(map, map, options);
}

/// A strip of the given width along the spiral r = 1 + 0.1 t, t up to `end`.
PolygonSoup SpiralStrip(double width, double end) {
  constexpr int kSteps = 80;
  std::vector<Eigen::Vector3d> position;
  std::vector<Eigen::Vector2d> uv;
  std::vector<Triangle> triangles;
  for (int i = 0; i <= kSteps; ++i) {
    const double t = end * i / kSteps;
    for (const double r : {1 + 0.1 * t, 1 + 0.1 * t + width}) {
      uv.emplace_back(r * std::cos(t), r * std::sin(t));
      position.emplace_back(r * std::cos(t), r * std::sin(t), 0.2 * t);
    }
    if (i == 0) continue;
    const Index a = 2 * (i - 1);
    triangles.push_back({a, a + 1, a + 3});
    triangles.push_back({a, a + 3, a + 2});
  }
  return WithVertexUv(MakeSoup(std::move(position), triangles), std::move(uv));
}

TEST(VerifyMapOverlap, ASpiralStripOverlapsItselfWhenItIsWide) {
  EXPECT_THAT(Judge(SpiralStrip(0.5, 8)).Verdict(), StartsWith(kInjective));
  const MapReport wide = Judge(SpiralStrip(0.8, 8));
  EXPECT_THAT(wide.Verdict(), StartsWith(kOverlapping));
  EXPECT_TRUE(wide.overlap->overlap.has_value());
  EXPECT_THAT(Judge(SpiralStrip(0.8, 6)).Verdict(), StartsWith(kInjective));
  EXPECT_THAT(Judge(SpiralStrip(0.8, 8), true).Verdict(),
              HasSubstr("INVALID: the boundary overlaps itself: edge ("));
}

TEST(VerifyMapOverlap, TouchingIsNotOverlapping) {
  const std::vector<Cell> ring = {{0, 0}, {1, 0}, {2, 0}, {2, 1}, {2, 2}, {1, 2}, {0, 2}, {0, 1}};
  EXPECT_THAT(Judge(SquareStrip(ring)).Verdict(), StartsWith(kInjective));
  const std::vector<Cell> round_a_point = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  EXPECT_THAT(Judge(SquareStrip(round_a_point)).Verdict(), StartsWith(kInjective));
}

TEST(VerifyMapOverlap, ABoundaryCornerOfMoreThanAFullTurnIsNamed) {
  const MapReport report = Judge(SquareStrip({{0, 0}, {1, 0}, {1, 1}, {0, 1}, {0, 0}}));
  EXPECT_THAT(report.Verdict(), StartsWith(kOverlapping));
  EXPECT_THAT(report.overlap->wrapped_boundary, ElementsAre(2));
}

TEST(VerifyMapOverlap, AWalkOfSquaresOverlapsItselfExactlyWhenItRevisitsOne) {
  // Every contact is degenerate here: corners on corners, edges along edges.
  std::mt19937 random(11);
  int revisits = 0, others = 0;
  for (int trial = 0; trial < 300; ++trial) {
    std::vector<Cell> walk = {{0, 0}, {1, 0}};
    while (walk.size() < 12) {
      static constexpr int kStep[4][2] = {{1, 0}, {0, 1}, {-1, 0}, {0, -1}};
      const int* step = kStep[random() % 4];
      const Cell next(walk.back().first + step[0], walk.back().second + step[1]);
      if (next != walk[walk.size() - 2]) walk.push_back(next);
    }
    const bool revisits_one = std::set<Cell>(walk.begin(), walk.end()).size() < walk.size();
    ++(revisits_one ? revisits : others);
    ASSERT_THAT(Judge(SquareStrip(walk)).Verdict(),
                StartsWith(revisits_one ? kOverlapping : kInjective))
        << "trial " << trial;
  }
  EXPECT_GT(revisits, 50);
  EXPECT_GT(others, 50);
}

TEST(VerifyMapOverlap, APatchUponAnotherIsFoundWithoutAnyCrossing) {
  const auto squares = [](const Eigen::Vector2d& at, double size) {
    const PolygonSoup mesh = MakeSoup(
        {{0, 0, 0}, {9, 0, 0}, {0, 9, 0}, {0, 0, 1}, {1, 0, 1}, {0, 1, 1}}, {{0, 1, 2}, {3, 4, 5}});
    return WithVertexUv(
        mesh,
        {{0, 0}, {9, 0}, {0, 9}, at, at + Eigen::Vector2d(size, 0), at + Eigen::Vector2d(0, size)});
  };
  EXPECT_THAT(Judge(squares({20, 0}, 1)).Verdict(), StartsWith(kInjective));
  EXPECT_THAT(Judge(squares({8, 8}, 1)).Verdict(),
              StartsWith(kInjective));  // within the bounding box
  EXPECT_THAT(Judge(squares({9, 0}, 1)).Verdict(), StartsWith(kInjective));  // touching
  const MapReport nested = Judge(squares({2, 2}, 1));
  EXPECT_FALSE(nested.overlap->crosses);
  EXPECT_THAT(Judge(squares({2, 2}, 1), true).Verdict(),
              HasSubstr("INVALID: patch 0 overlaps patch 1: edge ("));
  EXPECT_THAT(nested.Verdict(), StartsWith(kOverlapping));
  // Inside and sharing a corner.
  EXPECT_THAT(Judge(squares({0, 0}, 1)).Verdict(), StartsWith(kOverlapping));
}

TEST(VerifyMapOverlap, AHoleIsNotAnOverlap) {
  PolygonSoup ring = Sheet(3);
  ring.corner.erase(ring.corner.begin() + 24, ring.corner.begin() + 30);  // the middle square
  ring.first_corner.resize(ring.first_corner.size() - 2);
  const MapReport report = Judge(WithVertexUv(ring, Flattened(ring)));
  EXPECT_EQ(report.overlap->num_boundary_loops, 2);
  EXPECT_THAT(report.Verdict(), StartsWith(kInjective));
}

}  // namespace
}  // namespace cirque::verify
