#include <cmath>
#include <limits>
#include <random>
#include <set>

#include <gtest/gtest.h>

#include "cirque/verify/overlap_check.h"
#include "cirque/verify/uv_plane.h"

namespace cirque::verify {
namespace {

int NaiveSign(const Point& a, const Point& b, const Point& c) {
  const double area = (a.x() - c.x()) * (b.y() - c.y()) - (a.y() - c.y()) * (b.x() - c.x());
  return (area > 0) - (area < 0);
}

__extension__ using Wide = __int128;

/// The same determinant in 128-bit integers, for coordinates that are multiples of 2^-53 below 32.
int IntegerSign(const Point& a, const Point& b, const Point& c) {
  const auto fixed = [](double x) { return static_cast<Wide>(std::ldexp(x, 53)); };
  const Wide area = (fixed(a.x()) - fixed(c.x())) * (fixed(b.y()) - fixed(c.y())) -
                    (fixed(a.y()) - fixed(c.y())) * (fixed(b.x()) - fixed(c.x()));
  return (area > 0) - (area < 0);
}

TEST(VerifyMapExact, OrientationIsRightWhereFloatingPointIsWrong) {
  const Point b(12, 12), c(24, 24);
  int naive_wrong = 0;
  for (int i = 0; i < 64; ++i) {
    for (int j = 0; j < 64; ++j) {
      const Point a(0.5 + std::ldexp(i, -53), 0.5 + std::ldexp(j, -53));
      ASSERT_EQ(Orientation(a, b, c), IntegerSign(a, b, c)) << i << " " << j;
      ASSERT_EQ(Orientation(b, a, c), -IntegerSign(a, b, c)) << i << " " << j;
      naive_wrong += NaiveSign(a, b, c) != IntegerSign(a, b, c);
    }
  }
  EXPECT_GT(naive_wrong, 100);
}

TEST(VerifyMapExact, OrientationSurvivesUnderflowAndOverflow) {
  const double tiny = std::numeric_limits<double>::denorm_min();
  EXPECT_EQ(Orientation({0, 0}, {tiny, 0}, {0, tiny}), 1);
  EXPECT_EQ(Orientation({0, 0}, {0, tiny}, {tiny, 0}), -1);
  EXPECT_EQ(Orientation({0, 0}, {tiny, tiny}, {2 * tiny, 2 * tiny}), 0);
  EXPECT_EQ(Orientation({-1e308, -1e308}, {1e308, -1e308}, {0, 1e308}), 1);
  EXPECT_EQ(Orientation({-1e308, -1e308}, {0, 0}, {1e308, 1e308}), 0);
}

TEST(VerifyMapExact, SectorsOfEverySizeKnowTheirInside) {
  const Point o(0, 0), east(1, 0), north(0, 1), west(-1, 0), south(0, -1);
  EXPECT_TRUE(Contains({o, east, north}, {1, 1}));
  EXPECT_FALSE(Contains({o, east, north}, {-1, -1}));
  EXPECT_FALSE(Contains({o, east, north}, {2, 0}));
  EXPECT_TRUE(Contains({o, east, west}, {0, 1}));
  EXPECT_FALSE(Contains({o, east, west}, {0, -1}));
  EXPECT_TRUE(Contains({o, east, south}, {-1, 0.5}));
  EXPECT_FALSE(Contains({o, east, south}, {1, -1}));
  EXPECT_FALSE(Contains({o, east, south}, {0, -3}));
  EXPECT_TRUE(Contains({o, east, east}, {-1, 0}));
  EXPECT_FALSE(Contains({o, east, east}, {5, 0}));
  EXPECT_TRUE(Overlap({o, east, north}, {o, east, west}));
  EXPECT_TRUE(Overlap({o, east, west}, {o, north, south}));
  EXPECT_FALSE(Overlap({o, east, north}, {o, north, east}));
  EXPECT_FALSE(Overlap({o, east, north}, {o, west, south}));
}

TEST(VerifyMapExact, RayCrossingsSumToTheWindingNumber) {
  const Point square[] = {{0, 0}, {4, 0}, {4, 4}, {0, 4}};
  const Point inside[3] = {{1, 1}, {2, 1}, {1, 2}}, outside[3] = {{-3, 1}, {-2, 1}, {-3, 2}};
  int about_inside = 0, about_outside = 0;
  for (int i = 0; i < 4; ++i) {
    about_inside += RayCrossing(inside, square[i], square[(i + 1) % 4]);
    about_outside += RayCrossing(outside, square[i], square[(i + 1) % 4]);
  }
  EXPECT_EQ(about_inside, 1);
  EXPECT_EQ(about_outside, 0);
}

TEST(VerifyMapExact, SegmentTreeFindsExactlyTheTouchingBoxes) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> coordinate(0, 1), size(0, 0.1);
  std::vector<SegmentTree::Segment> segments;
  for (int i = 0; i < 300; ++i) {
    const Point tail(coordinate(random), coordinate(random));
    segments.push_back({tail, tail + Point(size(random) - 0.05, size(random) - 0.05)});
  }
  std::set<std::pair<int, int>> found, expected;
  SegmentTree(segments).VisitTouchingBoxes([&](int i, int j) {
    EXPECT_TRUE(found.emplace(i, j).second) << "visited twice";
    return true;
  });
  const auto box = [&](int i) {
    const auto& [a, b] = segments[i];
    return Eigen::AlignedBox2d(a.cwiseMin(b), a.cwiseMax(b));
  };
  for (int i = 0; i < 300; ++i) {
    for (int j = i + 1; j < 300; ++j) {
      if (box(i).intersects(box(j))) expected.emplace(i, j);
    }
  }
  EXPECT_GT(expected.size(), 50u);
  EXPECT_EQ(found, expected);
}

TEST(VerifyMapExact, SegmentTreeVisitsFewPairsOfACurveWithLengthsOfEverySize) {
  std::vector<SegmentTree::Segment> segments;
  constexpr int kCount = 20000;
  const auto spiral = [](int i) {
    const double t = 40.0 * i / kCount;  // the radius grows by e^40
    return Point(std::exp(t) * std::cos(5 * t), std::exp(t) * std::sin(5 * t));
  };
  for (int i = 0; i < kCount; ++i) segments.push_back({spiral(i), spiral(i + 1)});
  int visited = 0;
  SegmentTree(segments).VisitTouchingBoxes([&](int, int) { return ++visited > 0; });
  EXPECT_GE(visited, kCount - 1);
  EXPECT_LT(visited, 2 * kCount);
}

}  // namespace
}  // namespace cirque::verify
