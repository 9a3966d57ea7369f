#include "cirque/layout/planar_layout.h"

#include <cmath>

#include <gtest/gtest.h>

#include "cirque/layout/linear_layout.h"
#include "cirque/math/similarity.h"
#include "cirque/metrics/injectivity.h"

#include "tests/common/surfaces.h"

namespace cirque {
namespace {

TEST(PlanarLayout, FlatPatchComesBackUpToARigidMotion) {
  const Surface patch = GeneratedSurface("flat_delaunay_patch", 3000);
  const PlanarLayout layout =
      LayOutByDirections(patch.triangulation, AnglesOf(patch), MeasureEdgeLengths(patch));
  EXPECT_LT(layout.closure, 1e-10);
  std::vector<Eigen::Vector2d> expected;
  for (const Index v : patch.triangulation.vertex) expected.push_back(patch.position[v].head<2>());
  const SimilarityFit fit = FitSimilarity(layout.uv.value, expected);
  EXPECT_LT(fit.max_error, 1e-11);
  EXPECT_NEAR(std::abs(fit.similarity.factor), 1, 1e-11);
  EXPECT_TRUE(FlippedFaces(patch.triangulation, layout.uv).empty());
}

/// A patch without symmetry, sheared so that it is not Delaunay, its faces in the order given.
Surface Sheared() {
  return Moved(GeneratedSurface("flat_delaunay_patch", 500), [](const Eigen::Vector3d& p) {
    return Eigen::Vector3d(p.x() + 0.8 * p.y(), p.y() + 0.1 * p.x(), 0);
  });
}

TEST(PlanarLayout, GrowsWithTheLengthsAndKeepsOrientation) {
  const Surface patch = Sheared();
  const Triangulation& t = patch.triangulation;
  const EdgeLengths lengths = MeasureEdgeLengths(patch);
  const PlanarLayout layout = LayOutByDirections(t, AnglesOf(patch), lengths);
  for (const double scale : {0x1p-300, 8.0, 0x1p300}) {
    const PlanarLayout scaled =
        LayOutByDirections(t, AnglesOf(patch), {Eigen::VectorXd(scale * lengths.value)});
    EXPECT_EQ(scaled.closure, layout.closure);
    for (std::size_t h = 0; h < layout.uv.value.size(); ++h) {
      ASSERT_EQ(scaled.uv.value[h], scale * layout.uv.value[h]);
    }
  }
  // Every triangle has the sides and the orientation that it is given.
  for (Index h = 0; h < t.num_halfedges(); ++h) {
    const Eigen::Vector2d& a = layout.uv.value[Triangulation::Next(h)];
    const Eigen::Vector2d& b = layout.uv.value[Triangulation::Prev(h)];
    ASSERT_NEAR((b - a).norm(), lengths.value[t.edge[h]], 1e-12);
  }
  EXPECT_TRUE(FlippedFaces(t, layout.uv).empty());
}

/// The surface with its faces in reverse order, each from its second corner on.
Surface Renumbered(const Surface& surface) {
  PolygonSoup soup = TrianglesOf(surface);
  const std::vector<Index> corner = soup.corner;
  const auto count = static_cast<Index>(corner.size());
  for (Index c = 0; c < count; ++c) soup.corner[count - 3 - c / 3 * 3 + (c + 2) % 3] = corner[c];
  return SurfaceOf(soup);
}

TEST(PlanarLayout, NumberingTurnsTheLayoutAndNothingElse) {
  const Surface patch = Sheared(), other = Renumbered(patch);
  const auto count = static_cast<Index>(patch.triangulation.num_halfedges());
  const PlanarLayout a =
      LayOutByDirections(patch.triangulation, AnglesOf(patch), MeasureEdgeLengths(patch));
  const PlanarLayout b =
      LayOutByDirections(other.triangulation, AnglesOf(other), MeasureEdgeLengths(other));
  std::vector<Eigen::Vector2d> same_corner;
  for (Index c = 0; c < count; ++c) {
    same_corner.push_back(b.uv.value[count - 3 - c / 3 * 3 + (c + 2) % 3]);
  }
  const SimilarityFit motion = FitSimilarity(same_corner, a.uv.value);
  EXPECT_LT(motion.max_error, 1e-12);
  EXPECT_NEAR(std::abs(motion.similarity.factor), 1, 1e-12);
}

TEST(PlanarLayout, LeastSquaresAgreesWithDirectionsOnADisk) {
  const Surface patch = Sheared();
  const Triangulation& t = patch.triangulation;
  const EdgeLengths lengths = MeasureEdgeLengths(patch);
  const Cut none{std::vector<bool>(t.num_edges(), false)};
  const PlanarLayout by_directions = LayOutByDirections(t, AnglesOf(patch), lengths);
  const StatusOr<PlanarLayout> solved = LayOutByLeastSquares(t, AnglesOf(patch), lengths, none);
  ASSERT_TRUE(solved.ok()) << solved.status().message();
  const SimilarityFit motion = FitSimilarity(solved->uv.value, by_directions.uv.value);
  EXPECT_LT(motion.max_error, 1e-12);
  EXPECT_LT(std::abs(motion.similarity.factor - 1.0), 1e-12);  // the same frame: a translation
  EXPECT_LT(solved->closure, 1e-11);
}

TEST(OpenSurface, TargetVectorsAddUpToZeroAroundEveryFace) {
  const Surface patch = Sheared();
  const Triangulation& t = patch.triangulation;
  const Cut none{std::vector<bool>(t.num_edges(), false)};
  const OpenSurface open = OpenWithDirections(t, AnglesOf(patch), MeasureEdgeLengths(patch), none);
  EXPECT_EQ(open.TargetVector(0).y(), 0);  // the first halfedge points along the x axis
  EXPECT_GT(open.TargetVector(0).x(), 0);
  for (Index h = 0; h < t.num_halfedges(); ++h) {
    if (h % 3 == 0) {
      const Eigen::Vector2d sum =
          open.TargetVector(h) + open.TargetVector(h + 1) + open.TargetVector(h + 2);
      EXPECT_LT(sum.norm(), 1e-13);
    }
    if (t.twin[h] == kNone) continue;
    EXPECT_LT((open.TargetVector(h) + open.TargetVector(t.twin[h])).norm(), 1e-11);
  }
}

TEST(PlanarLayout, ClosureSeesAWrongAngle) {
  const Surface fan = Fan(6, 0.0);
  CornerAngles angles = AnglesOf(fan);
  angles.value[0] += 0.01;
  EXPECT_GT(LayOutByDirections(fan.triangulation, angles, MeasureEdgeLengths(fan)).closure, 1e-3);
}

}  // namespace
}  // namespace cirque
