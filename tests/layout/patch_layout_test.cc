// Flat surfaces with cones, handles and loops, laid out along automatic cuts.
#include <algorithm>
#include <cmath>
#include <random>

#include <Eigen/Geometry>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cirque/cuts/cut_graph.h"
#include "cirque/intrinsic/intrinsic_surface.h"
#include "cirque/layout/linear_layout.h"
#include "cirque/layout/planar_layout.h"
#include "cirque/layout/seams.h"
#include "cirque/metrics/injectivity.h"

#include "tests/common/surfaces.h"
#include "tests/layout/flat_surfaces.h"

namespace cirque {
namespace {

struct LaidOut {
  Cut cut;
  PlanarLayout layout;
  SeamReport seams;
};

LaidOut LayOut(const KnownFlatSurface& flat) {
  const Triangulation& t = flat.surface.triangulation;
  LaidOut result;
  result.cut = *CutGraph(t, flat.lengths.value, flat.cones);
  result.layout = LayOutPatches(t, flat.angles, flat.lengths, result.cut);
  result.seams = MeasureSeams(t, result.cut, flat.cones, flat.angles, result.layout.uv);
  return result;
}

double SignedArea(const CornerUv& uv) {
  double area = 0;
  for (std::size_t c = 0; c < uv.value.size(); c += 3) {
    const Eigen::Vector2d a = uv.value[c + 1] - uv.value[c], b = uv.value[c + 2] - uv.value[c];
    area += 0.5 * (a.x() * b.y() - a.y() * b.x());
  }
  return area;
}

/// Every triangle has its own edge lengths in the plane, none is turned over.
void ExpectIsometric(const KnownFlatSurface& flat, const CornerUv& uv) {
  const Triangulation& t = flat.surface.triangulation;
  for (Index h = 0; h < t.num_halfedges(); ++h) {
    const double length =
        (uv.value[Triangulation::Prev(h)] - uv.value[Triangulation::Next(h)]).norm();
    ASSERT_NEAR(length, flat.lengths.value[t.edge[h]], 1e-11);
  }
  EXPECT_TRUE(FlippedFaces(t, uv).empty());
}

void ExpectConsistent(const LaidOut& result) {
  EXPECT_GT(result.seams.seams.size(), 0u);
  EXPECT_LT(result.layout.closure, 1e-11);
  EXPECT_LT(result.seams.max_length_mismatch, 1e-11);
  EXPECT_LT(result.seams.max_rotation_mismatch, 1e-11);
  EXPECT_LT(result.seams.max_gap, 1e-12);
  EXPECT_LT(result.seams.max_cone_mismatch, 1e-11);
}

TEST(PatchLayout, CubeUnfoldsWithQuarterTurns) {
  const KnownFlatSurface cube = FlatCube(6);
  ASSERT_EQ(cube.cones.size(), 8u);
  LaidOut result = LayOut(cube);
  ExpectConsistent(result);
  ExpectIsometric(cube, result.layout.uv);
  EXPECT_NEAR(SignedArea(result.layout.uv), 6 * 36, 1e-9);
  const auto turns = IntegerRotations(cube.surface.triangulation, result.seams, 4, 1e-9);
  ASSERT_TRUE(turns.ok()) << turns.status().message();
  // A tree through 8 cones of 3 pi/2: all of its leaves turn by a quarter, so some seams do.
  EXPECT_GE(std::count_if(turns->begin(), turns->end(), [](int m) { return std::abs(m) == 1; }), 2);
}

TEST(PatchLayout, PillowOfFourConesOfPi) {
  const KnownFlatSurface pillow = FlatPillow(5, 3);
  ASSERT_EQ(pillow.cones.size(), 4u);
  const LaidOut result = LayOut(pillow);
  ExpectConsistent(result);
  ExpectIsometric(pillow, result.layout.uv);
  EXPECT_NEAR(SignedArea(result.layout.uv), 30, 1e-11);
  const auto turns = IntegerRotations(pillow.surface.triangulation, result.seams, 2, 1e-9);
  ASSERT_TRUE(turns.ok()) << turns.status().message();
}

TEST(PatchLayout, CylinderBecomesARectangleGluedByATranslation) {
  const KnownFlatSurface cylinder = FlatCylinder(7, 4);
  const LaidOut result = LayOut(cylinder);
  ExpectConsistent(result);
  ExpectIsometric(cylinder, result.layout.uv);
  ASSERT_EQ(result.seams.seams.size(), 1u);
  EXPECT_NEAR(result.seams.seams[0].rotation, 0, 1e-12);
  EXPECT_NEAR(result.seams.seams[0].translation.norm(), 7, 1e-11);
  EXPECT_EQ(result.seams.seams[0].halfedges.size(), 4u);
  Eigen::AlignedBox2d box;
  for (const auto& p : result.layout.uv.value) box.extend(p);
  EXPECT_NEAR(box.volume(), 28, 1e-10);
}

TEST(PatchLayout, TorusGivesItsPeriods) {
  const KnownFlatSurface torus = FlatTorus(5, 4);
  ASSERT_TRUE(torus.cones.empty());
  const LaidOut result = LayOut(torus);
  ExpectConsistent(result);
  ExpectIsometric(torus, result.layout.uv);
  EXPECT_NEAR(SignedArea(result.layout.uv), 20, 1e-11);
  // All translations are of the lattice that the periods 5 and 4 span, one of them is a period.
  double shortest = 100;
  for (const Seam& seam : result.seams.seams) {
    EXPECT_NEAR(seam.rotation, 0, 1e-12);
    shortest = std::min(shortest, seam.translation.norm());
  }
  EXPECT_NEAR(shortest, 4, 1e-11);
}

TEST(PatchLayout, TwoPatchesEachInItsOwnFrame) {
  const KnownFlatSurface cylinder = FlatCylinder(8, 2);
  const Triangulation& t = cylinder.surface.triangulation;
  Cut cut = {std::vector<bool>(t.num_edges(), false)};
  for (Index e = 0; e < t.num_edges(); ++e) {
    // The lines x = 0 and x = 5.
    const auto x = [&](Index v) { return cylinder.surface.position[v].x(); };
    const double tail = x(t.Tail(t.edge_halfedge[e])), tip = x(t.Tip(t.edge_halfedge[e]));
    cut.edge[e] = tail == tip && (tail == 0 || tail == 5);
  }
  ASSERT_TRUE(CheckCut(t, cut, {}).ok());
  const PlanarLayout layout = LayOutPatches(t, cylinder.angles, cylinder.lengths, cut);
  EXPECT_EQ(layout.patches.count, 2);
  EXPECT_EQ(layout.patch_closure.size(), 2u);
  ExpectIsometric(cylinder, layout.uv);
  const SeamReport seams = MeasureSeams(t, cut, {}, cylinder.angles, layout.uv);
  EXPECT_EQ(seams.seams.size(), 2u);
  EXPECT_LT(seams.max_gap, 1e-12);
}

TEST(PatchLayout, AWrongLengthIsSeen) {
  const KnownFlatSurface cylinder = FlatCylinder(7, 4);
  const Triangulation& t = cylinder.surface.triangulation;
  const Cut cut = *CutGraph(t, cylinder.lengths.value, {});
  int seen_across_the_seam = 0;
  for (Index e = 0; e < t.num_edges(); ++e) {
    EdgeLengths wrong = cylinder.lengths;
    wrong.value[e] *= 0.6;
    const PlanarLayout layout = LayOutPatches(t, cylinder.angles, wrong, cut);
    EXPECT_GT(layout.closure, 1e-3) << "edge " << e;
    const SeamReport seams = MeasureSeams(t, cut, {}, cylinder.angles, layout.uv);
    if (seams.max_length_mismatch > 1e-3) ++seen_across_the_seam;
  }
  EXPECT_GE(seen_across_the_seam, 3);
}

TEST(PatchLayout, AWrongConeAngleIsSeen) {
  KnownFlatSurface cube = FlatCube(4);
  const LaidOut good = LayOut(cube);
  const Triangulation& t = cube.surface.triangulation;
  const auto corner = std::find(t.vertex.begin(), t.vertex.end(), cube.cones[0]);
  CornerAngles claimed = cube.angles;
  claimed.value[corner - t.vertex.begin()] += 0.01;
  const SeamReport report = MeasureSeams(t, good.cut, cube.cones, claimed, good.layout.uv);
  EXPECT_NEAR(report.max_cone_mismatch, 0.01, 1e-9);
}

/// Angles with errors, as a solver leaves them; triangles keep their sums.
KnownFlatSurface WithNoise(KnownFlatSurface flat, double noise) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> error(-noise, noise);
  for (Index f = 0; f < flat.surface.triangulation.num_faces(); ++f) {
    const double a = error(random), b = error(random);
    flat.angles.value[3 * f] += a;
    flat.angles.value[3 * f + 1] += b;
    flat.angles.value[3 * f + 2] -= a + b;
  }
  return flat;
}

TEST(SnapSeams, QuarterTurnsBecomeExact) {
  const KnownFlatSurface cube = WithNoise(FlatCube(8), 1e-9);
  const Triangulation& t = cube.surface.triangulation;
  LaidOut result = LayOut(cube);
  EXPECT_GT(result.seams.max_gap, 1e-11);
  const auto turns = IntegerRotations(t, result.seams, 4, 1e-6);
  ASSERT_TRUE(turns.ok()) << turns.status().message();
  CornerUv uv = result.layout.uv;
  const double moved = SnapSeams(t, result.cut, result.seams, *turns, 4, &uv);
  EXPECT_GT(moved, 1e-10);
  EXPECT_LT(moved, 1e-6);
  const SeamReport snapped = MeasureSeams(t, result.cut, cube.cones, cube.angles, uv);
  EXPECT_LT(snapped.max_gap, 1e-14);
  EXPECT_LT(snapped.max_rotation_mismatch, 1e-13);
  for (std::size_t i = 0; i < turns->size(); ++i) {
    EXPECT_NEAR(std::remainder(snapped.seams[i].rotation - (*turns)[i] * kPi / 2, 2 * kPi), 0,
                1e-14);
  }
}

TEST(SnapSeams, SixthTurnsBecomeExact) {
  const KnownFlatSurface octahedron = WithNoise(FlatOctahedron(7), 1e-9);
  ASSERT_EQ(octahedron.cones.size(), 6u);
  const Triangulation& t = octahedron.surface.triangulation;
  const LaidOut result = LayOut(octahedron);
  const auto turns = IntegerRotations(t, result.seams, 6, 1e-6);
  ASSERT_TRUE(turns.ok()) << turns.status().message();
  CornerUv uv = result.layout.uv;
  EXPECT_LT(SnapSeams(t, result.cut, result.seams, *turns, 6, &uv), 1e-6);
  const SeamReport snapped = MeasureSeams(t, result.cut, octahedron.cones, octahedron.angles, uv);
  EXPECT_GT(result.seams.max_gap, 1e-11);
  EXPECT_LT(snapped.max_gap, 1e-14);
  EXPECT_TRUE(FlippedFaces(t, uv).empty());
}

TEST(SnapSeams, AnAngleThatIsNoMultipleIsNamed) {
  const KnownFlatSurface cube = FlatCube(3);
  const LaidOut result = LayOut(cube);
  const auto thirds = IntegerRotations(cube.surface.triangulation, result.seams, 3, 1e-6);
  EXPECT_THAT(thirds.status().message(), testing::HasSubstr("no multiple of 2 pi / 3"));
}

TEST(PoissonLayout, EqualsDirectionsOnExactAngles) {
  const KnownFlatSurface cube = FlatCube(5);
  const Triangulation& t = cube.surface.triangulation;
  const Cut cut = *CutGraph(t, cube.lengths.value, cube.cones);
  const auto layout = LayOutByLeastSquares(t, cube.angles, cube.lengths, cut);
  ASSERT_TRUE(layout.ok()) << layout.status().message();
  EXPECT_LT(layout->closure, 1e-11);
  ExpectIsometric(cube, layout->uv);
}

TEST(PoissonLayout, SpreadsErrorsOfAngles) {
  const KnownFlatSurface cube = WithNoise(FlatCube(8), 1e-6);
  const Triangulation& t = cube.surface.triangulation;
  const Cut cut = *CutGraph(t, cube.lengths.value, cube.cones);
  const double by_tree = LayOutPatches(t, cube.angles, cube.lengths, cut).closure;
  const auto least_squares = LayOutByLeastSquares(t, cube.angles, cube.lengths, cut);
  ASSERT_TRUE(least_squares.ok());
  EXPECT_GT(by_tree, 1e-6);
  EXPECT_LT(least_squares->closure, 0.5 * by_tree);
  RecordProperty("ratio", std::to_string(least_squares->closure / by_tree));
}

}  // namespace
}  // namespace cirque
