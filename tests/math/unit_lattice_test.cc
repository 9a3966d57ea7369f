#include "cirque/math/unit_lattice.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

namespace cirque {
namespace {

TEST(NearestInLattice, IsTheNearestOfAll) {
  for (const LatticeKind kind : {LatticeKind::kSquares, LatticeKind::kTriangles}) {
    const double height = kind == LatticeKind::kSquares ? 1 : std::sqrt(3.) / 2;
    for (int s = 0; s < 200; ++s) {
      const Eigen::Vector2d p(6 * std::fmod(0.618034 * s, 1) - 3,
                              6 * std::fmod(0.754878 * s, 1) - 3);
      double least = 100;
      for (int j = -6; j <= 6; ++j) {
        for (int i = -10; i <= 10; ++i) {
          const double x = kind == LatticeKind::kSquares ? i : i + j / 2.;
          least = std::min(least, (Eigen::Vector2d(x, j * height) - p).norm());
        }
      }
      EXPECT_NEAR((NearestInLattice(kind, p) - p).norm(), least, 1e-12);
    }
  }
}

TEST(PeriodsOf, SpanTheLatticeAndAreARotationApart) {
  for (const LatticeKind kind : {LatticeKind::kSquares, LatticeKind::kTriangles}) {
    const Lattice periods = PeriodsOf(kind);
    EXPECT_LT(std::abs(std::pow(periods.Tau(), OrderOf(kind)) - 1.), 1e-14);
    for (const auto& z : {periods.first, periods.second, 3. * periods.first - periods.second}) {
      const Eigen::Vector2d point(z.real(), z.imag());
      EXPECT_LT((NearestInLattice(kind, point) - point).norm(), 1e-14);
    }
    EXPECT_EQ(LatticeOfOrder(OrderOf(kind)), kind);
  }
  for (const int order : {0, 1, 2, 3, 5, 8}) EXPECT_FALSE(LatticeOfOrder(order));
}

}  // namespace
}  // namespace cirque
