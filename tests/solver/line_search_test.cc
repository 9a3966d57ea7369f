#include "cirque/solver/line_search.h"

#include <functional>

#include <gtest/gtest.h>

#include "tests/solver/strategy_fixtures.h"

namespace cirque {
namespace {

/// One parameter, given by its derivative, which is all that the search may use; false outside.
class Slope final : public Energy {
 public:
  explicit Slope(std::function<bool(double, double*)> slope) : slope_(std::move(slope)) {}
  int NumParameters() const override { return 1; }
  bool Evaluate(const double*, double*, double*) const override { return false; }
  bool Gradient(const double* x, double* gradient) const override { return slope_(*x, gradient); }
  bool Hessian(const double*, SparseMatrix*) const override { return false; }

 private:
  std::function<bool(double, double*)> slope_;
};

struct Outcome {
  LineSearchResult step;
  int evaluations;
};

/// Searches from x along p.
Outcome Search(const std::function<bool(double, double*)>& slope, double x, double p) {
  const Slope energy(slope);
  const SolveControl control;
  SolveRun run("test", {}, control, energy);
  const Eigen::VectorXd start = Eigen::VectorXd::Constant(1, x);
  Eigen::VectorXd gradient(1);
  EXPECT_TRUE(slope(x, gradient.data()));
  LineSearchResult step;
  SearchAlong(start, gradient, Eigen::VectorXd::Constant(1, p), &run, &step);
  return {step, run.summary().gradient_evaluations};
}

bool Parabola(double x, double* slope) {
  *slope = x;
  return true;
}

TEST(LineSearch, TakesTheFullStepToTheMinimum) {
  const Outcome found = Search(Parabola, 1, -1);
  ASSERT_TRUE(found.step.found);
  EXPECT_EQ(found.step.step_length, 1);
  EXPECT_EQ(found.step.x[0], 0);
  EXPECT_EQ(found.step.gradient[0], 0);
  EXPECT_EQ(found.evaluations, 1);
}

TEST(LineSearch, TakesAStepThatFallsShort) {
  const Outcome found = Search(Parabola, 1, -0.5);
  EXPECT_EQ(found.step.step_length, 1);
  EXPECT_EQ(found.evaluations, 1);
}

TEST(LineSearch, DoublesAStepThatHardlyChangesTheSlope) {
  // 0.01 of the way: the slope keeps 99 % of its size until after several doublings.
  const Outcome found = Search(Parabola, 1, -0.01);
  EXPECT_EQ(found.step.step_length, 16);
  EXPECT_LE(found.step.gradient[0], 0.9);
}

TEST(LineSearch, AcceptsAnOvershootThatIsClearlyNearer) {
  const Outcome found = Search(Parabola, 1, -1.4);
  EXPECT_EQ(found.step.step_length, 1);
  EXPECT_NEAR(found.step.gradient[0], -0.4, 1e-15);
}

TEST(LineSearch, CutsAnOvershootByTheSecant) {
  // The slope is linear, so the secant's zero is the minimum.
  const Outcome found = Search(Parabola, 1, -8);
  ASSERT_TRUE(found.step.found);
  EXPECT_NEAR(found.step.step_length, 0.125, 1e-15);
  EXPECT_NEAR(found.step.x[0], 0, 1e-15);
  EXPECT_EQ(found.evaluations, 2);
}

TEST(LineSearch, BracketsAJumpOfTheSlope) {
  // |x - 0.3| smoothed over 1e-9: saturated on both sides.
  const auto wall = [](double x, double* slope) {
    *slope = std::tanh((x - 0.3) / 1e-9);
    return true;
  };
  const Outcome found = Search(wall, 5, -1000);
  ASSERT_TRUE(found.step.found);
  EXPECT_LT(std::abs(found.step.x[0] - 0.3), 4.7);
  EXPECT_LE(found.step.gradient[0] * -1000, 500);
}

TEST(LineSearch, HalvesOutOfTheDomain) {
  const auto barrier = [](double x, double* slope) {
    if (x <= 0) return false;
    *slope = 1 - 0.1 / x;
    return true;
  };
  const Outcome found = Search(barrier, 1, -8);
  ASSERT_TRUE(found.step.found);
  EXPECT_GT(found.step.x[0], 0);
  EXPECT_LT(std::abs(found.step.gradient[0]), 0.9);
}

TEST(LineSearch, FindsNothingWhereNoPointIsDefined) {
  const auto point = [](double x, double* slope) {
    *slope = 1;
    return x == 1;
  };
  EXPECT_FALSE(Search(point, 1, -1).step.found);
}

}  // namespace
}  // namespace cirque
