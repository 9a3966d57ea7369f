// Laplacians with weights of any range against what resistors in series have.
#include "cirque/equivalence/laplacian_newton.h"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

namespace cirque {
namespace {

/// A chain of vertices, numbered in the given order, with these conductances between neighbours.
Eigen::MatrixXd Chain(const std::vector<double>& conductance, const std::vector<int>& number) {
  const auto n = static_cast<Eigen::Index>(number.size());
  Eigen::MatrixXd weight = Eigen::MatrixXd::Zero(n, n);
  for (std::size_t i = 0; i < conductance.size(); ++i) {
    weight(number[i], number[i + 1]) = weight(number[i + 1], number[i]) = conductance[i];
  }
  return weight;
}

TEST(SolveLaplacian, ResistorsInSeriesAddUpWhateverTheirRange) {
  const std::vector<double> conductance = {1e18, 3e-4, 2e15, 5e-9, 1, 7e20};
  for (const auto& number : std::vector<std::vector<int>>{
           {0, 1, 2, 3, 4, 5, 6}, {6, 5, 4, 3, 2, 1, 0}, {3, 0, 6, 1, 5, 2, 4}}) {
    const Eigen::MatrixXd weight = Chain(conductance, number);
    // A current of 2 from the last vertex to the first, which is held by a conductance of 1e-6.
    Eigen::VectorXd held = Eigen::VectorXd::Zero(7), b = held;
    held[number[0]] = 1e-6;
    b[number[6]] = 2;
    const Eigen::VectorXd x = SolveLaplacian(weight, held, b);
    double potential = 2 / 1e-6;
    EXPECT_NEAR(x[number[0]], potential, 1e-12 * potential);
    for (std::size_t i = 0; i < conductance.size(); ++i) {
      potential += 2 / conductance[i];
      EXPECT_NEAR(x[number[i + 1]], potential, 1e-12 * potential);
    }
  }
}

TEST(SolveLaplacian, WhereNothingIsHeldTheFirstUnknownIsZeroAndDifferencesAreRight) {
  const std::vector<double> conductance = {1e16, 2, 1e16};
  const Eigen::MatrixXd weight = Chain(conductance, {0, 1, 2, 3});
  Eigen::VectorXd b = Eigen::VectorXd::Zero(4);
  b[0] = -1;
  b[3] = 1;
  const Eigen::VectorXd x = SolveLaplacian(weight, Eigen::VectorXd::Zero(4), b);
  EXPECT_EQ(x[0], 0);
  EXPECT_NEAR(x[1], 1e-16, 1e-28);
  EXPECT_NEAR(x[2] - x[1], 0.5, 1e-12);
  EXPECT_NEAR(x[3], 0.5, 1e-12);
}

TEST(SolveLaplacian, RoundingMovesNoPairWhoseDifferenceIsBelowTheSpacingOfDoublesThere) {
  // A needle's short side: two vertices joined by 1e30, of which rounding of b would move both by 1e-16,
  // where doubles are 1e-32 apart.
  Eigen::MatrixXd weight = Eigen::MatrixXd::Zero(2, 2);
  weight(0, 1) = weight(1, 0) = 1e30;
  const Eigen::Vector2d held(1, 0), b(1e-5, -1e-5 + 1e-16);
  const Eigen::VectorXd lost = SolveLaplacian(weight, held, b);
  const Eigen::VectorXd x = SolveLaplacian(weight, held, b, 1e-14);
  EXPECT_EQ(lost[0], lost[1]);
  EXPECT_EQ(x[0], 0);
  EXPECT_NEAR(x[1], -1e-35, 1e-45);
}

}  // namespace
}  // namespace cirque
