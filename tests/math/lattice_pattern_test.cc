#include "cirque/math/lattice_pattern.h"

#include <cmath>
#include <complex>

#include <gtest/gtest.h>

#include "cirque/core/types.h"

namespace cirque {
namespace {

using Complex = std::complex<double>;

constexpr LatticeKind kKinds[] = {LatticeKind::kSquares, LatticeKind::kTriangles};

double At(LatticeKind kind, Complex z) { return PatternDistance(kind, {z.real(), z.imag()}); }

/// Places of a quasi-random sequence, in a square of 6 about 0.
Complex Place(int s) {
  return {6 * std::fmod(0.618034 * s, 1) - 3, 6 * std::fmod(0.754878 * s, 1) - 3};
}

TEST(PatternDistance, RepeatsByTheLatticeAndByItsRotationsAndByNothingLess) {
  for (const LatticeKind kind : kKinds) {
    const Lattice periods = PeriodsOf(kind);
    double shifted = 0, turned = 0;
    for (int s = 0; s < 500; ++s) {
      const Complex z = Place(s), corner = 2. * periods.first - periods.second;
      const double here = At(kind, z);
      EXPECT_NEAR(At(kind, z + periods.first), here, 1e-13);
      EXPECT_NEAR(At(kind, z + periods.second), here, 1e-13);
      EXPECT_NEAR(At(kind, corner + periods.Tau() * (z - corner)), here, 1e-13);
      shifted = std::max(shifted, std::abs(At(kind, z + 0.3) - here));
      turned = std::max(turned, std::abs(At(kind, z * std::polar(1., 0.4)) - here));
    }
    EXPECT_GT(shifted, 0.2);
    EXPECT_GT(turned, 0.2);
  }
}

TEST(PatternDistance, IsTheDistanceToTheNearestPlaceOfTheOtherColour) {
  for (const LatticeKind kind : kKinds) {
    for (int s = 0; s < 60; ++s) {
      const Complex z = Place(s);
      const double here = At(kind, z), reach = std::abs(here);
      double least = 10;  // from places on circles about z that have the other colour
      for (double r = 0.005; r < 0.45; r += 0.005) {
        for (int k = 0; k < 180; ++k) {
          if ((At(kind, z + std::polar(r, kPi * k / 90)) > 0) != (here > 0))
            least = std::min(least, r);
        }
      }
      EXPECT_NEAR(least, reach, 0.012) << z;
    }
  }
}

TEST(PatternTile, IsOnePeriodAtPixelMiddlesWithItsShareOfDark) {
  constexpr int kSide = 64;
  for (const LatticeKind kind : kKinds) {
    const std::vector<std::uint8_t> tile = PatternTile(kind, kSide, kSide);
    ASSERT_EQ(tile.size(), std::size_t{kSide * kSide});
    const Lattice periods = PeriodsOf(kind);
    double dark = 0;
    for (int j = 0; j < kSide; ++j) {
      for (int i = 0; i < kSide; ++i) {
        const Complex z = ((i + 0.5) * periods.first + (j + 0.5) * periods.second) / double{kSide};
        const Eigen::Vector2d in_periods = InPeriods(kind, {z.real(), z.imag()});
        EXPECT_NEAR(in_periods.x(), (i + 0.5) / kSide, 1e-14);
        EXPECT_NEAR(in_periods.y(), (j + 0.5) / kSide, 1e-14);
        const int value = tile[j * kSide + i];
        if (At(kind, z) > 1. / kSide) {
          EXPECT_EQ(value, 255);
        }
        if (At(kind, z) < -1. / kSide) {
          EXPECT_EQ(value, 0);
        }
        dark += value / 255.;
      }
    }
    const double share =
        kind == LatticeKind::kSquares ? 0.5 : kPi * 0.3 * 0.3 / (std::sqrt(3.) / 2);
    EXPECT_NEAR(dark / (kSide * kSide), share, 2e-3);
  }
}

}  // namespace
}  // namespace cirque
