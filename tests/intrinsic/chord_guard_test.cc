#include <algorithm>

#include <gtest/gtest.h>

#include "cirque/angles/angle_fit.h"
#include "cirque/angles/registry.h"
#include "cirque/intrinsic/intrinsic_delaunay.h"
#include "cirque/intrinsic/intrinsic_surface.h"

#include "tests/common/surfaces.h"
#include "tests/mesh/scrambled.h"

namespace cirque {
namespace {

using testing::IntrinsicMesh;

IntrinsicTriangulation Delaunay(const IntrinsicMesh& mesh,
                                const IntrinsicDelaunayOptions& options = {}) {
  return MakeIntrinsicDelaunay(mesh.triangulation, mesh.lengths, options);
}

Index CountEdges(const Triangulation& t, Index u, Index w) {
  return static_cast<Index>(std::count_if(
      t.edge_halfedge.begin(), t.edge_halfedge.end(),
      [&](Index h) { return std::minmax(t.Tail(h), t.Tip(h)) == std::minmax(u, w); }));
}

IntrinsicMesh InPlane(const std::vector<Eigen::Vector2d>& points,
                      const std::vector<Index>& corners) {
  PolygonSoup soup;
  for (const Eigen::Vector2d& p : points) soup.position.emplace_back(p.x(), p.y(), 0);
  soup.corner = corners;
  for (std::size_t f = 0; f < corners.size() / 3; ++f) {
    soup.first_corner.push_back(static_cast<Index>(3 * f + 3));
  }
  const Surface surface = SurfaceOf(soup);
  return {surface.triangulation, MeasureEdgeLengths(surface)};
}

TEST(ChordGuard, CutsNoRoomlessPieceOffAStraightBoundary) {
  // Vertex 6 sees an arc of five boundary vertices and, far away, vertex 5: the Delaunay flip joins
  // the ends 0 and 4 of the arc. As a triangle 0, 4, 5 with straight sides it has no such edge.
  const IntrinsicMesh mesh =
      InPlane({{-1, 0}, {-0.8, -0.6}, {0, -1}, {0.8, -0.6}, {1, 0}, {0, 4}, {0, -0.3}},
              {0, 1, 6, 1, 2, 6, 2, 3, 6, 3, 4, 6, 4, 5, 6, 5, 0, 6});
  ConeTargets targets = FreeBoundaryTargets(mesh.triangulation);
  for (const Index v : {0, 4, 5}) targets.lower[v] = targets.upper[v] = kPi / 3;
  for (const Index v : {1, 2, 3}) targets.lower[v] = targets.upper[v] = kPi;
  const IntrinsicTriangulation free = Delaunay(mesh);
  EXPECT_EQ(free.flips.size(), 1);
  EXPECT_EQ(CountEdges(free.triangulation, 0, 4), 1);
  EXPECT_TRUE(Delaunay(mesh, {&targets, {}}).flips.empty());

  const auto fit = [&](const IntrinsicTriangulation& on) {
    AngleFitResult result;
    const AngleConstraints constraints(on.triangulation, targets);
    const CornerAngles reference = MeasureCornerAngles(on.triangulation, on.lengths);
    return FitAngles({constraints, reference.value, 1e-3}, *AngleObjectives().Find("quadratic"),
                     **MakeAngleSolver("auto"), {}, &result)
        .code();
  };
  EXPECT_EQ(fit(free), StatusCode::kInfeasible);
  EXPECT_EQ(fit(Delaunay(mesh, {&targets, {}})), StatusCode::kOk);
}

TEST(ChordGuard, MakesNoSecondEdgeAlongTheBoundary) {
  const ConeTargets free = FreeBoundaryTargets(Fan(6, 0).triangulation);
  const ChordGuard guard(Fan(6, 0).triangulation, free);
  EXPECT_TRUE(guard.Allows(0, 1));  // a spoke
  EXPECT_TRUE(guard.Allows(1, 3));
  EXPECT_TRUE(guard.Allows(1, 4));
  EXPECT_FALSE(guard.Allows(1, 2));
  EXPECT_FALSE(guard.Allows(6, 1));
  EXPECT_FALSE(guard.Allows(2, 2));
  ConeTargets cone = free;
  cone.lower[0] = cone.upper[0] = kPi / 2;
  EXPECT_TRUE(ChordGuard(Fan(6, 0).triangulation, cone).Allows(1, 2));
  EXPECT_TRUE(ChordGuard(Fan(6, 0).triangulation, cone).Allows(2, 2));
  cone.lower[0] = 1.5 * kPi;
  EXPECT_FALSE(ChordGuard(Fan(6, 0).triangulation, cone).Allows(2, 2));
  const Triangulation closed = GeneratedSurface("torus", 200).triangulation;
  EXPECT_TRUE(ChordGuard(closed, FreeBoundaryTargets(closed)).Allows(2, 2));
}

TEST(ChordGuard, LeavesThreeCornersWhereAJaggedBoundaryIsToBeStraight) {
  for (const double drop : {0.0, 0.6}) {  // of vertex 2: the boundary bends by atan(drop)
    const IntrinsicMesh mesh = InPlane({{0, 0}, {-1, 0}, {1, -drop}, {-0.5, 2}, {0.2, 0.5}},
                                       {1, 0, 3, 0, 4, 3, 0, 2, 4, 2, 3, 4});
    ConeTargets targets = FreeBoundaryTargets(mesh.triangulation);
    EXPECT_EQ(CornersPerVertex(Delaunay(mesh).triangulation)[0], 2);
    targets.lower[0] = targets.upper[0] = kPi;
    const Triangulation straight = Delaunay(mesh, {&targets, {}}).triangulation;
    EXPECT_EQ(CornersPerVertex(straight)[0], drop > 0 ? 3 : 2);
  }
}

}  // namespace
}  // namespace cirque
