#include "cirque/layout/disk_positions.h"

#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "cirque/core/metric.h"
#include "cirque/core/solve_summary.h"
#include "cirque/layout/convex_embedding.h"
#include "cirque/metrics/injectivity.h"

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

TEST(EmbedConvexly, ReproducesLinearFunctionsAndNeverFlips) {
  const Surface surface = GeneratedSurface("flat_delaunay_patch", 300);
  const Triangulation& t = surface.triangulation;
  const std::vector<bool> fixed = BoundaryVertices(t);
  const Eigen::VectorXd weights = PositiveCotangents(t, AnglesOf(surface));
  std::vector<Eigen::Vector2d> position;
  for (const Eigen::Vector3d& p : surface.position) position.emplace_back(p.x(), p.y());
  std::vector<Eigen::Vector2d> embedded = position;
  for (Index v = 0; v < t.num_vertices; ++v) {
    if (!fixed[v]) embedded[v].setZero();
  }
  ASSERT_TRUE(EmbedConvexly(t, weights, fixed, &embedded).ok());
  // Cotangent weights reproduce linear functions; few of this Delaunay mesh's are raised.
  double largest = 0;
  for (Index v = 0; v < t.num_vertices; ++v) {
    largest = std::max(largest, (embedded[v] - position[v]).norm());
  }
  EXPECT_LT(largest, 2e-2);
  // A boundary squeezed very unevenly onto a circle.
  const std::vector<Index> loop = BoundaryLoops(t).front();
  for (std::size_t k = 0; k < loop.size(); ++k) {
    const double share = static_cast<double>(k) / static_cast<double>(loop.size());
    const double angle = 2 * kPi * share * share;
    embedded[t.Tail(loop[k])] = {std::cos(angle), std::sin(angle)};
  }
  ASSERT_TRUE(EmbedConvexly(t, weights, fixed, &embedded).ok());
  CornerUv uv;
  for (const Index v : t.vertex) uv.value.push_back(embedded[v]);
  EXPECT_TRUE(FlippedFaces(t, uv).empty());
}

}  // namespace
}  // namespace cirque
