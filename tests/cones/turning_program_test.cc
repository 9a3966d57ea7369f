#include "cirque/cones/turning_program.h"

#include <cmath>
#include <random>
#include <vector>

#include <gtest/gtest.h>

namespace cirque {
namespace {

using Eigen::VectorXd;

double ArcSum(const VectorXd& x, Index first, Index count) {
  double sum = 0;
  for (Index i = 0; i < count; ++i) sum += x[(first + i) % x.size()];
  return sum;
}

double FarthestBack(const VectorXd& x) {
  double deepest = 0;
  for (Index first = 0; first < x.size(); ++first) {
    for (Index count = 1; count < x.size(); ++count) {
      deepest = std::min(deepest, ArcSum(x, first, count));
    }
  }
  return deepest;
}

/// Corners that turn by 2 pi in all, some far back.
VectorXd RandomTurning(int n, unsigned seed) {
  std::mt19937 random(seed);
  VectorXd x(n);
  for (double& turn : x) turn = static_cast<double>(random() % 1000) / 250 - 2;
  x.array() += (2 * kPi - x.sum()) / n;
  return x;
}

TurningProgram ProgramOf(const VectorXd& turning, double most_back) {
  TurningProgram program{turning, VectorXd::Ones(turning.size()), {}, {}, most_back};
  program.lower = VectorXd::Constant(turning.size(), -2.5);
  program.upper = VectorXd::Constant(turning.size(), 2.8);
  return program;
}

TEST(DeepestArc, IsTheDeepestOfAllArcs) {
  for (unsigned seed = 0; seed < 50; ++seed) {
    const VectorXd x = RandomTurning(13, seed);
    const TurningArc arc = DeepestArc(x);
    EXPECT_NEAR(arc.turning, FarthestBack(x), 1e-12);
    EXPECT_NEAR(ArcSum(x, arc.first, arc.count), arc.turning, 1e-12);
  }
}

TEST(LeastTurning, ACurveThatTurnsBackLittleStaysAsItIs) {
  VectorXd x = VectorXd::Constant(8, kPi / 4);
  x[2] -= 2, x[5] += 2;
  EXPECT_LT((*LeastTurning(ProgramOf(x, kPi)) - x).cwiseAbs().maxCoeff(), 1e-12);
}

// Three corners turn back by 4.5: they share what is too much, and so do the other six what they lose.
TEST(LeastTurning, CornersOfEqualWeightShareWhatIsTooMuch) {
  VectorXd x(9);
  x << -1.5, -1.5, -1.5, 0, 0, 0, 0, 0, 0;
  x.tail(6).array() += (2 * kPi + 4.5) / 6;
  const auto turned = LeastTurning(ProgramOf(x, 3));
  ASSERT_TRUE(turned.has_value());
  for (Index k = 0; k < 3; ++k) EXPECT_NEAR((*turned)[k], -1, 1e-6);
  for (Index k = 3; k < 9; ++k) EXPECT_NEAR((*turned)[k], (2 * kPi + 3) / 6, 1e-6);
}

TEST(LeastTurning, ACornerOfWeightZeroTurnsAsItDoes) {
  VectorXd x(9);
  x << -1.5, -1.5, -1.5, 0, 0, 0, 0, 0, 0;
  x.tail(6).array() += (2 * kPi + 4.5) / 6;
  TurningProgram program = ProgramOf(x, 3);
  program.weight[1] = 0;
  const auto turned = LeastTurning(program);
  ASSERT_TRUE(turned.has_value());
  EXPECT_EQ((*turned)[1], -1.5);
  EXPECT_NEAR((*turned)[0], -0.75, 1e-6);
}

TEST(LeastTurning, WithoutRoomThereIsNone) {
  VectorXd x(9);
  x << -1.5, -1.5, -1.5, 0, 0, 0, 0, 0, 0;
  x.tail(6).array() += (2 * kPi + 4.5) / 6;
  TurningProgram program = ProgramOf(x, 3);
  program.upper.head(3).setConstant(-1.2);
  EXPECT_FALSE(LeastTurning(program).has_value());
  program = ProgramOf(x, 3);
  program.weight.head(3).setZero();
  EXPECT_FALSE(LeastTurning(program).has_value());
}

/// The same minimiser by projecting onto every arc's half-space, the box and the sum in turn
/// (J. Boyle, R. Dykstra, 1986), in coordinates sqrt(weight) x.
VectorXd ByProjections(const TurningProgram& program) {
  const auto n = static_cast<Index>(program.turning.size());
  const VectorXd root = program.weight.cwiseSqrt();
  VectorXd z = root.cwiseProduct(program.turning);
  std::vector<VectorXd> memory(n * (n - 1) + 1, VectorXd::Zero(n));
  for (int sweep = 0; sweep < 20000; ++sweep) {
    std::size_t set = 0;
    for (Index first = 0; first < n; ++first) {
      for (Index count = 1; count < n; ++count, ++set) {
        VectorXd normal = VectorXd::Zero(n);
        for (Index i = 0; i < count; ++i) normal[(first + i) % n] = 1 / root[(first + i) % n];
        const VectorXd y = z + memory[set];
        const double short_of = std::max(0.0, -program.most_back - normal.dot(y));
        z = y + short_of / normal.squaredNorm() * normal;
        memory[set] = y - z;
      }
    }
    const VectorXd y = z + memory[set];
    z = y.cwiseMax(root.cwiseProduct(program.lower)).cwiseMin(root.cwiseProduct(program.upper));
    memory[set] = y - z;
    const VectorXd whole = root.cwiseInverse();
    z += (program.turning.sum() - whole.dot(z)) / whole.squaredNorm() * whole;
  }
  return z.cwiseQuotient(root);
}

TEST(LeastTurning, AgreesWithProjectionsOntoAllConstraints) {
  for (unsigned seed = 1; seed <= 4; ++seed) {
    TurningProgram program = ProgramOf(RandomTurning(7, seed), 0.4);
    for (Index k = 0; k < 7; ++k)
      program.weight[k] = 1 + 0.5 * ((k + static_cast<Index>(seed)) % 3);
    program.upper.setConstant(1.6);
    const auto turned = LeastTurning(program);
    ASSERT_TRUE(turned.has_value()) << seed;
    EXPECT_LT((*turned - ByProjections(program)).cwiseAbs().maxCoeff(), 1e-5) << seed;
    EXPECT_GE(FarthestBack(*turned), -program.most_back - 1e-6);
    EXPECT_NEAR(turned->sum(), 2 * kPi, 1e-6);
  }
}

}  // namespace
}  // namespace cirque
