#include "cirque/layout/untangle.h"

#include <algorithm>
#include <cmath>
#include <complex>

#include <gtest/gtest.h>

#include "cirque/core/triangulation.h"
#include "cirque/intrinsic/intrinsic_surface.h"
#include "cirque/layout/map_objective.h"
#include "cirque/layout/planar_layout.h"
#include "cirque/metrics/injectivity.h"

#include "tests/common/surfaces.h"

namespace cirque {
namespace {

/// The flat metric of a plane surface's faces, flipped ones with negative angles.
InputChart FlatOf(const Surface& plane) {
  const Triangulation& t = plane.triangulation;
  InputChart flat{{Eigen::VectorXd(t.num_halfedges())}, MeasureEdgeLengths(plane), {}};
  const auto at = [&](Index corner) {
    const Eigen::Vector3d& x = plane.position[t.vertex[corner]];
    return std::complex<double>(x.x(), x.y());
  };
  for (Index c = 0; c < t.num_halfedges(); ++c) {
    const auto a = at(Triangulation::Next(c)) - at(c), b = at(Triangulation::Prev(c)) - at(c);
    flat.angles.value[c] = std::arg(std::conj(a) * b);
    if (c % 3 == 2 && flat.angles.value[c] < 0) flat.flipped.push_back(c / 3);
  }
  return flat;
}

constexpr int kColumns = 6, kRows = 6;

Index Vertex(int column, int row) { return row * (kColumns + 1) + column; }

class UntangleFlippedTrianglesTest : public ::testing::Test {
 protected:
  UntangleFlippedTrianglesTest() {
    for (Index v = 0; v < t().num_vertices; ++v) movable_[v] = !movable_[v];
  }

  const Triangulation& t() const { return strip_.triangulation; }

  int Untangle(InputChart* flat) const {
    return UntangleFlippedTriangles(MeasureSurface(t(), MeasureEdgeLengths(strip_)), movable_,
                                    flat);
  }

  /// The strip's metric with vertices moved.
  InputChart Displaced(const std::vector<std::pair<Index, Eigen::Vector3d>>& moves) const {
    Surface moved = strip_;
    for (const auto& [v, by] : moves) moved.position[v] += by;
    return FlatOf(moved);
  }

  const Surface strip_ = FlatStrip(kColumns, kRows);
  std::vector<bool> movable_ = BoundaryVertices(strip_.triangulation);
};

TEST_F(UntangleFlippedTrianglesTest, AVertexGoesBackToWhereNothingIsDistorted) {
  const InputChart whole = FlatOf(strip_);
  ASSERT_TRUE(whole.flipped.empty());
  InputChart flat = Displaced({{Vertex(3, 3), {1.3, 0.2, 0}}});
  ASSERT_GE(flat.flipped.size(), 1);
  EXPECT_EQ(Untangle(&flat), 1);
  EXPECT_TRUE(flat.flipped.empty());
  EXPECT_LT((flat.lengths.value - whole.lengths.value).cwiseAbs().maxCoeff(), 1e-6);
  EXPECT_LT((flat.angles.value - whole.angles.value).cwiseAbs().maxCoeff(), 1e-6);
}

TEST_F(UntangleFlippedTrianglesTest, SeveralMovesKeepEveryAngleSumAndLayOutWithoutFlips) {
  InputChart flat = Displaced({{Vertex(2, 2), {0.2, 1.2, 0}},
                               {Vertex(4, 4), {1.4, -0.1, 0}},
                               {Vertex(2, 5), {-0.3, -0.4, 0}}});
  const std::vector<double> before = VertexAngleSums(t(), flat.angles);
  ASSERT_GE(flat.flipped.size(), 2);
  EXPECT_GE(Untangle(&flat), 2);
  EXPECT_TRUE(flat.flipped.empty());
  EXPECT_GT(flat.angles.value.minCoeff(), 0.05);
  const std::vector<double> after = VertexAngleSums(t(), flat.angles);
  for (Index v = 0; v < t().num_vertices; ++v) {
    EXPECT_NEAR(std::remainder(after[v] - before[v], 2 * kPi), 0, 1e-12);
    if (movable_[v]) {
      EXPECT_NEAR(after[v], 2 * kPi, 1e-12);
    }
  }
  const Cut none{std::vector<bool>(t().num_edges(), false)};
  EXPECT_TRUE(FlippedFaces(t(), LayOutPatches(t(), flat.angles, flat.lengths, none).uv).empty());
}

TEST_F(UntangleFlippedTrianglesTest, WhatMayNotMoveStaysAndIsNamed) {
  movable_.assign(movable_.size(), false);
  InputChart flat = Displaced({{Vertex(3, 3), {1.3, 0.2, 0}}});
  const InputChart before = flat;
  EXPECT_EQ(Untangle(&flat), 0);
  EXPECT_EQ(flat.flipped, before.flipped);
  EXPECT_EQ(flat.lengths.value, before.lengths.value);
}

TEST_F(UntangleFlippedTrianglesTest, AStarWithoutAKernelIsLeftAlone) {
  // Two of the boundary's vertices swap positions: no inner vertex sees both sides between them.
  InputChart flat = Displaced({{Vertex(2, 0), {2, 0, 0}}, {Vertex(4, 0), {-2, 0, 0}}});
  ASSERT_FALSE(flat.flipped.empty());
  Untangle(&flat);
  EXPECT_FALSE(flat.flipped.empty());
  for (const Index f : flat.flipped) EXPECT_LT(flat.angles.value.segment<3>(3 * f).minCoeff(), 0);
}

TEST_F(UntangleFlippedTrianglesTest, AKernelIsFoundHoweverSmallAndOneThatDoublesDoNotHoldIsNone) {
  const InputChart moved = Displaced({{Vertex(3, 3), {1.3, 0.2, 0}}});
  const MapObjective mips = *MapObjectives().Find("mips");
  const EdgeLengths lengths = MeasureEdgeLengths(strip_);
  const IntrinsicSurface surface = MeasureSurface(t(), lengths);
  const auto corner = std::find(t().vertex.begin(), t().vertex.end(), Vertex(3, 3));
  const auto best = [&](const InputChart& flat) {
    return DevelopedStar(t(), surface.angles, surface.lengths, flat,
                         static_cast<Index>(corner - t().vertex.begin()))
        .BestPosition(mips);
  };
  // Where it was before it was moved, seen from where it is and turned with one of its edges.
  ASSERT_TRUE(best(moved).has_value());
  EXPECT_NEAR(std::abs(*best(moved)), std::hypot(1.3, 0.2), 1e-6);
  for (const double scale : {1e-100, 1e100}) {
    InputChart scaled = moved;
    scaled.lengths.value *= scale;
    ASSERT_TRUE(best(scaled).has_value()) << scale;
    EXPECT_NEAR(std::abs(*best(scaled)), scale * std::hypot(1.3, 0.2), 1e-6 * scale);
  }
  InputChart collapsed = moved;
  collapsed.lengths.value.setZero();
  EXPECT_FALSE(best(collapsed).has_value());
}

}  // namespace
}  // namespace cirque
