#include "cirque/verify/correspondence.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <random>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/verify/fixtures.h"

namespace cirque::verify {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

/// The triangles of `mesh` in the order of `order`, each turned by as many corners as its number.
FanMesh Shuffled(const FanMesh& mesh, const std::vector<Index>& order) {
  FanMesh result;
  result.num_vertices = mesh.num_vertices;
  for (const Index f : order) {
    for (Index k = 0; k < 3; ++k) {
      const Index h = 3 * f + (k + f) % 3;
      result.vertex.push_back(mesh.vertex[h]);
      result.soup_corner.push_back(mesh.soup_corner[h]);
    }
  }
  return result;
}

TEST(MatchTriangles, FindsEveryTriangleInWhateverOrder) {
  const FanMesh in = *FanTriangulate(Sheet(4));
  std::vector<Index> order(in.num_triangles());
  std::iota(order.begin(), order.end(), 0);
  EXPECT_TRUE(MatchTriangles(in, Shuffled(in, order)).same_order);
  std::mt19937 random(5);
  std::shuffle(order.begin(), order.end(), random);
  const FanMesh out = Shuffled(in, order);
  const Correspondence match = MatchTriangles(in, out);
  EXPECT_TRUE(match.complete());
  EXPECT_FALSE(match.same_order);
  EXPECT_THAT(match.reversed, IsEmpty());
  for (Index i = 0; i < out.num_triangles(); ++i) EXPECT_EQ(match.out_triangle[order[i]], i);
  // In IN's order again every triangle has IN's vertices, from whichever corner on.
  const FanMesh back = Reorder(out, match);
  for (Index f = 0; f < in.num_triangles(); ++f) {
    const auto corner = back.vertex.begin() + 3 * f;
    EXPECT_THAT(std::vector<Index>(corner, corner + 3),
                testing::UnorderedElementsAre(in.vertex[3 * f], in.vertex[3 * f + 1],
                                              in.vertex[3 * f + 2]));
  }
}

TEST(MatchTriangles, WhatIsMissingExtraAndReversedIsNamed) {
  const FanMesh in = *FanTriangulate(Sheet(2));
  FanMesh out = in;
  std::swap(out.vertex[3 * 5], out.vertex[3 * 5 + 1]);
  EXPECT_THAT(MatchTriangles(in, out).reversed, ElementsAre(5));
  EXPECT_TRUE(MatchTriangles(in, out).complete());
  out.vertex[3 * 2] = 8;
  const Correspondence match = MatchTriangles(in, out);
  EXPECT_THAT(match.missing, ElementsAre(2));
  EXPECT_THAT(match.extra, ElementsAre(2));
  EXPECT_FALSE(match.complete());
  EXPECT_EQ(match.out_triangle[2], kNone);
}

// Two copies of one triangle stand for one of IN: the second is too many.
TEST(MatchTriangles, ATriangleListedTwiceIsExtra) {
  const FanMesh in = *FanTriangulate(Sheet(2));
  FanMesh out = in;
  out.vertex.insert(out.vertex.end(), in.vertex.begin(), in.vertex.begin() + 3);
  out.soup_corner.insert(out.soup_corner.end(), in.soup_corner.begin(), in.soup_corner.begin() + 3);
  const Correspondence match = MatchTriangles(in, out);
  EXPECT_THAT(match.missing, IsEmpty());
  EXPECT_EQ(match.extra.size(), 1u);
}

TEST(ComparePositions, IsRelativeToTheBoundingBoxWhateverItsSize) {
  for (const double scale : {1e-100, 1.0, 1e100}) {
    std::vector<Eigen::Vector3d> in = {{0, 0, 0}, {3, 0, 0}, {0, 4, 0}};
    for (Eigen::Vector3d& p : in) p *= scale;
    std::vector<Eigen::Vector3d> out = in;
    out[1].z() += 0.05 * scale;  // of the diagonal 5
    EXPECT_NEAR(ComparePositions(in, out, 0.02).largest, 0.01, 1e-12) << scale;
    EXPECT_THAT(ComparePositions(in, out, 0.02).moved, IsEmpty()) << scale;
    EXPECT_THAT(ComparePositions(in, out, 0.005).moved, ElementsAre(1)) << scale;
  }
}

TEST(ComparePositions, APointThatIsNotFiniteHasMoved) {
  const std::vector<Eigen::Vector3d> in = {{0, 0, 0}, {1, 0, 0}};
  for (const double bad : {std::numeric_limits<double>::quiet_NaN(), HUGE_VAL}) {
    std::vector<Eigen::Vector3d> out = in;
    out[0].y() = bad;
    EXPECT_THAT(ComparePositions(in, out, 1e9).moved, ElementsAre(0));
  }
}

}  // namespace
}  // namespace cirque::verify
