#include <cmath>
#include <limits>

#include <gtest/gtest.h>

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
  EXPECT_TRUE(IsInSector({o, east, north}, {1, 1}));
  EXPECT_FALSE(IsInSector({o, east, north}, {-1, -1}));
  EXPECT_FALSE(IsInSector({o, east, north}, {2, 0}));
  EXPECT_TRUE(IsInSector({o, east, west}, {0, 1}));
  EXPECT_FALSE(IsInSector({o, east, west}, {0, -1}));
  EXPECT_TRUE(IsInSector({o, east, south}, {-1, 0.5}));
  EXPECT_FALSE(IsInSector({o, east, south}, {1, -1}));
  EXPECT_FALSE(IsInSector({o, east, south}, {0, -3}));
  EXPECT_TRUE(IsInSector({o, east, east}, {-1, 0}));
  EXPECT_FALSE(IsInSector({o, east, east}, {5, 0}));
}

}  // namespace
}  // namespace cirque::verify
