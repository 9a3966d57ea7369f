#include "cirque/intrinsic/dual_paths.h"

#include <algorithm>
#include <cmath>
#include <set>

#include <Eigen/LU>
#include <gtest/gtest.h>

#include "cirque/intrinsic/intrinsic_surface.h"

#include "tests/common/surfaces.h"

namespace cirque {
namespace {

/// A flat torus of columns x rows unit squares, each halved by a diagonal; faces of square (i, j)
/// are 2 (j columns + i) and the next.
Triangulation TorusGrid(int columns, int rows) {
  const auto vertex = [&](int i, int j) { return (j % rows) * columns + i % columns; };
  std::vector<Index> corner, twin;
  for (int j = 0; j < rows; ++j) {
    for (int i = 0; i < columns; ++i) {
      for (const Index v : {vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1), vertex(i, j),
                            vertex(i + 1, j + 1), vertex(i, j + 1)}) {
        corner.push_back(v);
      }
    }
  }
  // Halfedges of the lower face: right side, diagonal, bottom; of the upper one: top, left side,
  // diagonal.
  const auto face = [&](int i, int j) {
    return 6 * (((j + rows) % rows) * columns + (i + columns) % columns);
  };
  for (int j = 0; j < rows; ++j) {
    for (int i = 0; i < columns; ++i) {
      for (const Index h : {face(i + 1, j) + 4, face(i, j) + 5, face(i, j - 1) + 3,
                            face(i, j + 1) + 2, face(i - 1, j) + 0, face(i, j) + 1}) {
        twin.push_back(h);
      }
    }
  }
  return NumberEdges(columns * rows, std::move(corner), std::move(twin));
}

/// Every face of a path is entered and left by different edges of it, and the next is across.
void ExpectIsAPath(const Triangulation& t, const DualPath& path) {
  for (std::size_t i = 0; i < path.entered.size(); ++i) {
    const bool last = i + 1 == path.entered.size();
    const Index exit =
        last && !path.IsClosed() ? path.exit : t.twin[path.entered[last ? 0 : i + 1]];
    ASSERT_NE(exit, kNone);
    EXPECT_EQ(Triangulation::Face(exit), Triangulation::Face(path.entered[i]));
    EXPECT_NE(exit, path.entered[i]);
  }
}

TEST(DualPaths, ThereAreTwoLoopsAHandle) {
  const auto count = [](const char* generator) {
    return HandleLoops(GeneratedSurface(generator, 600).triangulation).size();
  };
  EXPECT_EQ(count("sphere"), 0u);
  EXPECT_EQ(count("annulus"), 0u);
  EXPECT_EQ(count("bumpy_terrain"), 0u);
  EXPECT_EQ(count("torus"), 2u);
  EXPECT_EQ(count("double_torus"), 4u);
  const Triangulation torus = GeneratedSurface("torus", 600).triangulation;
  Triangulation open = torus;
  for (Index h = 0; h < 3; ++h) open.twin[open.twin[h]] = kNone;
  open = NumberEdges(torus.num_vertices, {open.vertex.begin() + 3, open.vertex.end()}, [&] {
    std::vector<Index> twin(open.twin.begin() + 3, open.twin.end());
    for (Index& h : twin) h = h == kNone ? kNone : h - 3;
    return twin;
  }());
  EXPECT_EQ(HandleLoops(open).size(), 2u);
}

TEST(DualPaths, LoopsArePathsAndNoTwoAreTheSame) {
  const Triangulation t = GeneratedSurface("double_torus", 800).triangulation;
  std::set<std::set<Index>> seen;
  for (const DualPath& loop : HandleLoops(t)) {
    EXPECT_TRUE(loop.IsClosed());
    ExpectIsAPath(t, loop);
    seen.insert({loop.entered.begin(), loop.entered.end()});
  }
  EXPECT_EQ(seen.size(), 4u);
}

// Each loop's displacement in the plane that covers the torus: they span the lattice of periods.
TEST(DualPaths, LoopsOfATorusGenerateItsPeriods) {
  const int columns = 5, rows = 4;
  const Triangulation t = TorusGrid(columns, rows);
  ASSERT_EQ(EulerCharacteristic(t), 0);
  const std::vector<DualPath> loops = HandleLoops(t);
  ASSERT_EQ(loops.size(), 2u);
  Eigen::Matrix2i turns;
  for (int q = 0; q < 2; ++q) {
    ExpectIsAPath(t, loops[q]);
    Eigen::Vector2i squares(0, 0);
    for (const Index h : loops[q].entered) {
      // Into the upper face by its left side one goes right, by its top down, and the other way.
      const Index k = h % 6;
      if (k == 4) ++squares.x();
      if (k == 0) --squares.x();
      if (k == 2) ++squares.y();
      if (k == 3) --squares.y();
    }
    EXPECT_EQ(squares.x() % columns, 0);
    EXPECT_EQ(squares.y() % rows, 0);
    turns.col(q) = Eigen::Vector2i(squares.x() / columns, squares.y() / rows);
  }
  EXPECT_EQ(std::abs(turns.determinant()), 1);
}

TEST(DualPaths, NothingTurnsAlongAFlatTorus) {
  const Triangulation t = TorusGrid(6, 7);
  EdgeLengths lengths{Eigen::VectorXd::Ones(t.num_edges())};
  for (Index h = 1; h < t.num_halfedges(); h += 6) lengths.value[t.edge[h]] = std::sqrt(2.0);
  const Eigen::VectorXd angles = MeasureCornerAngles(t, lengths).value;
  for (const DualPath& loop : HandleLoops(t)) {
    EXPECT_NEAR(RotationAlong(CornersAlong(t, loop), angles), 0, 1e-12);
  }
}

TEST(DualPaths, AroundAVertexDirectionsTurnByItsAngles) {
  const Surface sphere = GeneratedSurface("blob", 300);
  const Triangulation& t = sphere.triangulation;
  const CornerAngles angles = AnglesOf(sphere);
  const std::vector<double> sums = VertexAngleSums(t, angles);
  DualPath around;
  t.ForEachCornerAround(0, [&](Index c) { around.entered.push_back(Triangulation::Prev(c)); });
  ExpectIsAPath(t, around);
  EXPECT_NEAR(RotationAlong(CornersAlong(t, around), angles.value), sums[t.vertex[0]], 1e-12);
}

TEST(DualPaths, BetweenTheLoopsOfAPlaneRingTurnsWhatItsEdgesDo) {
  const Surface ring = GeneratedSurface("annulus", 500);
  const Triangulation& t = ring.triangulation;
  const CornerAngles angles = AnglesOf(ring);
  const std::vector<DualPath> paths = BoundaryPaths(t);
  ASSERT_EQ(paths.size(), 1u);
  ExpectIsAPath(t, paths[0]);
  const auto direction = [&](Index from, Index to) {
    const Eigen::Vector3d d = ring.position[to] - ring.position[from];
    return std::atan2(d.y(), d.x());
  };
  const Index in = paths[0].entered.front(), out = paths[0].exit;
  const double expected = direction(t.Tip(out), t.Tail(out)) - direction(t.Tail(in), t.Tip(in));
  const double found = RotationAlong(CornersAlong(t, paths[0]), angles.value);
  EXPECT_NEAR(BeyondMultiple(found - expected, 2 * kPi), 0, 1e-12);
  const std::vector<double> sums = VertexAngleSums(t, angles);
  const auto loops = BoundaryLoops(t);
  const double first = RotationAround(t, loops[0], sums),
               second = RotationAround(t, loops[1], sums);
  EXPECT_NEAR(std::abs(first), 2 * kPi, 1e-11);
  EXPECT_NEAR(first + second, 0, 1e-11);
}

TEST(DualPaths, EveryPieceHasPathsBetweenItsOwnLoops) {
  // A disk, a ring, a closed surface and a ring, side by side.
  std::vector<Index> corner, twin;
  for (const char* kind : {"bumpy_terrain", "annulus", "blob", "annulus"}) {
    const Triangulation t = GeneratedSurface(kind, 200).triangulation;
    const auto first = static_cast<Index>(corner.size());
    const Index offset = corner.empty() ? 0 : *std::max_element(corner.begin(), corner.end()) + 1;
    for (Index h = 0; h < t.num_halfedges(); ++h) {
      corner.push_back(t.vertex[h] + offset);
      twin.push_back(t.twin[h] == kNone ? kNone : t.twin[h] + first);
    }
  }
  const Index vertices = *std::max_element(corner.begin(), corner.end()) + 1;
  const Triangulation all = NumberEdges(vertices, std::move(corner), std::move(twin));
  const std::vector<DualPath> paths = BoundaryPaths(all);
  ASSERT_EQ(paths.size(), 2u);
  for (const DualPath& path : paths) ExpectIsAPath(all, path);
  EXPECT_NE(paths[0].exit, paths[1].exit);
}

TEST(DualPaths, BeyondAMultipleIsWhatRemains) {
  EXPECT_NEAR(BeyondMultiple(3.2, 1.5), 0.2, 1e-15);
  EXPECT_NEAR(BeyondMultiple(-1.6, 1.5), -0.1, 1e-15);
  EXPECT_EQ(BeyondMultiple(0, kPi / 2), 0);
}

}  // namespace
}  // namespace cirque
