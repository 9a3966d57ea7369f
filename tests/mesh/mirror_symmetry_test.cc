#include "cirque/mesh/mirror_symmetry.h"

#include <gtest/gtest.h>

#include "cirque/mesh/surface.h"

#include "tests/common/surfaces.h"

namespace cirque {
namespace {

std::optional<MirrorSymmetry> SymmetryOf(const Surface& surface, double tolerance = 1e-9) {
  return FindMirrorSymmetry(surface, RingsOf(surface), tolerance);
}

/// What makes it one, of triangles: halfedges go to those of faces turned round, twins to twins, and back.
void ExpectMirrors(const Triangulation& t, const MirrorSymmetry& symmetry) {
  for (Index h = 0; h < t.num_halfedges(); ++h) {
    const Index image = symmetry.halfedge[h];
    EXPECT_EQ(symmetry.halfedge[image], h);
    EXPECT_EQ(symmetry.halfedge[Triangulation::Next(h)], Triangulation::Prev(image));
    EXPECT_EQ(t.vertex[image], symmetry.vertex[t.vertex[h]]);
    EXPECT_EQ(t.Tip(image), symmetry.vertex[t.Tail(h)]);
    const Index twin = t.twin[h];
    EXPECT_EQ(t.twin[image], twin == kNone ? kNone : symmetry.halfedge[twin]);
  }
}

TEST(FindMirrorSymmetry, FindsTheMiddleOfASymmetricStrip) {
  Surface strip = FlatStrip(6, 4);
  for (Eigen::Vector3d& x : strip.position) {
    x.z() = 0.3 * x.y() * (x.x() - 3) * (x.x() - 3) + 0.1 * x.y() * x.y();
  }
  const auto symmetry = SymmetryOf(strip);
  ASSERT_TRUE(symmetry);
  ExpectMirrors(strip.triangulation, *symmetry);
  EXPECT_LT(symmetry->length_mismatch, 1e-14);
  for (Index v = 0; v < strip.triangulation.num_vertices; ++v) {
    const Eigen::Vector3d &x = strip.position[v], y = strip.position[symmetry->vertex[v]];
    EXPECT_NEAR(y.x(), 6 - x.x(), 1e-15);
    EXPECT_EQ(y.y(), x.y());
  }
}

TEST(FindMirrorSymmetry, OneVertexMovedIsNoSymmetry) {
  Surface strip = FlatStrip(6, 4);
  ASSERT_TRUE(SymmetryOf(strip));
  strip.position[9] += Eigen::Vector3d(0.02, 0.03, 0);  // off both axes
  EXPECT_FALSE(SymmetryOf(strip, 1e-3));
  const auto nearly = SymmetryOf(strip, 0.1);
  ASSERT_TRUE(nearly);
  EXPECT_GT(nearly->length_mismatch, 1e-3);
}

TEST(FindMirrorSymmetry, AnAxisMayLeadThroughFaces) {
  const Surface fan = Fan(5, 0.4);
  const auto symmetry = SymmetryOf(fan);
  ASSERT_TRUE(symmetry);
  ExpectMirrors(fan.triangulation, *symmetry);
  int across = 0;
  for (Index h = 0; h < fan.triangulation.num_halfedges(); ++h)
    across += symmetry->halfedge[h] == h;
  EXPECT_EQ(across, 1);
}

/// Quads, each cut by one diagonal, which no mirror image has.
TEST(FindMirrorSymmetry, DiagonalsOfPolygonsDoNotMatter) {
  PolygonSoup soup;
  for (int j = 0; j < 3; ++j) {
    for (int i = 0; i < 4; ++i) soup.position.emplace_back(i, j, j * j * 0.2);
  }
  for (int j = 0; j < 2; ++j) {
    for (int i = 0; i < 3; ++i) {
      for (const int v : {4 * j + i, 4 * j + i + 1, 4 * j + i + 5, 4 * j + i + 4}) {
        soup.corner.push_back(v);
      }
      soup.first_corner.push_back(static_cast<Index>(soup.corner.size()));
    }
  }
  const Surface grid = SurfaceOf(soup);
  const auto symmetry = SymmetryOf(grid);
  ASSERT_TRUE(symmetry);
  for (Index v = 0; v < 12; ++v) {
    const Eigen::Vector3d &x = grid.position[v], y = grid.position[symmetry->vertex[v]];
    EXPECT_EQ(y, Eigen::Vector3d(3 - x.x(), x.y(), x.z()));
  }
}

TEST(FindMirrorSymmetry, ATurnIsNoMirrorImage) {
  // Symmetric under half a turn only.
  Surface strip = FlatStrip(6, 4);
  for (Eigen::Vector3d& x : strip.position) x.x() += 0.2 * x.y();
  EXPECT_FALSE(SymmetryOf(strip, 1e-3));
}

}  // namespace
}  // namespace cirque
