#include "cirque/mesh/visibility.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "cirque/mesh/surface.h"

#include "tests/common/surfaces.h"
#include "tests/mesh/meshes.h"

namespace cirque {
namespace {

using Point = Eigen::Vector3d;

/// The angle between the outer normals of the two triangles of an edge [rad].
double Bend(const Surface& surface, Index e) {
  const Triangulation& t = surface.triangulation;
  const auto normal = [&](Index f) -> Point {
    const auto at = [&](Index k) { return surface.position[t.vertex[3 * f + k]]; };
    return (at(1) - at(0)).cross(at(2) - at(0)).normalized();
  };
  const Index h = t.edge_halfedge[e];
  const Point a = normal(Triangulation::Face(h)), b = normal(Triangulation::Face(t.twin[h]));
  return std::atan2(a.cross(b).norm(), a.dot(b));
}

/// The prism over a polygon, counter-clockwise.
PolygonSoup PrismOver(const std::vector<Eigen::Vector2d>& outline, double depth) {
  const auto n = static_cast<Index>(outline.size());
  std::vector<Point> points;
  for (const double z : {0., depth}) {
    for (const Eigen::Vector2d& p : outline) points.emplace_back(p.x(), p.y(), z);
  }
  std::vector<std::vector<Index>> faces(2);
  for (Index i = 0; i < n; ++i) {
    faces[0].push_back(n - 1 - i);
    faces[1].push_back(n + i);
    const Index j = (i + 1) % n;
    faces.push_back({i, j, n + j, n + i});
  }
  return testing::MakeSoup(points, faces);
}

/// The edge between two points.
Index EdgeAt(const Surface& surface, const Point& a, const Point& b) {
  const Triangulation& t = surface.triangulation;
  for (Index e = 0; e < t.num_edges(); ++e) {
    const Index h = t.edge_halfedge[e];
    const Point &tail = surface.position[t.Tail(h)], &tip = surface.position[t.Tip(h)];
    if ((tail == a && tip == b) || (tail == b && tip == a)) return e;
  }
  return kNone;
}

TEST(SpreadDirections, AreOfUnitLengthAndBalanced) {
  const std::vector<Point> directions = SpreadDirections(200);
  ASSERT_EQ(directions.size(), 200u);
  Point sum = Point::Zero();
  Eigen::Matrix3d moments = Eigen::Matrix3d::Zero();
  for (const Point& d : directions) {
    EXPECT_NEAR(d.norm(), 1, 1e-14);
    sum += d;
    moments += d * d.transpose();
  }
  EXPECT_LT(sum.norm() / 200, 1e-2);
  EXPECT_LT((moments / 200 - Eigen::Matrix3d::Identity() / 3).norm(), 1e-2);
}

// A convex body hides nothing but by turning away: an edge is seen from the directions of two half
// spheres, which are (pi + bend) / (2 pi) of all.
TEST(Visibility, OfAConvexEdgeIsThatOfTwoHalfSpheres) {
  for (const int faces : {4, 8, 20}) {
    const Surface body = RegularPolyhedron(faces);
    const Visibility visibility(body.triangulation, body.position, 4000);
    for (Index e = 0; e < body.triangulation.num_edges(); ++e) {
      EXPECT_NEAR(visibility.Of(e), (kPi + Bend(body, e)) / (2 * kPi), 0.01) << faces;
    }
  }
}

TEST(Visibility, OfAConcaveEdgeIsThatOfTheWedge) {
  // The inner edge of an L, and its outermost, which nothing else hides.
  const Surface body = SurfaceOf(PrismOver({{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}}, 1));
  const Visibility visibility(body.triangulation, body.position, 4000);
  const Index inner = EdgeAt(body, {1, 1, 0}, {1, 1, 1});
  ASSERT_NE(inner, kNone);
  EXPECT_NEAR(visibility.Of(inner), 0.25, 0.01);
  const Index outer = EdgeAt(body, {2, 0, 0}, {2, 0, 1});
  EXPECT_NEAR(visibility.Of(outer), 0.75, 0.01);
}

// In a trench 1 wide and 1 deep the middle of an edge at the bottom sees out, along the trench far
// longer than that, between its own wall and the line to the opposite rim: an eighth of the sphere.
TEST(Visibility, WallsHide) {
  constexpr double kDepth = 2000;
  const Surface body = SurfaceOf(
      PrismOver({{0, 0}, {3, 0}, {3, 2}, {2, 2}, {2, 1}, {1, 1}, {1, 2}, {0, 2}}, kDepth));
  const Visibility visibility(body.triangulation, body.position, 4000);
  const Index bottom = EdgeAt(body, {1, 1, 0}, {1, 1, kDepth});
  ASSERT_NE(bottom, kNone);
  EXPECT_NEAR(visibility.Of(bottom), 0.125, 0.01);
}

TEST(Visibility, InsideOutAndScaleMakeNoDifference) {
  const Surface blob = GeneratedSurface("blob", 300);
  PolygonSoup soup = TrianglesOf(blob);
  for (std::size_t c = 0; c < soup.corner.size(); c += 3)
    std::swap(soup.corner[c], soup.corner[c + 1]);
  const Surface turned = SurfaceOf(soup);
  const Surface large = Moved(blob, [](const Point& x) -> Point { return 1024 * x; });
  const Visibility of_blob(blob.triangulation, blob.position, 50);
  const Visibility of_turned(turned.triangulation, turned.position, 50);
  const Visibility of_large(large.triangulation, large.position, 50);
  double sum = 0;
  for (Index e = 0; e < blob.triangulation.num_edges(); ++e) {
    const Index h = blob.triangulation.edge_halfedge[e];
    const Index there = EdgeAt(turned, blob.position[blob.triangulation.Tail(h)],
                               blob.position[blob.triangulation.Tip(h)]);
    EXPECT_EQ(of_blob.Of(e), of_turned.Of(there));
    EXPECT_EQ(of_blob.Of(e), of_large.Of(e));
    sum += of_blob.Of(e);
  }
  EXPECT_GT(sum / blob.triangulation.num_edges(), 0.4);  // a blob hides little of itself
}

TEST(Visibility, TheBackOfASheetIsNotSeen) {
  const Surface sheet = FlatStrip(4, 2);
  const Visibility visibility(sheet.triangulation, sheet.position, 1000);
  for (Index e = 0; e < sheet.triangulation.num_edges(); ++e) {
    EXPECT_NEAR(visibility.Of(e), 0.5, 2e-3);
  }
}

}  // namespace
}  // namespace cirque
