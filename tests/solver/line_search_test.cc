#include "cirque/solver/line_search.h"

#include <cmath>
#include <functional>

#include <gtest/gtest.h>

#include "cirque/solver/newton_loop.h"

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
Outcome Search(const std::function<bool(double, double*)>& slope, double x, double p,
               LineSearch search = SearchAlong) {
  const Slope energy(slope);
  const SolveControl control;
  SolveRun run("test", {}, control, energy);
  const Eigen::VectorXd start = Eigen::VectorXd::Constant(1, x);
  Eigen::VectorXd gradient(1);
  EXPECT_TRUE(slope(x, gradient.data()));
  LineSearchResult step;
  search(start, gradient, Eigen::VectorXd::Constant(1, p), &run, &step);
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

/// A crease at 100, much narrower than what lies before it.
bool Crease(double x, double* slope) {
  *slope = std::tanh(1e5 * (x - 100)) + 0.25;
  return true;
}

TEST(LineSearch, ToRestEndsInACreaseHoweverTheStepFallsShortOrOvershoots) {
  const double minimum = 100 - 1e-5 * std::atanh(0.25);
  for (const double p : {1e-3, 1.0, 1e4, 1e9}) {
    const Outcome found = Search(Crease, 0, p, SearchToRest);
    ASSERT_TRUE(found.step.found);
    EXPECT_LE(std::abs(found.step.gradient[0]), 0.075) << p;
    EXPECT_NEAR(found.step.x[0], minimum, 1e-6) << p;
    EXPECT_NEAR(found.step.step_length * p, found.step.x[0], 1e-9);
    EXPECT_LE(found.evaluations, 70);
  }
}

TEST(LineSearch, ToRestTakesNewtonsStepAtOnce) {
  const Outcome found = Search(Parabola, 1, -1, SearchToRest);
  EXPECT_EQ(found.step.x[0], 0);
  EXPECT_EQ(found.evaluations, 1);
}

TEST(LineSearch, ToRestStaysInsideTheDomainAndSaysWhereThereIsNone) {
  const auto wall = [](double x, double* slope) {
    *slope = x - 1.5;
    return x < 2;
  };
  const Outcome inside = Search(wall, 0, 100, SearchToRest);
  ASSERT_TRUE(inside.step.found);
  EXPECT_NEAR(inside.step.x[0], 1.5, 0.15);
  const auto point = [](double x, double* slope) {
    *slope = -1;
    return x == 0;
  };
  EXPECT_FALSE(Search(point, 0, 1, SearchToRest).step.found);
}

}  // namespace
}  // namespace cirque
