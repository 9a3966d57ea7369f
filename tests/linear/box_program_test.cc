// Quadratic programs in a box, made from a known solution and judged by their optimality conditions.
#include "cirque/linear/box_program.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "tests/linear/grid_matrix.h"

namespace cirque {
namespace {

using Eigen::VectorXd;

constexpr int kSide = 12, kUnknowns = kSide * kSide;

/// Of the three kinds of unknowns: at the upper bound, at the lower one, inside.
enum class Kind { kUpper, kLower, kInside };

Kind KindOf(int i) { return i % 3 == 0 ? Kind::kUpper : i % 3 == 1 ? Kind::kLower : Kind::kInside; }

VectorXd Bounds() {
  VectorXd bound(kUnknowns);
  for (int i = 0; i < kUnknowns; ++i) bound[i] = 0.5 + 0.01 * i;
  return bound;
}

VectorXd KnownSolution() {
  VectorXd x = Bounds();
  for (int i = 0; i < kUnknowns; ++i) {
    if (KindOf(i) == Kind::kLower) x[i] = -x[i];
    if (KindOf(i) == Kind::kInside) x[i] *= 0.8 * std::sin(i);
  }
  return x;
}

/// H x - b: pushes out at the bounds, nothing inside.
VectorXd KnownGradient() {
  VectorXd gradient = VectorXd::Zero(kUnknowns);
  for (int i = 0; i < kUnknowns; ++i) {
    if (KindOf(i) == Kind::kUpper) gradient[i] = -(1 + 0.1 * (i % 7));
    if (KindOf(i) == Kind::kLower) gradient[i] = 2 + 0.1 * (i % 5);
  }
  return gradient;
}

BoxProgram ProgramOf(const VectorXd& x, const VectorXd& gradient) {
  BoxProgram program;
  program.hessian = GridMatrix(kSide, 0.3, 2);
  program.bound = Bounds();
  program.linear = program.hessian.selfadjointView<Eigen::Lower>() * x - gradient;
  return program;
}

VectorXd GradientAt(const BoxProgram& program, const VectorXd& x) {
  return program.hessian.selfadjointView<Eigen::Lower>() * x - program.linear;
}

TEST(BoxProgram, FindsTheSolutionItWasMadeFrom) {
  const BoxProgram program = ProgramOf(KnownSolution(), KnownGradient());
  const BoxSolution solution = SolveBoxProgram(program);
  ASSERT_TRUE(solution.converged);
  EXPECT_LT((solution.x - KnownSolution()).lpNorm<Eigen::Infinity>(), 1e-6);
  EXPECT_LT((solution.lower - solution.upper - KnownGradient()).lpNorm<Eigen::Infinity>(), 1e-5);
}

TEST(BoxProgram, MeetsTheConditionsOfOptimality) {
  const BoxProgram program = ProgramOf(KnownSolution(), KnownGradient());
  const BoxSolution s = SolveBoxProgram(program);
  ASSERT_TRUE(s.converged);
  const VectorXd stationarity = GradientAt(program, s.x) - s.lower + s.upper;
  EXPECT_LE(stationarity.lpNorm<Eigen::Infinity>(),
            1.0001e-9 * program.linear.lpNorm<Eigen::Infinity>());
  EXPECT_GE(s.lower.minCoeff(), 0);
  EXPECT_GE(s.upper.minCoeff(), 0);
  EXPECT_LE((s.x.cwiseAbs() - program.bound).maxCoeff(), 0);
  const VectorXd to_lower = s.x + program.bound, to_upper = program.bound - s.x;
  EXPECT_LT(s.lower.cwiseProduct(to_lower).maxCoeff(), 1e-6);
  EXPECT_LT(s.upper.cwiseProduct(to_upper).maxCoeff(), 1e-6);
  EXPECT_GT(s.lower.maxCoeff(), 1);
  EXPECT_GT(s.upper.maxCoeff(), 0.9);
}

TEST(BoxProgram, FarBoundsLeaveTheLinearSystem) {
  BoxProgram program = ProgramOf(KnownSolution(), VectorXd::Zero(kUnknowns));
  program.bound.setConstant(1e3);
  const BoxSolution solution = SolveBoxProgram(program, 1e-14);
  ASSERT_TRUE(solution.converged);
  EXPECT_LT((solution.x - KnownSolution()).lpNorm<Eigen::Infinity>(), 1e-5);
}

TEST(BoxProgram, ScalingTheObjectiveScalesTheMultipliersAlone) {
  BoxProgram program = ProgramOf(KnownSolution(), KnownGradient());
  const BoxSolution plain = SolveBoxProgram(program);
  program.hessian *= 1024;
  program.linear *= 1024;
  const BoxSolution scaled = SolveBoxProgram(program);
  ASSERT_TRUE(plain.converged && scaled.converged);
  EXPECT_LT((plain.x - scaled.x).lpNorm<Eigen::Infinity>(), 1e-7);
  EXPECT_LT((1024 * plain.upper - scaled.upper).lpNorm<Eigen::Infinity>(), 1e-2);
}

TEST(BoxProgram, NoFeasibleMoveLowersTheObjective) {
  const BoxProgram program = ProgramOf(KnownSolution(), KnownGradient());
  const VectorXd x = SolveBoxProgram(program).x;
  const auto value = [&](const VectorXd& at) {
    return 0.5 * at.dot(program.hessian.selfadjointView<Eigen::Lower>() * at) -
           program.linear.dot(at);
  };
  const double least = value(x);
  for (int i = 0; i < kUnknowns; ++i) {
    for (const double move : {-1e-3, 1e-3}) {
      VectorXd moved = x;
      moved[i] = std::clamp(moved[i] + move, -program.bound[i], program.bound[i]);
      EXPECT_GE(value(moved), least - 1e-6) << i;
    }
  }
}

}  // namespace
}  // namespace cirque
