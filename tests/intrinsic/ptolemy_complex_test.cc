// Ptolemy flips: a change of coordinates, found on circles and undone by themselves.
#include "cirque/intrinsic/ptolemy_complex.h"

#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "cirque/intrinsic/intrinsic_delaunay.h"

#include "tests/common/surfaces.h"

namespace cirque {
namespace {

Eigen::VectorXd LogLengths(const Surface& surface) {
  return MeasureEdgeLengths(surface).value.array().log();
}

Eigen::VectorXd RandomScale(Index n, double size) {
  std::mt19937 random(5);
  Eigen::VectorXd u(n);
  for (double& x : u) x = size * (std::ldexp(static_cast<double>(random()), -31) - 1);
  return u;
}

/// A convex quadrilateral of points on the unit circle.
Surface OnACircle() {
  std::vector<Eigen::Vector3d> points;
  for (const double angle : {0.1, 1.0, 2.9, 4.4}) {
    points.emplace_back(std::cos(angle), std::sin(angle), 0);
  }
  return *SurfaceFromTriangles(points, {{0, 1, 2}, {0, 2, 3}});
}

/// The halfedge of the only inner edge.
Index InnerEdge(const Triangulation& t) {
  for (const Index h : t.edge_halfedge) {
    if (t.twin[h] != kNone) return h;
  }
  return kNone;
}

TEST(PtolemyComplex, OnACircleTheOtherDiagonalIsThatOfTheQuadrilateral) {
  const Surface quad = OnACircle();
  PtolemyComplex complex(quad.triangulation, LogLengths(quad));
  complex.Flip(InnerEdge(quad.triangulation));
  const Triangulation flipped = complex.MakeTriangulation(4);
  const Index h = InnerEdge(flipped);
  const double length = (quad.position[flipped.Tail(h)] - quad.position[flipped.Tip(h)]).norm();
  EXPECT_NEAR(complex.MakeLogLengths(flipped)[flipped.edge[h]], std::log(length), 1e-14);
  EXPECT_EQ(flipped.Tail(h) + flipped.Tip(h), 4);  // 1 and 3
  EXPECT_EQ(complex.label(h), kNone);
}

/// Opposite an edge of length 1 an angle pi - x with x^2 = 8 `missing`, or pi where that is not above 0,
/// and one of e^-`narrow`.
bool ViolatesBesideNeedle(double missing, double narrow) {
  const Triangulation t = OnACircle().triangulation;
  const Index h = InnerEdge(t);
  std::vector<TripleDouble> scale(4, 0.0);
  const TripleDouble half =
      -LogAddExp(TripleDouble(0), 0) + missing;  // log of the obtuse one's sides
  scale[t.vertex[h]] = half + half;
  scale[t.vertex[t.twin[h]]] = 2 * narrow;
  const PtolemyComplex complex(t, Eigen::VectorXd::Zero(t.num_edges()), scale);
  return complex.ViolatesDelaunay(h, Eigen::VectorXd::Zero(4));
}

TEST(PtolemyComplex, AnAngleOfAllButPiIsHeldAgainstTheNeedlesThatAddsToIt) {
  EXPECT_TRUE(ViolatesBesideNeedle(-1e-28, 46));
  EXPECT_FALSE(ViolatesBesideNeedle(1e-28, 46));  // pi - 3e-14 + 1e-20
  EXPECT_TRUE(ViolatesBesideNeedle(1e-28, 30));   // pi - 3e-14 + 9e-14
  EXPECT_FALSE(ViolatesBesideNeedle(1e-28, 33));  // pi - 3e-14 + 5e-15
  EXPECT_TRUE(ViolatesBesideNeedle(1e-20, 20));   // pi - 3e-10 + 2e-9
  EXPECT_TRUE(ViolatesBesideNeedle(1e-38, 42));   // pi - 3e-19 + 6e-19
  EXPECT_FALSE(ViolatesBesideNeedle(1e-38, 44));  // pi - 3e-19 + 8e-20
}

TEST(PtolemyComplex, FlippingTwiceComesBack) {
  const Surface blob = GeneratedSurface("blob", 60);
  const Eigen::VectorXd before = LogLengths(blob);
  PtolemyComplex complex(blob.triangulation, before);
  const Index h = blob.triangulation.edge_halfedge[20];
  const double length = before[blob.triangulation.edge[h]];
  complex.Flip(h);
  complex.Flip(h);
  const Eigen::VectorXd zero = Eigen::VectorXd::Zero(blob.triangulation.num_vertices);
  EXPECT_NEAR(complex.ScaledLogLength(h, zero), length, 1e-14);
  EXPECT_EQ(complex.flips(), (std::vector<Index>{h, h}));
}

TEST(PtolemyComplex, AnyScalesBecomeDelaunayTriangles) {
  const Surface blob = GeneratedSurface("blob", 300);
  const Triangulation& t = blob.triangulation;
  for (const double size : {0.1, 1.0, 10.0, 300.0}) {
    PtolemyComplex complex(t, LogLengths(blob));
    const Eigen::VectorXd u = RandomScale(t.num_vertices, size);
    ASSERT_TRUE(complex.MakeDelaunay(u));
    EXPECT_GT(complex.flips().size(), 0u);
    for (Index h = 0; h < t.num_halfedges(); ++h) EXPECT_FALSE(complex.ViolatesDelaunay(h, u));
    for (Index f = 0; f < complex.num_faces(); ++f) {
      EXPECT_TRUE(complex.ScaledTriangle(f, u).proper) << size << " face " << f;
    }
  }
}

TEST(PtolemyComplex, TheScaledMetricIsDelaunayByAngles) {
  const Surface blob = GeneratedSurface("blob", 200);
  const Eigen::VectorXd u = RandomScale(blob.triangulation.num_vertices, 1);
  PtolemyComplex complex(blob.triangulation, LogLengths(blob));
  ASSERT_TRUE(complex.MakeDelaunay(u));
  const Triangulation t = complex.MakeTriangulation(blob.triangulation.num_vertices);
  EdgeLengths scaled{Eigen::VectorXd(t.num_edges())};
  for (Index e = 0; e < t.num_edges(); ++e) {
    scaled.value[e] = std::exp(complex.ScaledLogLength(t.edge_halfedge[e], u));
  }
  EXPECT_TRUE(NonDelaunayEdges(t, scaled).empty());
}

TEST(PtolemyComplex, BoundaryEdgesAndEdgesOfOneFaceStay) {
  const Surface disk = GeneratedSurface("bumpy_terrain", 60);
  const Triangulation folded = WithFoldedFace(disk.triangulation, InnerEdge(disk.triangulation));
  const Eigen::VectorXd lengths = Eigen::VectorXd::Zero(folded.num_edges());
  PtolemyComplex complex(folded, lengths);
  const Eigen::VectorXd u = RandomScale(folded.num_vertices, 4);
  ASSERT_TRUE(complex.MakeDelaunay(u));
  const Triangulation t = complex.MakeTriangulation(folded.num_vertices);
  EXPECT_EQ(BoundaryVertices(t), BoundaryVertices(folded));
  EXPECT_GT(complex.flips().size(), 0u);
}

}  // namespace
}  // namespace cirque
