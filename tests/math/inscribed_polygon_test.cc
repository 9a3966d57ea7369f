#include "cirque/math/inscribed_polygon.h"

#include <cmath>
#include <complex>
#include <numbers>
#include <numeric>
#include <vector>

#include <gtest/gtest.h>

namespace cirque {
namespace {

constexpr double kPi = std::numbers::pi;

TEST(HalfCentralAngles, OfARegularPolygonAreEqual) {
  for (const int n : {3, 4, 7, 1000}) {
    for (const double half : HalfCentralAngles(std::vector<double>(n, 0.3))) {
      EXPECT_NEAR(half, kPi / n, 1e-12);
    }
  }
}

// The law of sines: half of a central angle is the angle that the edge is seen by from the circle.
TEST(HalfCentralAngles, OfATriangleAreItsAngles) {
  for (const auto& [a, b] : {std::pair(1.0, 0.9), {2.0, 0.6}, {0.1, 3.0}, {kPi / 2, 0.7}}) {
    const std::vector<double> angle = {a, b, kPi - a - b};
    const std::vector<double> half =
        HalfCentralAngles({std::sin(a), std::sin(b), std::sin(angle[2])});
    for (int k = 0; k < 3; ++k) EXPECT_NEAR(half[k], angle[k], 1e-12) << a << " " << k;
  }
}

TEST(HalfCentralAngles, CloseThePolygonThatTheyAreOf) {
  const std::vector<double> lengths = {1, 0.2, 0.7, 1.9, 0.4, 0.3};
  for (const double longest : {0.5, 1.9, 2.4, 2.59}) {
    std::vector<double> of = lengths;
    of[3] = longest;
    const std::vector<double> half = HalfCentralAngles(of);
    EXPECT_NEAR(std::accumulate(half.begin(), half.end(), 0.0), kPi, 1e-13);
    std::complex<double> end = 0;
    double direction = 0;
    for (std::size_t i = 0; i < of.size(); ++i) {
      end += std::polar(of[i], direction);
      direction += half[i] + half[(i + 1) % of.size()];
    }
    EXPECT_LT(std::abs(end), 1e-6) << longest;
    EXPECT_NEAR(direction, 2 * kPi, 1e-13);
  }
}

TEST(HalfCentralAngles, OfLengthsThatDoNotCloseAreNumbers) {
  for (const double half : HalfCentralAngles({1, 5, 1, 1})) {
    EXPECT_GT(half, 0);
    EXPECT_LT(half, kPi);
  }
}

}  // namespace
}  // namespace cirque
