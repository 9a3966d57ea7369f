#include "cirque/math/lattice.h"

#include <cmath>
#include <random>

#include <gtest/gtest.h>

namespace cirque {
namespace {

using C = std::complex<double>;

TEST(ReduceLattice, TauIsInTheFundamentalDomainWhateverBasisIsGiven) {
  std::mt19937 random(5);
  const auto uniform = [&] { return static_cast<double>(random() % 1000) / 500 - 1; };
  for (int trial = 0; trial < 200; ++trial) {
    const C a(uniform(), uniform()), b(uniform() + 3, uniform());
    if (std::abs((std::conj(a) * b).imag()) < 1e-2) continue;
    const C tau = ReduceLattice(a, b).Tau();
    EXPECT_GT(tau.imag(), 0);
    EXPECT_GE(std::abs(tau), 1 - 1e-12);
    EXPECT_LE(std::abs(tau.real()), 0.5 + 1e-12);
    // Another basis of the same lattice, of determinant 1.
    const C other = ReduceLattice(7.0 * a + 3.0 * b, 2.0 * a + b).Tau();
    EXPECT_NEAR(other.imag(), tau.imag(), 1e-9 * tau.imag());
    EXPECT_NEAR(std::abs(other.real()), std::abs(tau.real()), 1e-9 * std::abs(tau));
  }
}

TEST(ReduceLattice, KnowsTheSquareAndTheHexagon) {
  EXPECT_NEAR(std::abs(ReduceLattice(C(3, 1), C(2, 1)).Tau() - C(0, 1)), 0, 1e-14);
  const C hexagon = ReduceLattice(C(1, 0), C(2.5, std::sqrt(0.75))).Tau();
  EXPECT_NEAR(hexagon.imag(), std::sqrt(0.75), 1e-14);
  EXPECT_NEAR(std::abs(hexagon.real()), 0.5, 1e-14);
}

TEST(Lattice, CoordinatesAreTheFactorsOfThePeriods) {
  const Lattice lattice{C(2, 1), C(-1, 3)};
  const auto [a, b] = lattice.Coordinates(4.0 * lattice.first - 1.5 * lattice.second);
  EXPECT_NEAR(a, 4, 1e-14);
  EXPECT_NEAR(b, -1.5, 1e-14);
}

TEST(RoundToGrid, SumsOfGridPointsAreExact) {
  const double x = RoundToGrid(0.1, -40), period = RoundToGrid(1.7, -40);
  EXPECT_NEAR(x, 0.1, std::ldexp(1.0, -41));
  EXPECT_EQ((x + period) - x, period);
}

}  // namespace
}  // namespace cirque
