#include "cirque/intrinsic/intrinsic_delaunay.h"

#include <algorithm>
#include <cmath>
#include <random>
#include <set>

#include <gtest/gtest.h>

#include "cirque/generators/generators.h"
#include "cirque/intrinsic/intrinsic_surface.h"
#include "cirque/math/predicates.h"
#include "cirque/mesh/preflight.h"

#include "tests/common/renumbering.h"
#include "tests/common/surfaces.h"
#include "tests/mesh/scrambled.h"

namespace cirque {
namespace {

using testing::IntrinsicMesh;

using EdgeSet = std::multiset<std::pair<Index, Index>>;

EdgeSet EdgesOf(const Triangulation& t) {
  EdgeSet edges;
  for (const Index h : t.edge_halfedge) edges.insert(std::minmax(t.Tail(h), t.Tip(h)));
  return edges;
}

IntrinsicMesh Intrinsic(const Surface& surface) {
  return {surface.triangulation, MeasureEdgeLengths(surface)};
}

IntrinsicTriangulation Delaunay(const IntrinsicMesh& mesh,
                                const IntrinsicDelaunayOptions& options = {}) {
  return MakeIntrinsicDelaunay(mesh.triangulation, mesh.lengths, options);
}

Eigen::VectorXd AngleSums(const Triangulation& t, const EdgeLengths& lengths) {
  const CornerAngles angles = MeasureCornerAngles(t, lengths);
  Eigen::VectorXd sums = Eigen::VectorXd::Zero(t.num_vertices);
  for (Index h = 0; h < t.num_halfedges(); ++h) sums[t.vertex[h]] += angles.value[h];
  return sums;
}

double Area(const Triangulation& t, const EdgeLengths& lengths) {
  const CornerAngles angles = MeasureCornerAngles(t, lengths);
  double area = 0;
  for (Index h = 0; h < t.num_halfedges(); h += 3) {
    area += 0.5 * lengths.value[t.edge[h]] * lengths.value[t.edge[h + 1]] *
            std::sin(angles.value[h + 2]);
  }
  return area;
}

void ExpectInvariants(const Triangulation& t) {
  std::vector<bool> seen(t.num_vertices, false);
  for (Index h = 0; h < t.num_halfedges(); ++h) {
    seen[t.vertex[h]] = true;
    const Index g = t.twin[h];
    if (g == kNone) continue;
    ASSERT_EQ(t.twin[g], h);
    ASSERT_EQ(t.Tail(g), t.Tip(h));
    ASSERT_EQ(t.Tip(g), t.Tail(h));
    ASSERT_EQ(t.edge[g], t.edge[h]);
  }
  EXPECT_EQ(std::count(seen.begin(), seen.end(), false), 0);
}

const char* const kGenerators[] = {"bumpy_terrain", "capped_tube", "annulus",     "catenoid",
                                   "blob",          "torus",       "double_torus"};

TEST(IntrinsicDelaunay, BringsAScrambledFlatPatchBack) {
  const Surface patch = GeneratedSurface("flat_delaunay_patch", 3000);
  const IntrinsicMesh scrambled = testing::Scramble(Intrinsic(patch), 20000, 3);
  ASSERT_NE(EdgesOf(scrambled.triangulation), EdgesOf(patch.triangulation));
  const IntrinsicTriangulation delaunay = Delaunay(scrambled);
  EXPECT_EQ(EdgesOf(delaunay.triangulation), EdgesOf(patch.triangulation));
  const Triangulation& t = delaunay.triangulation;
  for (Index e = 0; e < t.num_edges(); ++e) {
    const Index h = t.edge_halfedge[e];
    const auto at = [&](Index corner) {
      return Eigen::Vector2d(patch.position[t.vertex[corner]].head<2>());
    };
    EXPECT_NEAR(delaunay.lengths.value[e],
                (at(Triangulation::Next(h)) - at(Triangulation::Prev(h))).norm(), 1e-9);
    if (t.IsBoundaryEdge(e)) continue;
    EXPECT_LE(
        InCircleSign(at(h), at(Triangulation::Next(h)), at(Triangulation::Prev(h)), at(t.twin[h])),
        0);
  }
}

TEST(IntrinsicDelaunay, OfAFlatTorusIsThePeriodicDelaunayTriangulation) {
  const IntrinsicMesh torus = testing::PeriodicPatch(40, 5);
  const IntrinsicMesh scrambled = testing::Scramble(torus, 10000, 7);
  EXPECT_EQ(EdgesOf(Delaunay(scrambled).triangulation), EdgesOf(torus.triangulation));
}

TEST(IntrinsicDelaunay, ReducesALatticeOnASingleVertex) {
  // The lattice of a rhombus with sides 1 and 70 degrees, given by far too long vectors. The
  // Delaunay triangulation has the reduced basis and the shorter diagonal.
  const double angle = 70 * kPi / 180;
  const Eigen::Vector2d a(1, 0), b(std::cos(angle), std::sin(angle));
  const IntrinsicMesh torus = testing::LatticeTorus(a, b + 23 * a);
  const IntrinsicTriangulation delaunay = Delaunay(torus);
  Eigen::VectorXd lengths = delaunay.lengths.value;
  std::sort(lengths.begin(), lengths.end());
  EXPECT_NEAR(lengths[0], 1, 1e-12);
  EXPECT_NEAR(lengths[1], 1, 1e-12);
  EXPECT_NEAR(lengths[2], (a - b).norm(), 1e-12);
  // From the diagonal b + 24 a to b, one multiple of a at a time.
  EXPECT_EQ(delaunay.flips.size(), 24);
  ExpectInvariants(delaunay.triangulation);
}

TEST(IntrinsicDelaunay, KeepsAreaAndCurvatureOfEverySurface) {
  for (const char* name : kGenerators) {
    SCOPED_TRACE(name);
    const IntrinsicMesh mesh = testing::Scramble(Intrinsic(GeneratedSurface(name, 2000)), 3000, 1);
    const IntrinsicTriangulation delaunay = Delaunay(mesh);
    ExpectInvariants(delaunay.triangulation);
    EXPECT_GT(delaunay.flips.size(), 100);
    const double area = Area(mesh.triangulation, mesh.lengths);
    EXPECT_GT(area, 0.1);
    EXPECT_NEAR(Area(delaunay.triangulation, delaunay.lengths) / area, 1, 1e-11);
    const Eigen::VectorXd before = AngleSums(mesh.triangulation, mesh.lengths);
    const Eigen::VectorXd after = AngleSums(delaunay.triangulation, delaunay.lengths);
    EXPECT_LT((before - after).lpNorm<Eigen::Infinity>(), 1e-8);
    EXPECT_TRUE(NonDelaunayEdges(delaunay.triangulation, delaunay.lengths).empty());
    EXPECT_TRUE(Delaunay({delaunay.triangulation, delaunay.lengths}).flips.empty());
  }
}

TEST(IntrinsicDelaunay, MapsTheEdgesThatStayed) {
  const IntrinsicMesh mesh = Intrinsic(GeneratedSurface("capped_tube", 1500));
  const IntrinsicMesh scrambled = testing::Scramble(mesh, 1000, 2);
  const Triangulation& input = scrambled.triangulation;
  const IntrinsicTriangulation delaunay = Delaunay(scrambled);
  const Triangulation& t = delaunay.triangulation;
  Index kept = 0;
  for (Index e = 0; e < input.num_edges(); ++e) {
    const Index image = delaunay.edge_of_input[e];
    if (image == kNone) continue;
    ++kept;
    EXPECT_EQ(delaunay.lengths.value[image], scrambled.lengths.value[e]);
    const Index h = input.edge_halfedge[e], g = t.edge_halfedge[image];
    EXPECT_EQ(std::minmax(input.Tail(h), input.Tip(h)), std::minmax(t.Tail(g), t.Tip(g)));
  }
  EXPECT_LT(kept, input.num_edges());
  EXPECT_GT(kept, input.num_edges() / 2);
}

TEST(IntrinsicDelaunay, LockedEdgesStay) {
  const IntrinsicMesh mesh =
      testing::Scramble(Intrinsic(GeneratedSurface("bumpy_terrain", 1500)), 3000, 4);
  const std::vector<Index> bad = NonDelaunayEdges(mesh.triangulation, mesh.lengths);
  ASSERT_GT(bad.size(), 20);
  IntrinsicDelaunayOptions options;
  options.locked.assign(mesh.triangulation.num_edges(), false);
  for (std::size_t i = 0; i < bad.size(); i += 2) options.locked[bad[i]] = true;
  const IntrinsicTriangulation constrained = Delaunay(mesh, options);
  EXPECT_FALSE(constrained.flips.empty());
  for (const Index e : NonDelaunayEdges(constrained.triangulation, constrained.lengths)) {
    const auto input =
        std::find(constrained.edge_of_input.begin(), constrained.edge_of_input.end(), e);
    ASSERT_NE(input, constrained.edge_of_input.end());
    EXPECT_TRUE(options.locked[input - constrained.edge_of_input.begin()]);
  }
  for (Index e = 0; e < mesh.triangulation.num_edges(); ++e) {
    EXPECT_TRUE(!options.locked[e] || constrained.edge_of_input[e] != kNone);
  }
  options.locked.assign(mesh.triangulation.num_edges(), true);
  EXPECT_TRUE(Delaunay(mesh, options).flips.empty());
}

/// A sharp spike of six triangles that leans, so that its spokes differ in length.
IntrinsicMesh Spike() {
  Surface fan = Fan(6, 0);
  fan.position[0] = {6, 0, 8};
  return Intrinsic(fan);
}

TEST(IntrinsicDelaunay, GuardsTheLeastNumberOfCorners) {
  const IntrinsicMesh mesh = Spike();
  const IntrinsicTriangulation delaunay = Delaunay(mesh);
  EXPECT_EQ(CornersPerVertex(delaunay.triangulation)[0], 3);
  const std::vector<Index> left = NonDelaunayEdges(delaunay.triangulation, delaunay.lengths);
  EXPECT_FALSE(left.empty());
  for (const Index e : left) {
    const Index h = delaunay.triangulation.edge_halfedge[e];
    EXPECT_EQ(std::min(delaunay.triangulation.Tail(h), delaunay.triangulation.Tip(h)), 0);
  }

  ConeTargets targets = FreeBoundaryTargets(mesh.triangulation);
  IntrinsicDelaunayOptions options;
  options.targets = &targets;
  for (const auto& [theta, corners] :
       {std::pair(kPi / 2, 1), std::pair(kPi, 2), std::pair(1.5 * kPi, 2), std::pair(4 * kPi, 5)}) {
    targets.lower[0] = targets.upper[0] = theta;
    EXPECT_EQ(CornersPerVertex(Delaunay(mesh, options).triangulation)[0], corners) << theta;
  }
}

/// Two spikes side by side on a hexagon: vertices 0 and 1.
IntrinsicMesh TwinSpikes() {
  PolygonSoup soup;
  soup.position = {{5, -0.1, 2}, {5, 0.1, 2}};
  for (int i = 0; i < 6; ++i) {
    soup.position.emplace_back(std::cos(i * kPi / 3), std::sin(i * kPi / 3), 0);
  }
  soup.corner = {0, 2, 1, 1, 2, 3, 1, 3, 4, 1, 4, 5, 1, 5, 0, 0, 5, 6, 0, 6, 7, 0, 7, 2};
  for (Index end = 3; end <= 24; end += 3) soup.first_corner.push_back(end);
  return Intrinsic(SurfaceOf(soup));
}

TEST(IntrinsicDelaunay, FlatNeighboursOfThreeCornersWouldLeaveNothingToTheEndsOfTheirDigon) {
  const IntrinsicMesh mesh = TwinSpikes();
  const auto is_pair = [](const Triangulation& t) {
    const std::vector<Index> corners = CornersPerVertex(t);
    const EdgeSet edges = EdgesOf(t);
    return corners[0] == 3 && corners[1] == 3 && edges.count({0, 1}) > 0;
  };
  EXPECT_FALSE(is_pair(Delaunay(mesh).triangulation));

  // Cones that still need three corners but less than 2 pi leave an angle to each end.
  ConeTargets targets = FreeBoundaryTargets(mesh.triangulation);
  for (const Index v : {0, 1}) targets.lower[v] = targets.upper[v] = 1.992 * kPi;
  IntrinsicDelaunayOptions options;
  options.targets = &targets;
  EXPECT_TRUE(is_pair(Delaunay(mesh, options).triangulation));
}

TEST(IntrinsicDelaunay, FreeVerticesStayFreeWhenTheirCornersChange) {
  const IntrinsicMesh mesh =
      testing::Scramble(Intrinsic(GeneratedSurface("bumpy_terrain", 800)), 500, 8);
  const Triangulation& input = mesh.triangulation;
  ConeTargets targets = FreeBoundaryTargets(input);
  const Index corner = input.vertex[Triangulation::Next(BoundaryLoops(input)[0][0])];
  targets.lower[corner] = 1;
  targets.upper[corner] = 2;
  const auto delaunay = Delaunay(mesh);
  const Triangulation& output = delaunay.triangulation;
  const ConeTargets plain = FreeBoundaryTargets(output);
  ASSERT_NE(plain.upper, FreeBoundaryTargets(input).upper);
  const ConeTargets transferred = TransferTargets(MeasureSurface(input, mesh.lengths), targets,
                                                  MeasureSurface(output, delaunay.lengths));
  for (Index v = 0; v < output.num_vertices; ++v) {
    EXPECT_EQ(transferred.lower[v], v == corner ? 1 : plain.lower[v]);
    EXPECT_EQ(transferred.upper[v], v == corner ? 2 : plain.upper[v]);
  }
}

TEST(IntrinsicDelaunay, SharpSpikeOfOneCornerIsAFaceGluedToItself) {
  const IntrinsicMesh mesh = Spike();
  ConeTargets targets = FreeBoundaryTargets(mesh.triangulation);
  targets.lower[0] = targets.upper[0] = kPi / 3;
  IntrinsicDelaunayOptions options;
  options.targets = &targets;
  const IntrinsicTriangulation delaunay = Delaunay(mesh, options);
  const Triangulation& t = delaunay.triangulation;
  ExpectInvariants(t);
  const auto corner = std::find(t.vertex.begin(), t.vertex.end(), 0) - t.vertex.begin();
  const auto h = static_cast<Index>(corner);
  EXPECT_EQ(t.twin[Triangulation::Next(h)], Triangulation::Prev(h));
  EXPECT_NEAR(AngleSums(t, delaunay.lengths)[0], AngleSums(mesh.triangulation, mesh.lengths)[0],
              1e-10);
}

TEST(IntrinsicDelaunay, DoesNotDependOnNumbersNorOnScale) {
  std::mt19937 random(5);
  std::normal_distribution<double> height(0, 0.2);
  int flips = 0;
  for (unsigned seed = 1; seed <= 40; ++seed) {
    PolygonSoup soup = *GenerateMesh("flat_delaunay_patch", {150, seed});
    for (Eigen::Vector3d& x : soup.position) x.z() = height(random);
    PreflightReport report;
    const IntrinsicMesh mesh = Intrinsic(*Preflight(soup, &report));
    const Renumbering renumbered = Renumber(mesh.triangulation, seed);
    EdgeLengths lengths = renumbered.Lengths(mesh.triangulation, mesh.lengths);
    lengths.value *= 3.7;
    const IntrinsicTriangulation here = Delaunay(mesh);
    const IntrinsicTriangulation there = Delaunay({renumbered.triangulation, lengths});
    flips += static_cast<int>(here.flips.size());
    EdgeSet moved;
    for (const auto& [u, w] : EdgesOf(here.triangulation)) {
      moved.insert(std::minmax(renumbered.vertex[u], renumbered.vertex[w]));
    }
    EXPECT_EQ(moved, EdgesOf(there.triangulation)) << "seed " << seed;
  }
  EXPECT_GT(flips, 500);
}

TEST(IntrinsicDelaunay, EndsOnCocircularEdgesAndOnExtremeScales) {
  // Every edge of a grid of squares' diagonals is cocircular.
  const IntrinsicMesh grid = testing::LatticeTorus({1, 0}, {0, 1});
  EXPECT_TRUE(Delaunay(grid).flips.empty());
  for (const double scale : {1e-300, 1e300}) {
    IntrinsicMesh torus = testing::LatticeTorus({1, 0}, {23.3, 0.9});
    torus.lengths.value *= scale;
    const IntrinsicTriangulation delaunay = Delaunay(torus);
    EXPECT_EQ(delaunay.flips.size(), 24);
    EXPECT_NEAR(delaunay.lengths.value.minCoeff() / scale, std::hypot(0.3, 0.9), 1e-10);
  }
}

}  // namespace
}  // namespace cirque
