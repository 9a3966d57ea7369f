#include "cirque/layout/half_plane.h"

#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "cirque/core/solve_summary.h"

#include "tests/common/surfaces.h"

namespace cirque {
namespace {

TEST(BalancingPoint, CentresBoundaryPointsAndHemispheres) {
  std::mt19937 random(3);
  std::normal_distribution<double> normal;
  WeightedPoints boundary, inner;
  for (int i = 0; i < 40; ++i) {
    boundary.point.emplace_back(normal(random) + 5);
    inner.point.emplace_back(Complex(3 * normal(random), std::exp(normal(random))));
    boundary.weight.push_back(std::exp(normal(random)));
    inner.weight.push_back(std::exp(normal(random)));
  }
  boundary.point.push_back(ExtendedComplex::Infinity());
  boundary.weight.push_back(1);
  for (const WeightedPoints& points : {boundary, inner}) {
    const Complex c = BalancingPoint(points, Complex(0, 1), {});
    const Moebius to_disk = Moebius::Cayley(c);
    std::vector<Complex> in_disk;
    for (const ExtendedComplex& z : points.point) in_disk.push_back(to_disk(z).value);
    EXPECT_LT(CentreOfMass(in_disk, points.weight), 1e-14);
  }
}

TEST(BalancingPoint, DominatedPointsHaveNone) {
  const WeightedPoints points = {{0.0, 1.0, 2.0}, {1, 1, 5}};
  EXPECT_EQ(BalancingPoint(points, Complex(1, 2), {}), Complex(1, 2));
}

TEST(FillAngles, SharesTheArcAsTheLength) {
  std::vector<double> angles = {0, kUnset, 1, kUnset, kUnset};
  FillAngles({0, 0.1, 0.4, 0.55, 0.7}, &angles);
  EXPECT_DOUBLE_EQ(angles[1], 0.25);
  EXPECT_DOUBLE_EQ(angles[3], 1 + (2 * kPi - 1) * 0.25);
  EXPECT_DOUBLE_EQ(angles[4], 1 + (2 * kPi - 1) * 0.5);
}

TEST(WeightedMedian, HasHalfOfTheWeightBelow) {
  EXPECT_EQ(WeightedMedian({{3, 1}, {1, 1}, {2, 1}}), 2);
  EXPECT_EQ(WeightedMedian({{3, 1}, {1, 9}, {2, 1}}), 1);
}

/// A strip of 6 x 3 unit squares, turned by 0.8, scaled by 5 and moved.
class MoveToHalfPlaneTest : public ::testing::Test {
 protected:
  MoveToHalfPlaneTest() {
    for (const Index v : t().vertex) {
      const Complex z(strip_.position[v].x(), strip_.position[v].y());
      const Complex moved = std::polar(5.0, 0.8) * z + Complex(-3, 11);
      layout_.value.emplace_back(moved.real(), moved.imag());
    }
    for (Index v = 0; v <= 6; ++v) bottom_.push_back(v);  // the surface on its left
  }

  const Triangulation& t() const { return strip_.triangulation; }

  const Surface strip_ = FlatStrip(6, 3);
  CornerUv layout_;
  std::vector<Index> bottom_;
};

TEST_F(MoveToHalfPlaneTest, TheChainRunsFromZeroToOneAndTheRestLiesAbove) {
  const HalfPlane half = MoveToHalfPlane(t(), layout_, bottom_);
  EXPECT_LT(half.straightness, 1e-15);
  EXPECT_TRUE(half.increasing);
  for (Index v = 0; v < t().num_vertices; ++v) {
    const Complex expected(strip_.position[v].x() / 6, strip_.position[v].y() / 6);
    EXPECT_LT(std::abs(half.position[v] - expected), 1e-14) << v;
    EXPECT_GE(half.position[v].imag(), 0);
  }
  for (const Index v : bottom_) EXPECT_EQ(half.position[v].imag(), 0);
}

TEST_F(MoveToHalfPlaneTest, ADentInTheChainIsMeasuredAndThenFlattened) {
  for (std::size_t c = 0; c < layout_.value.size(); ++c) {
    if (t().vertex[c] != 3) continue;  // the middle of the bottom, up by 0.3 of its length 30
    const Complex up = std::polar(9.0, 0.8 + kPi / 2);
    layout_.value[c] += Eigen::Vector2d(up.real(), up.imag());
  }
  const HalfPlane half = MoveToHalfPlane(t(), layout_, bottom_);
  EXPECT_NEAR(half.straightness, 0.3, 1e-14);
  EXPECT_EQ(half.position[3].imag(), 0);
  EXPECT_NEAR(half.position[3].real(), 0.5, 1e-14);
}

TEST_F(MoveToHalfPlaneTest, AChainThatTurnsBackIsNoIncreasingOne) {
  for (std::size_t c = 0; c < layout_.value.size(); ++c) {
    if (t().vertex[c] != 3) continue;  // beyond its neighbour 4
    const Complex along = std::polar(7.5, 0.8);
    layout_.value[c] += Eigen::Vector2d(along.real(), along.imag());
  }
  EXPECT_FALSE(MoveToHalfPlane(t(), layout_, bottom_).increasing);
}

}  // namespace
}  // namespace cirque
