#include "cirque/domains/sphere_refinement.h"

#include <atomic>
#include <optional>
#include <set>
#include <vector>

#include <gtest/gtest.h>

#include "cirque/metrics/injectivity.h"

#include "tests/common/surfaces.h"

namespace cirque {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

/// The inverse of SphereChart's projection with the chart it is made with, for points of the unit
/// sphere.
PlaneWithPole Project(const std::vector<Vector3d>& points, Index pole) {
  PlaneWithPole plane{pole, {}};
  for (const Vector3d& x : points) plane.position.push_back(x.head<2>() / (1 + x.z()));
  plane.position[pole] = Vector2d::Zero();
  return plane;
}

class SphereRefinementTest : public ::testing::Test {
 protected:
  /// The vertex at infinity of the generated sphere.
  Index Pole() const {
    Index pole = 0;
    for (Index v = 0; v < t_.num_vertices; ++v) {
      if (sphere_.position[v].z() < sphere_.position[pole].z()) pole = v;
    }
    return pole;
  }

  /// The vertex nearest to a point.
  Index Nearest(const Vector3d& x) const {
    Index nearest = 0;
    for (Index v = 0; v < t_.num_vertices; ++v) {
      if ((sphere_.position[v] - x).norm() < (sphere_.position[nearest] - x).norm()) nearest = v;
    }
    return nearest;
  }

  /// Moves a vertex most of the way to one of its neighbours, which makes bad triangles of those
  /// beside the edge and flips none.
  void Spoil(Index v, PlaneWithPole* plane) const {
    for (Index h = 0; h < t_.num_halfedges(); ++h) {
      if (t_.Tail(h) != v || t_.Tip(h) == plane->pole) continue;
      Vector2d& x = plane->position[v];
      x += 0.9 * (plane->position[t_.Tip(h)] - x);
      return;
    }
  }

  const Surface sphere_ = GeneratedSurface("sphere", 800);
  const Triangulation& t_ = sphere_.triangulation;
  const EdgeLengths lengths_ = MeasureEdgeLengths(sphere_);
};

TEST_F(SphereRefinementTest, PutsBackWhatIsFlippedAndNothingElse) {
  const PlaneWithPole before = Project(sphere_.position, Pole());
  const Index fine = Nearest({0.3, 0.1, 0.9}), flips = Nearest({0, -0.6, -0.8});
  PlaneWithPole plane = before;
  Spoil(fine, &plane);
  const Vector2d moved = plane.position[fine];
  EXPECT_TRUE(PutBackFlipped(t_, {}, before, &plane));
  EXPECT_EQ(plane.position[fine], moved);  // nothing is flipped
  plane.position[flips] = plane.position[Nearest({0, 0.6, 0.8})];
  ASSERT_FALSE(FlippedSphericalFaces(t_, LiftAll(plane, {})).empty());
  EXPECT_TRUE(PutBackFlipped(t_, {}, before, &plane));
  EXPECT_TRUE(FlippedSphericalFaces(t_, LiftAll(plane, {})).empty());
  EXPECT_EQ(plane.position[flips], before.position[flips]);
  EXPECT_EQ(plane.position[fine], moved);  // far from there
  // Where the map before flips triangles, no ring helps.
  PlaneWithPole bad = before;
  bad.position[flips] = bad.position[fine];
  plane = bad;
  EXPECT_FALSE(PutBackFlipped(t_, {}, bad, &plane));
}

TEST_F(SphereRefinementTest, BringsBackVerticesOfBothHemispheres) {
  const Index pole = Pole();
  ASSERT_NEAR(sphere_.position[pole].z(), -1, 1e-15);
  const PlaneWithPole exact = Project(sphere_.position, pole);
  const std::set<Index> spoiled = {Nearest({0.3, 0.1, 0.9}), Nearest({0, -0.6, -0.8})};
  PlaneWithPole plane = exact;
  for (const Index v : spoiled) Spoil(v, &plane);
  const PlaneWithPole before = plane;
  ASSERT_TRUE(FlippedSphericalFaces(t_, LiftAll(before, {})).empty());
  std::optional<MapRefinementSummary> summary;
  ASSERT_TRUE(RefineOnSphere(t_, lengths_, {}, "auto:once=1", nullptr, &plane, &summary).ok());
  ASSERT_TRUE(summary);
  EXPECT_GT(summary->map_refinement_before, 1e-3);
  EXPECT_LT(summary->map_refinement_after, 1e-2 * summary->map_refinement_before);
  EXPECT_GE(*summary->map_refinement_patches, 2);
  EXPECT_TRUE(FlippedSphericalFaces(t_, LiftAll(plane, {})).empty());
  int moved = 0;
  for (Index v = 0; v < t_.num_vertices; ++v) {
    if (v == pole) continue;
    const double scale = 1 + exact.position[v].squaredNorm();
    EXPECT_LT((plane.position[v] - exact.position[v]).norm(), 0.05 * scale);
    moved += (plane.position[v] - before.position[v]).norm() > 1e-12 * scale ? 1 : 0;
  }
  EXPECT_GE(moved, 2);
  EXPECT_LT(moved, t_.num_vertices / 4);
}

TEST_F(SphereRefinementTest, LeavesAGoodMapAsItIs) {
  PlaneWithPole plane = Project(sphere_.position, Pole());
  const PlaneWithPole before = plane;
  std::optional<MapRefinementSummary> summary;
  ASSERT_TRUE(RefineOnSphere(t_, lengths_, {}, "auto", nullptr, &plane, &summary).ok());
  EXPECT_LT(summary->map_refinement_before, 1e-20);
  for (Index v = 0; v < t_.num_vertices; ++v) EXPECT_EQ(plane.position[v], before.position[v]);
}

TEST_F(SphereRefinementTest, CanBeInterrupted) {
  PlaneWithPole plane = Project(sphere_.position, Pole());
  const std::atomic<bool> cancelled = true;
  std::optional<MapRefinementSummary> summary;
  EXPECT_EQ(RefineOnSphere(t_, lengths_, {}, "auto", &cancelled, &plane, &summary).code(),
            StatusCode::kCancelled);
}

}  // namespace
}  // namespace cirque
