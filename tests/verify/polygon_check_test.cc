#include "cirque/verify/polygon_check.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>

#include <gtest/gtest.h>

namespace cirque::verify {
namespace {

using Polygon = std::vector<Point>;

double Area(const Polygon& p) {
  double twice = 0;
  for (std::size_t i = 0; i < p.size(); ++i) {
    const Point &a = p[i], &b = p[(i + 1) % p.size()];
    twice += a.x() * b.y() - a.y() * b.x();
  }
  return twice / 2;
}

std::vector<int> Ears(const Polygon& p) {
  return CutEars(static_cast<int>(p.size()),
                 [&](int i, int j, int k) { return Orientation(p[i], p[j], p[k]); });
}

/// All triangles turn counterclockwise and their areas sum to the polygon's.
void ExpectFilled(const Polygon& p) {
  const std::vector<int> ears = Ears(p);
  ASSERT_EQ(ears.size(), 3 * (p.size() - 2));
  double sum = 0;
  for (std::size_t i = 0; i < ears.size(); i += 3) {
    const double area = Area({p[ears[i]], p[ears[i + 1]], p[ears[i + 2]]});
    EXPECT_GT(area, 0);
    sum += area;
  }
  EXPECT_NEAR(sum, Area(p), 1e-12 * Area(p));
}

const Polygon kArrow = {{1, 0}, {0.25, 0.25}, {0, 1}, {0, 0}};  // concave
const Polygon kL = {{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}};

TEST(ShapeOf, SimplePolygonsEitherWayRound) {
  for (Polygon p : {kArrow, kL, Polygon{{0, 0}, {1, 0}, {2, 0}, {2, 1}, {2, 2}, {0, 2}}}) {
    for (std::size_t turn = 0; turn < p.size(); ++turn) {
      std::rotate(p.begin(), p.begin() + 1, p.end());
      EXPECT_EQ(ShapeOf(p), PolygonShape::kSimple);
    }
    std::reverse(p.begin(), p.end());
    EXPECT_EQ(ShapeOf(p), PolygonShape::kFlipped);
  }
  EXPECT_EQ(ShapeOf({{0, 0}, {1, 0}, {0, 1}}), PolygonShape::kSimple);
  EXPECT_EQ(ShapeOf({{0, 0}, {0, 1}, {1, 0}}), PolygonShape::kFlipped);
  EXPECT_EQ(ShapeOf({{0, 0}, {1, 1}, {2, 2}}), PolygonShape::kZeroArea);
}

TEST(ShapeOf, WhatIsNoPolygon) {
  EXPECT_EQ(ShapeOf({{0, 0}, {1, 1}, {1, 0}, {0, 1}}), PolygonShape::kFolded);  // crosses itself
  EXPECT_EQ(ShapeOf({{0, 0}, {2, 0}, {1, 0}, {1, 1}}), PolygonShape::kFolded);  // a spike
  EXPECT_EQ(ShapeOf({{0, 0}, {2, 0}, {2, 0}, {1, 1}}), PolygonShape::kFolded);  // a corner twice
  EXPECT_EQ(ShapeOf({{0, 0}, {2, 0}, {1, 1}, {2, 2}, {0, 2}, {1, 1}}), PolygonShape::kFolded);
  EXPECT_EQ(ShapeOf({{0, 0}, {1, 0}, {3, 0}, {2, 0}}), PolygonShape::kZeroArea);
  EXPECT_EQ(ShapeOf({{1, 1}, {1, 1}, {1, 1}, {1, 1}}), PolygonShape::kZeroArea);
  Polygon twice;  // five corners on a circle, met in the order of a pentagram
  for (int i = 0; i < 5; ++i) {
    const double t = 4 * std::acos(-1.0) * i / 5;
    twice.emplace_back(std::cos(t), std::sin(t));
  }
  EXPECT_EQ(ShapeOf(twice), PolygonShape::kFolded);
}

TEST(ShapeOf, IsExact) {
  const double unit = std::ldexp(1, -53);
  // The third corner lies to the left of, on, and to the right of the line from the first to the
  // fourth... by half a unit in the last place, where the quadrilateral turns from simple to not.
  const auto kite = [](double y) { return Polygon{{0, 0}, {1, -1}, {0.5, y}, {1, 1}}; };
  EXPECT_EQ(ShapeOf(kite(0.5 - unit)), PolygonShape::kSimple);
  EXPECT_EQ(ShapeOf(kite(0.5)), PolygonShape::kFolded);
  EXPECT_EQ(ShapeOf(kite(0.5 + 2 * unit)), PolygonShape::kFolded);
}

TEST(CutEars, FillsSimplePolygons) {
  ExpectFilled(kArrow);
  ExpectFilled(kL);
  ExpectFilled({{0, 0}, {1, 0}, {2, 0}, {3, 0}, {3, 3}, {2, 3}, {1, 3}, {0, 3}, {0, 2}, {0, 1}});
  std::mt19937 random(3);
  std::uniform_real_distribution<double> radius(0.1, 1);
  for (int trial = 0; trial < 50; ++trial) {
    Polygon star;
    for (int i = 0; i < 40; ++i) {
      const double r = radius(random), t = 2 * std::acos(-1.0) * i / 40;
      star.emplace_back(r * std::cos(t), r * std::sin(t));
    }
    ExpectFilled(star);
  }
}

TEST(CutEars, HasNoneForPolygonsThatAreFoldedOrFlipped) {
  EXPECT_TRUE(Ears({{0, 0}, {1, 1}, {1, 0}, {0, 1}}).empty());
  EXPECT_TRUE(Ears({{0, 0}, {0, 1}, {1, 1}, {1, 0}}).empty());
}

TEST(CutEars, AConvexPolygonOfManyCornersTakesLinearlyManySteps) {
  constexpr int kCorners = 20000;
  Polygon circle;
  for (int i = 0; i < kCorners; ++i) {
    const double t = 2 * std::acos(-1.0) * i / kCorners;
    circle.emplace_back(std::cos(t), std::sin(t));
  }
  int turns = 0;
  const auto ears = CutEars(kCorners, [&](int i, int j, int k) {
    ++turns;
    return Orientation(circle[i], circle[j], circle[k]);
  });
  EXPECT_EQ(ears.size(), 3u * (kCorners - 2));
  EXPECT_LT(turns, 10 * kCorners);
}

}  // namespace
}  // namespace cirque::verify
