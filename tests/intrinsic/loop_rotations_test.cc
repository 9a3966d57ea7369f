#include "cirque/intrinsic/loop_rotations.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "cirque/intrinsic/intrinsic_delaunay.h"
#include "cirque/intrinsic/intrinsic_surface.h"

#include "tests/common/surfaces.h"

namespace cirque {
namespace {

/// The faces around a vertex, counter-clockwise.
DualPath LoopAround(const Triangulation& t, Index vertex) {
  DualPath path;
  Index corner = 0;
  while (t.vertex[corner] != vertex) ++corner;
  t.ForEachCornerAround(corner, [&](Index c) { path.entered.push_back(Triangulation::Prev(c)); });
  return path;
}

std::vector<double> RotationsOf(const Triangulation& t, const EdgeLengths& lengths,
                                const std::vector<DualPath>& paths) {
  const Eigen::VectorXd angles = MeasureSurface(t, lengths).angles.value;
  std::vector<double> rotations;
  for (const DualPath& path : paths) {
    for (std::size_t i = 0; i < path.entered.size();
         ++i) {  // it is a path, which turns back nowhere
      const Index exit = t.twin[path.entered[(i + 1) % path.entered.size()]];
      EXPECT_EQ(Triangulation::Face(exit), Triangulation::Face(path.entered[i]));
      EXPECT_NE(exit, path.entered[i]);
    }
    rotations.push_back(RotationAlong(CornersAlong(t, path), angles));
  }
  return rotations;
}

TEST(PathsAfterFlips, HaveTheRotationsThatTheyHad) {
  // Flips change no metric, and a path that stays in its class passes no vertex, where all the
  // curvature is: what directions turn by stays, too.
  for (const char* name : {"torus", "double_torus"}) {
    const Surface surface = Moved(GeneratedSurface(name, 1200), [](const Eigen::Vector3d& x) {
      return Eigen::Vector3d(5 * x.x(), x.y(), x.z());
    });
    const Triangulation& t = surface.triangulation;
    const EdgeLengths lengths = MeasureEdgeLengths(surface);
    std::vector<DualPath> paths = HandleLoops(t);
    for (const Index v : {0, 17, 200}) paths.push_back(LoopAround(t, v));
    const std::vector<double> before = RotationsOf(t, lengths, paths);
    const IntrinsicTriangulation delaunay = MakeIntrinsicDelaunay(t, lengths);
    EXPECT_GT(delaunay.flips.size(), 200u);
    const std::vector<DualPath> carried = PathsAfterFlips(t, delaunay.flips, paths);
    ASSERT_EQ(carried.size(), paths.size());
    const std::vector<double> after =
        RotationsOf(delaunay.triangulation, delaunay.lengths, carried);
    double largest = 0;
    for (std::size_t q = 0; q < paths.size(); ++q) {
      EXPECT_NEAR(after[q], before[q], 1e-9) << name << " " << q;
      largest = std::max(largest, std::abs(before[q]));
    }
    EXPECT_GT(largest, 0.1);
  }
}

TEST(PathsAfterFlips, AroundAVertexAreAllItsAngles) {
  const Surface surface = Moved(GeneratedSurface("torus", 600), [](const Eigen::Vector3d& x) {
    return Eigen::Vector3d(4 * x.x(), x.y(), x.z());
  });
  const Triangulation& t = surface.triangulation;
  const EdgeLengths lengths = MeasureEdgeLengths(surface);
  const std::vector<double> sum = VertexAngleSums(t, MeasureSurface(t, lengths).angles);
  const IntrinsicTriangulation delaunay = MakeIntrinsicDelaunay(t, lengths);
  for (Index v = 0; v < t.num_vertices; v += 7) {
    const auto carried = PathsAfterFlips(t, delaunay.flips, {LoopAround(t, v)});
    EXPECT_NEAR(std::abs(RotationsOf(delaunay.triangulation, delaunay.lengths, carried)[0]), sum[v],
                1e-9);
  }
}

}  // namespace
}  // namespace cirque
