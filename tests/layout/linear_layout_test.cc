#include "cirque/layout/linear_layout.h"

#include <cmath>

#include <gtest/gtest.h>

#include "cirque/metrics/injectivity.h"

#include "tests/common/surfaces.h"

namespace cirque {
namespace {

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
