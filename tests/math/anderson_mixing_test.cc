#include "cirque/math/anderson_mixing.h"

#include <cmath>

#include <gtest/gtest.h>

namespace cirque {
namespace {

// With as many pairs as unknowns it is a quasi-Newton method, exact for a linear G.
TEST(AndersonMixing, SolvesALinearFixedPointInOneStepMoreThanUnknowns) {
  const Eigen::Matrix3d g{{0.9, 0.2, 0}, {-0.1, -0.8, 0.3}, {0.2, 0, 0.99}};
  const Eigen::Vector3d fixed(1, -2, 0.5);
  Eigen::VectorXd x = Eigen::Vector3d(4, 4, 4);
  AndersonMixing mixing(5);
  for (int k = 0; k < 5; ++k) x = mixing.Next(x, g * (x - fixed) + fixed - x);
  EXPECT_LT((x - fixed).norm(), 1e-9);
}

TEST(AndersonMixing, ConvergesFasterThanTheIterationItself) {
  Eigen::VectorXd plain = Eigen::VectorXd::LinSpaced(20, 0.1, 1), mixed = plain;
  AndersonMixing mixing(4);
  const auto g = [](const Eigen::VectorXd& x) -> Eigen::VectorXd { return x.array().cos(); };
  for (int k = 0; k < 10; ++k) {
    plain = g(plain);
    mixed = mixing.Next(mixed, g(mixed) - mixed);
  }
  const double at_rest = 0.7390851332151607;
  EXPECT_LT((mixed.array() - at_rest).abs().maxCoeff(),
            1e-4 * (plain.array() - at_rest).abs().maxCoeff());
}

// A direction in which nothing changes stays where it is.
TEST(AndersonMixing, LeavesWhatIsNeutral) {
  Eigen::VectorXd x = Eigen::Vector2d(3, 1);
  AndersonMixing mixing(5);
  for (int k = 0; k < 8; ++k) x = mixing.Next(x, Eigen::Vector2d(0, -0.5 * x[1]));
  EXPECT_EQ(x[0], 3);
  EXPECT_NEAR(x[1], 0, 1e-12);
}

}  // namespace
}  // namespace cirque
