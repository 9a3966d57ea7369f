#include "cirque/cones/curvature_peaks.h"

#include <algorithm>
#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cirque/core/metric.h"
#include "cirque/mesh/farthest_vertices.h"

#include "tests/common/surfaces.h"
#include "tests/mesh/meshes.h"

namespace cirque {
namespace {

std::vector<Index> ConesOf(const ConeTargets& targets) {
  std::vector<Index> cones;
  for (Index v = 0; v < static_cast<Index>(targets.lower.size()); ++v) {
    if (targets.lower[v] != 2 * kPi || targets.upper[v] != 2 * kPi) cones.push_back(v);
  }
  return cones;
}

void ExpectValid(const Triangulation& t, const ConeTargets& targets) {
  const GaussBonnetDefect defect = MeasureGaussBonnetDefect(t, targets);
  EXPECT_EQ(defect.lower, 0);
  EXPECT_EQ(defect.upper, 0);
  const std::vector<Index> corners = CornersPerVertex(t);
  for (const Index v : ConesOf(targets)) {
    EXPECT_GT(targets.lower[v], 0);
    EXPECT_LE(targets.lower[v], kPi * (corners[v] - 0.5));
  }
}

TEST(SimpleCones, ObeyGaussBonnetExactlyOnEveryGenus) {
  const std::pair<const char*, std::size_t> kTable[] = {
      {"sphere", 8}, {"blob", 8}, {"torus", 0}, {"double_torus", 8}};
  for (const auto& [name, cones] : kTable) {
    SCOPED_TRACE(name);
    const Surface surface = GeneratedSurface(name, 2000);
    const EdgeLengths lengths = MeasureEdgeLengths(surface);
    const StatusOr<ConeTargets> targets =
        SimpleConeTargets(MeasureSurface(surface.triangulation, lengths));
    ASSERT_TRUE(targets.ok()) << targets.status().message();
    EXPECT_EQ(ConesOf(*targets).size(), cones);
    ExpectValid(surface.triangulation, *targets);
    EXPECT_EQ(SimpleConeTargets(MeasureSurface(surface.triangulation, lengths))->lower,
              targets->lower);
  }
}

TEST(SimpleCones, LieApartAndWhereTheSurfaceIsCurvedTheirWay) {
  const Surface torus = GeneratedSurface("double_torus", 4000);
  const Triangulation& t = torus.triangulation;
  const ConeTargets targets = *SimpleConeTargets(MeasureSurface(t, MeasureEdgeLengths(torus)));
  const CornerAngles angles = AnglesOf(torus);
  std::vector<double> sum(t.num_vertices, 0);
  for (Index h = 0; h < t.num_halfedges(); ++h) sum[t.vertex[h]] += angles.value[h];
  const std::vector<Index> cones = ConesOf(targets);
  for (const Index v : cones) {
    EXPECT_GT(sum[v], 2 * kPi);
    for (const Index w : cones) {
      EXPECT_TRUE(v == w || (torus.position[v] - torus.position[w]).norm() > 0.3);
    }
  }
}

TEST(SimpleCones, SmallSurfacesGetFewerAndStrongerOnes) {
  const Surface tetrahedron = SurfaceOf(testing::Tetrahedron());
  const StatusOr<ConeTargets> targets =
      SimpleConeTargets(MeasureSurface(tetrahedron.triangulation, MeasureEdgeLengths(tetrahedron)));
  ASSERT_TRUE(targets.ok());
  EXPECT_EQ(targets->lower, std::vector<double>(4, kPi));
  ExpectValid(tetrahedron.triangulation, *targets);
}

TEST(SimpleCones, SurfacesWithABoundaryNeedNone) {
  const Surface ring = GeneratedSurface("annulus", 500);
  const ConeTargets plain = FreeBoundaryTargets(ring.triangulation);
  const StatusOr<ConeTargets> targets =
      SimpleConeTargets(MeasureSurface(ring.triangulation, MeasureEdgeLengths(ring)));
  EXPECT_EQ(targets->lower, plain.lower);
  EXPECT_EQ(targets->upper, plain.upper);
}

// The polygon with sides a b a' b' c d c' d' ..., four for each handle, joined, as a fan of its first
// corner: one vertex at all the corners.
Triangulation OneVertexSurface(Index genus) {
  const Index faces = 4 * genus - 2;
  std::vector<Index> twin(3 * faces, kNone), side(4 * genus);
  // Triangle i has corners 0, i + 1, i + 2; its side 0 is side i + 1 of the polygon.
  for (Index i = 0; i < faces; ++i) {
    side[i + 1] = 3 * i;
    if (i > 0) {
      twin[3 * i + 2] = 3 * (i - 1) + 1;
      twin[3 * (i - 1) + 1] = 3 * i + 2;
    }
  }
  side.front() = 2;
  side.back() = 3 * (faces - 1) + 1;
  for (Index i = 0; i < 4 * genus; ++i) twin[side[i]] = side[i % 4 < 2 ? i + 2 : i - 2];
  return NumberEdges(1, std::vector<Index>(3 * faces, 0), twin);
}

StatusOr<ConeTargets> SimpleTargetsOfEqualSides(const Triangulation& t) {
  const EdgeLengths lengths = {Eigen::VectorXd::Ones(t.num_edges())};
  return SimpleConeTargets(MeasureSurface(t, lengths));
}

TEST(SimpleCones, ASingleVertexOfGenusTwoIsOneLargeCone) {
  // 18 corners, which must carry the curvature -4 pi.
  const Triangulation t = OneVertexSurface(2);
  ASSERT_EQ(EulerCharacteristic(t), -2);
  const StatusOr<ConeTargets> targets = SimpleTargetsOfEqualSides(t);
  ASSERT_TRUE(targets.ok()) << targets.status().message();
  EXPECT_EQ(targets->lower[0], 6 * kPi);
  ExpectValid(t, *targets);
}

TEST(SimpleCones, SaysWhenThereAreTooFewVertices) {
  // Genus 3 on one vertex would need a cone of 10 pi, more than the simple ones.
  const Triangulation t = OneVertexSurface(3);
  ASSERT_EQ(EulerCharacteristic(t), -4);
  const StatusOr<ConeTargets> targets = SimpleTargetsOfEqualSides(t);
  ASSERT_FALSE(targets.ok());
  EXPECT_THAT(targets.status().message(), ::testing::HasSubstr("the curvature -8 pi"));
}

TEST(FarthestVertices, OfAHexagonalPyramid) {
  const Surface pyramid = Fan(6, 1);
  const std::vector<Index> all = {1, 0, 2, 3, 4, 5, 6};
  const std::vector<Index> chosen =
      FarthestVertices(pyramid.triangulation, MeasureEdgeLengths(pyramid), all, 7);
  EXPECT_EQ(chosen[0], 1);
  EXPECT_EQ(chosen[1], 4);  // sqrt(8) away over the apex
  EXPECT_EQ(chosen[2], 0);  // sqrt(2) away from both, the others 1 from one of them
  std::vector<Index> sorted = chosen;
  std::sort(sorted.begin(), sorted.end());
  EXPECT_EQ(sorted, (std::vector<Index>{0, 1, 2, 3, 4, 5, 6}));
}

TEST(SimpleCones, ExistOnTheClosedSharedMeshesSlow) {
  for (const std::string name : {"d-fertility-closed", "bff-kitten", "gpjs-double-torus",
                                 "cid-aircraft", "cgal-cheese", "gpjs-gargoyle"}) {
    SCOPED_TRACE(name);
    const auto mesh = ReadSharedSurface(name);
    if (!mesh) GTEST_SKIP() << name << " is not there";
    const Triangulation& t = mesh->surface.triangulation;
    const StatusOr<ConeTargets> targets =
        SimpleConeTargets(MeasureSurface(t, MeasureEdgeLengths(mesh->surface)));
    ASSERT_TRUE(targets.ok()) << targets.status().message();
    if (mesh->report.boundary_loops == 0) {
      ExpectValid(t, *targets);
      EXPECT_EQ(ConesOf(*targets).empty(), mesh->report.genus == 1);
    }
  }
}

}  // namespace
}  // namespace cirque
