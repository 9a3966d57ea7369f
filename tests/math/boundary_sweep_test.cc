#include "cirque/math/boundary_sweep.h"

#include <cmath>
#include <random>

#include <gtest/gtest.h>

namespace cirque {
namespace {

using Point = Eigen::Vector2d;
using Polygon = std::vector<Point>;

std::vector<DirectedSegment> Borders(const std::vector<Polygon>& polygons) {
  std::vector<DirectedSegment> edges;
  for (const Polygon& p : polygons) {
    for (std::size_t i = 0; i < p.size(); ++i) edges.push_back({p[i], p[(i + 1) % p.size()]});
  }
  return edges;
}

bool Overlaps(const std::vector<Polygon>& polygons) {
  return FindOverlap(Borders(polygons)).has_value();
}

Polygon Square(double x, double y, double size) {
  return {{x, y}, {x + size, y}, {x + size, y + size}, {x, y + size}};
}

/// Half the square.
Polygon Triangle(double x, double y, double size) { return {{x, y}, {x + size, y}, {x, y + size}}; }

TEST(FindOverlap, TouchingIsNone) {
  EXPECT_FALSE(Overlaps({Square(0, 0, 2), Square(2, 0, 2)}));                      // a side
  EXPECT_FALSE(Overlaps({Square(0, 0, 2), Square(2, 1, 2)}));                      // half of one
  EXPECT_FALSE(Overlaps({Square(0, 0, 2), Square(2, 2, 2)}));                      // a corner
  EXPECT_FALSE(Overlaps({Square(0, 0, 2), {{2, 1}, {3, 0}, {3, 2}}}));             // one on a side
  EXPECT_FALSE(Overlaps({Triangle(0, 0, 2), {{2, 0}, {2, 2}, {0, 2}}}));           // the diagonal
  EXPECT_FALSE(Overlaps({{{0, 0}, {4, 0}, {2, 2}}, {{1, -1}, {3, -1}, {2, 0}}}));  // below
  EXPECT_FALSE(Overlaps({{{0, 0}, {2, 0}, {4, 0}, {2, 2}}, {{2, 0}, {1, -1}, {3, -1}}}));
}

TEST(FindOverlap, EveryKindOfOverlapIsFound) {
  EXPECT_TRUE(Overlaps({Square(0, 0, 2), Square(1, 1, 2)}));             // crossing sides
  EXPECT_TRUE(Overlaps({Square(0, 0, 4), Square(1, 1, 2)}));             // one in the other
  EXPECT_TRUE(Overlaps({Square(0, 0, 2), Square(0, 0, 2)}));             // one upon the other
  EXPECT_TRUE(Overlaps({Square(0, 0, 4), Square(0, 0, 2)}));             // in a corner
  EXPECT_TRUE(Overlaps({Square(0, 0, 4), Square(1, 0, 2)}));             // along a side
  EXPECT_TRUE(Overlaps({Square(0, 0, 4), {{2, 0}, {3, 3}, {1, 3}}}));    // from a point of a side
  EXPECT_TRUE(Overlaps({Square(0, 0, 2), {{0, 1}, {2, 1}, {1, 1.5}}}));  // from side to side
  EXPECT_TRUE(Overlaps({{{0, 0}, {3, 1}, {0, 2}}, {{1, 1}, {3, 1}, {1, 2}}}));  // at a tip
  // Three lines through one point, all of whose corners are elsewhere.
  EXPECT_TRUE(Overlaps({{{-2, -1}, {2, 1}, {-2, 3}}, {{-2, -3}, {3, -3}, {2, 2}, {-2, -2}}}));
}

// A point is covered as often as the polygons that hold it say.
TEST(FindOverlap, AgreesWithCountingCellsOfAGrid) {
  std::mt19937 random(4);
  const auto coordinate = [&] { return static_cast<double>(random() % 6); };
  int overlapping = 0;
  for (int trial = 0; trial < 3000; ++trial) {
    std::vector<Polygon> squares;
    int covered[12][12] = {};
    bool twice = false;
    for (int k = 0; k < 2 + trial % 3; ++k) {
      const double x = coordinate(), y = coordinate(), size = 1 + static_cast<double>(random() % 3);
      squares.push_back(Square(x, y, size));
      for (int i = 0; i < static_cast<int>(size); ++i) {
        for (int j = 0; j < static_cast<int>(size); ++j) {
          twice = covered[static_cast<int>(x) + i][static_cast<int>(y) + j]++ > 0 || twice;
        }
      }
    }
    // Sheared, so that no side is upright or level.
    for (Polygon& p : squares) {
      for (Point& q : p) q = trial % 2 == 0 ? q : Point(3 * q.x() + q.y(), q.x() - 2 * q.y());
      if (trial % 2 != 0) std::swap(p[1], p[3]);
    }
    ASSERT_EQ(Overlaps(squares), twice) << trial;
    overlapping += twice;
  }
  EXPECT_GT(overlapping, 500);
  EXPECT_LT(overlapping, 2500);
}

/// A star-shaped polygon about the origin.
Polygon Star(int corners, std::mt19937* random) {
  std::uniform_real_distribution<double> radius(0.3, 1);
  Polygon star;
  for (int i = 0; i < corners; ++i) {
    const double r = radius(*random), t = 2 * std::acos(-1.0) * i / corners;
    star.emplace_back(r * std::cos(t), r * std::sin(t));
  }
  return star;
}

TEST(FindOverlap, SimplePolygonsPassTheStrictTestAndOthersDoNot) {
  std::mt19937 random(6);
  for (int trial = 0; trial < 200; ++trial) {
    Polygon star = Star(12, &random);
    EXPECT_FALSE(FindOverlap(Borders({star}), Contacts::kEndsOnly).has_value());
    std::swap(star[2], star[7]);  // now two edges cross, or there is no star
    EXPECT_TRUE(FindOverlap(Borders({star}), Contacts::kEndsOnly).has_value());
  }
  const Polygon pinched = {{0, 0}, {2, 0}, {1, 1}, {2, 2}, {0, 2}, {1, 1}};
  EXPECT_FALSE(FindOverlap(Borders({pinched})).has_value());
  EXPECT_TRUE(FindOverlap(Borders({pinched}), Contacts::kEndsOnly).has_value());
  const Polygon on_a_side = {{0, 0}, {2, 0}, {2, 2}, {1, 0}, {0, 2}};
  EXPECT_TRUE(FindOverlap(Borders({on_a_side}), Contacts::kEndsOnly).has_value());
}

TEST(FindOverlap, IsExactWhereFloatingPointIsNot) {
  const double tiny = std::ldexp(1, -53);
  // The tip lies on the line from (0, 0) to (1, 1), or one unit in the last place beside it.
  const Polygon below = {{0, 0}, {1, -1}, {1, 1}};
  EXPECT_FALSE(Overlaps({below, {{0.5, 0.5}, {0.75, 2}, {0, 2}}}));
  EXPECT_FALSE(Overlaps({below, {{0.5, 0.5 + 2 * tiny}, {0.75, 2}, {0, 2}}}));
  EXPECT_TRUE(Overlaps({below, {{0.5, 0.5 - tiny}, {0.75, 2}, {0, 2}}}));
}

TEST(FindOverlap, ManyPatchesRoundAPointAndManyInOneAnother) {
  constexpr int kCount = 2000;
  const auto rim = [](int i) {
    const double t = 2 * std::acos(-1.0) * i / kCount;
    return Point(std::cos(t), std::sin(t));
  };
  std::vector<Polygon> wedges, rings;
  for (int i = 0; i < kCount; ++i) wedges.push_back({{0, 0}, rim(i), rim((i + 1) % kCount)});
  EXPECT_FALSE(Overlaps(wedges));
  wedges.push_back({{0, 0}, {0.1, 0}, {0, 0.1}});
  EXPECT_TRUE(Overlaps(wedges));
  for (int i = 1; i <= kCount; ++i) {  // diamonds, every other one with its inside cut out
    const double r = i;
    rings.push_back({{r, 0}, {0, r}, {-r, 0}, {0, -r}});
    if (i % 2 != 0) std::swap(rings.back()[1], rings.back()[3]);
  }
  EXPECT_FALSE(Overlaps(rings));
  std::swap(rings[1000][1], rings[1000][3]);
  EXPECT_TRUE(Overlaps(rings));
}

TEST(Intersect, KnowsCrossingTouchingAndApart) {
  const DirectedSegment level{{0, 0}, {4, 0}};
  EXPECT_TRUE(Intersect(level, {{1, -1}, {2, 1}}));
  EXPECT_TRUE(Intersect(level, {{1, 0}, {2, 1}}));
  EXPECT_TRUE(Intersect(level, {{4, 0}, {6, 0}}));
  EXPECT_TRUE(Intersect(level, {{3, 0}, {1, 0}}));
  EXPECT_FALSE(Intersect(level, {{5, 0}, {6, 0}}));
  EXPECT_FALSE(Intersect(level, {{1, 1}, {2, 2}}));
  EXPECT_FALSE(Intersect(level, {{5, -1}, {5, 1}}));
}

}  // namespace
}  // namespace cirque
