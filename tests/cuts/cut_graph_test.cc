// Cuts of every generated surface, with cones anywhere, open it to one disk.
#include "cirque/cuts/cut_graph.h"

#include <algorithm>
#include <limits>
#include <random>
#include <set>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cirque/core/metric.h"
#include "cirque/cuts/shortest_path.h"
#include "cirque/generators/generators.h"

#include "tests/common/surfaces.h"
#include "tests/mesh/meshes.h"

namespace cirque {
namespace {

using ::testing::HasSubstr;

Eigen::VectorXd Lengths(const Surface& surface) { return MeasureEdgeLengths(surface).value; }

double Length(const Cut& cut, const Eigen::VectorXd& lengths) {
  double sum = 0;
  for (std::size_t e = 0; e < cut.edge.size(); ++e) sum += cut.edge[e] ? lengths[e] : 0;
  return sum;
}

Cut NoCut(const Triangulation& t) { return {std::vector<bool>(t.num_edges(), false)}; }

/// The vertices where the cut ends: of one opened edge and not on the boundary.
std::set<Index> LooseEnds(const Triangulation& t, const Cut& cut) {
  std::vector<int> ends(t.num_vertices, 0);
  for (Index e = 0; e < t.num_edges(); ++e) {
    if (!cut.edge[e]) continue;
    ++ends[t.Tail(t.edge_halfedge[e])];
    ++ends[t.Tip(t.edge_halfedge[e])];
  }
  const std::vector<bool> boundary = BoundaryVertices(t);
  std::set<Index> loose;
  for (Index v = 0; v < t.num_vertices; ++v) {
    if (ends[v] == 1 && !boundary[v]) loose.insert(v);
  }
  return loose;
}

/// Everything that CutGraph promises, counted here from scratch.
void ExpectGoodCut(const Triangulation& t, const Cut& cut, const std::vector<Index>& cones) {
  const Triangulation open = CutOpen(t, cut);
  EXPECT_EQ(ConnectedPatches(open).count, 1);
  EXPECT_EQ(EulerCharacteristic(open), 1);
  EXPECT_EQ(BoundaryLoops(open).size(), 1u);
  const Status status = CheckCut(t, cut, cones);
  EXPECT_TRUE(status.ok()) << status.message();
  EXPECT_THAT(std::set<Index>(cones.begin(), cones.end()),
              ::testing::IsSupersetOf(LooseEnds(t, cut)));
}

TEST(CutGraph, OpensEveryGeneratedSurfaceToADiskThroughRandomCones) {
  std::mt19937 random(7);
  for (const std::string& name : MeshGenerators().Names()) {
    const Surface surface = GeneratedSurface(name, 600);
    const Triangulation& t = surface.triangulation;
    for (const int num_cones : {0, 1, 3, 40}) {
      SCOPED_TRACE(::testing::Message() << name << " with " << num_cones << " cones");
      std::vector<Index> cones;
      for (int i = 0; i < num_cones; ++i) cones.push_back(random() % t.num_vertices);
      const StatusOr<Cut> cut = CutGraph(t, Lengths(surface), cones);
      if (EulerCharacteristic(t) == 2 && num_cones < 2) {
        EXPECT_THAT(cut.status().message(), HasSubstr("two cones"));
        continue;
      }
      ASSERT_TRUE(cut.ok()) << cut.status().message();
      ExpectGoodCut(t, *cut, cones);
    }
  }
}

TEST(CutGraph, DiskWithoutConesStaysWhole) {
  const Surface disk = GeneratedSurface("bumpy_terrain", 300);
  const StatusOr<Cut> cut = CutGraph(disk.triangulation, Lengths(disk), {});
  EXPECT_EQ(Length(*cut, Lengths(disk)), 0);
}

TEST(CutGraph, OneConeOfADiskIsJoinedToTheBoundaryByAShortestPath) {
  const Surface disk = GeneratedSurface("flat_delaunay_patch", 500);
  const Triangulation& t = disk.triangulation;
  const std::vector<bool> boundary = BoundaryVertices(t);
  const auto cone = static_cast<Index>(
      std::min_element(disk.position.begin(), disk.position.end(),
                       [](const auto& a, const auto& b) { return a.norm() < b.norm(); }) -
      disk.position.begin());
  const Eigen::VectorXd lengths = Lengths(disk);
  const ShortestPathForest forest = GrowShortestPaths(EdgeGraph(t), lengths, {cone});
  double nearest = 10;
  for (Index v = 0; v < t.num_vertices; ++v) {
    if (boundary[v]) nearest = std::min(nearest, forest.distance[v]);
  }
  EXPECT_GT(nearest, 0.9);  // the middle of [-1, 1]^2
  EXPECT_NEAR(Length(*CutGraph(t, lengths, {cone}), lengths), nearest, 1e-12);
}

TEST(CutGraph, AnnulusIsCutByOneShortPath) {
  const Surface ring = GeneratedSurface("annulus", 2000);
  const Eigen::VectorXd lengths = Lengths(ring);
  const double length = Length(*CutGraph(ring.triangulation, lengths, {}), lengths);
  EXPECT_GE(length, 0.6 - 1e-9);  // between the radii 0.4 and 1
  EXPECT_LT(length, 0.6 * 1.1);
}

TEST(CutGraph, TorusIsCutAlongItsShortGenerators) {
  const Surface torus = GeneratedSurface("torus", 3000);
  const Eigen::VectorXd lengths = Lengths(torus);
  const double length = Length(*CutGraph(torus.triangulation, lengths, {}), lengths);
  // Around the tube and around the hole, at least; paths of edges are somewhat longer than curves.
  const double shortest = 2 * kPi * 0.4 + 2 * kPi * 0.6;
  EXPECT_GT(length, 0.9 * shortest);
  EXPECT_LT(length, 1.5 * shortest);
}

TEST(CutGraph, UnknownConesAreNamed) {
  const Surface disk = GeneratedSurface("hexagonal_fan", 6);
  EXPECT_THAT(CutGraph(disk.triangulation, Lengths(disk), {2, 7, -1}).status().message(),
              HasSubstr("cones at vertices 7, -1 (0-based), but the surface has 7 vertices"));
}

TEST(CompleteCut, OpensWhatAGivenCutLeavesAndKeepsIt) {
  const Surface torus = GeneratedSurface("torus", 600);
  const Triangulation& t = torus.triangulation;
  Cut slit = NoCut(t);
  slit.edge[17] = true;
  const StatusOr<Cut> cut = CompleteCut(t, Lengths(torus), slit, {3});
  ASSERT_TRUE(cut.ok()) << cut.status().message();
  EXPECT_TRUE(cut->edge[17]);
  EXPECT_TRUE(CheckCut(t, *cut, {3}).ok());
  EXPECT_EQ(CompleteCut(t, Lengths(torus), *cut, {3})->edge, cut->edge);
  EXPECT_EQ(CompleteCut(t, Lengths(torus), NoCut(t), {3})->edge,
            CutGraph(t, Lengths(torus), {3})->edge);
}

TEST(CompleteCut, OpensEveryPatchByItself) {
  // A sphere cut in two along the edges round a vertex, with a cone in either half.
  const Surface sphere = GeneratedSurface("sphere", 400);
  const Triangulation& t = sphere.triangulation;
  Cut circle = NoCut(t);
  const Index middle = t.vertex[0];
  for (Index h = 0; h < t.num_halfedges(); ++h)
    circle.edge[t.edge[h]] = circle.edge[t.edge[h]] || t.vertex[h] == middle;
  Index far = 0;
  for (Index v = 0; v < t.num_vertices; ++v) {
    if (sphere.position[v].dot(sphere.position[middle]) <
        sphere.position[far].dot(sphere.position[middle]))
      far = v;
  }
  EXPECT_FALSE(CheckCut(t, circle, {middle, far}).ok());
  const StatusOr<Cut> cut = CompleteCut(t, Lengths(sphere), circle, {middle, far});
  ASSERT_TRUE(cut.ok()) << cut.status().message();
  EXPECT_EQ(ConnectedPatches(CutOpen(t, *cut)).count, 2);
  EXPECT_TRUE(CheckCut(t, *cut, {middle, far}).ok());
}

TEST(CutGraph, NeverOpensAnEdgeOfInfiniteCost) {
  // Quads in pairs of triangles: the torus of 3 x 3, cut without their diagonals.
  const Surface torus = SurfaceOf(testing::Torus());
  const Triangulation& t = torus.triangulation;
  const std::vector<bool> inside = EdgesInsidePolygons(torus);
  Eigen::VectorXd costs = Lengths(torus);
  for (Index e = 0; e < t.num_edges(); ++e) {
    // Diagonals that it would pay to use.
    costs[e] = inside[e] ? std::numeric_limits<double>::infinity() : 1;
  }
  const StatusOr<Cut> cut = CutGraph(t, costs, {0, 4, 8});
  ASSERT_TRUE(cut.ok()) << cut.status().message();
  ExpectGoodCut(t, *cut, {0, 4, 8});
  for (Index e = 0; e < t.num_edges(); ++e) EXPECT_FALSE(inside[e] && cut->edge[e]);
}

TEST(CheckCut, AHandleLeftClosedIsRefused) {
  const Surface torus = GeneratedSurface("torus", 500);
  const Triangulation& t = torus.triangulation;
  EXPECT_THAT(CheckCut(t, NoCut(t), {}).message(), HasSubstr("genus 1, 0 boundary loops"));
  Cut cut = *CutGraph(t, Lengths(torus), {});
  // With the loop at one end of an opened edge closed again, an annulus or a closed slit is left.
  cut.edge[std::find(cut.edge.begin(), cut.edge.end(), true) - cut.edge.begin()] = false;
  const Status status = CheckCut(t, cut, {});
  EXPECT_EQ(status.code(), StatusCode::kInvalidInput);
  EXPECT_THAT(status.message(), HasSubstr("is not a disk: genus 0, 2 boundary loops"));
}

TEST(CheckCut, AConeOffTheCutIsRefusedByName) {
  const Surface disk = GeneratedSurface("flat_delaunay_patch", 300);
  const Triangulation& t = disk.triangulation;
  const std::vector<bool> boundary = BoundaryVertices(t);
  const auto inside =
      static_cast<Index>(std::find(boundary.begin(), boundary.end(), false) - boundary.begin());
  ConeTargets targets = FreeBoundaryTargets(t);
  EXPECT_TRUE(ConeVertices(BoundaryVertices(t), targets).empty());
  targets.lower[inside] = targets.upper[inside] = kPi;
  EXPECT_THAT(ConeVertices(BoundaryVertices(t), targets), ::testing::ElementsAre(inside));
  EXPECT_THAT(CheckCut(t, NoCut(t), {inside}).message(),
              HasSubstr("cones at vertices " + std::to_string(inside) + " (0-based) lie inside"));
  EXPECT_TRUE(CheckCut(t, *CutGraph(t, Lengths(disk), {inside}), {inside}).ok());
}

TEST(CutOpen, WithoutACutNothingChanges) {
  const Surface surface = GeneratedSurface("double_torus", 500);
  const Triangulation& t = surface.triangulation;
  const Triangulation open = CutOpen(t, NoCut(t));
  EXPECT_EQ(open.vertex, t.vertex);
  EXPECT_EQ(open.twin, t.twin);
  EXPECT_EQ(open.edge, t.edge);
}

TEST(CutOpen, EveryEdgeOpenedLeavesLooseTriangles) {
  const Surface surface = GeneratedSurface("sphere", 100);
  const Triangulation& t = surface.triangulation;
  const Triangulation open = CutOpen(t, {std::vector<bool>(t.num_edges(), true)});
  EXPECT_EQ(open.num_vertices, t.num_halfedges());
  EXPECT_EQ(ConnectedPatches(open).count, t.num_faces());
}

TEST(CutOpen, FaceGluedToItself) {
  // A triangle with two sides glued: a disk with a cone of one corner in its middle.
  const Triangulation cone = NumberEdges(2, {0, 1, 1}, {kNone, 2, 1});
  EXPECT_EQ(EulerCharacteristic(cone), 1);
  const Cut cut = *CutGraph(cone, Eigen::VectorXd::Ones(2), {0});
  EXPECT_TRUE(cut.edge[cone.edge[1]]);
  const Triangulation open = CutOpen(cone, cut);
  EXPECT_EQ(open.num_vertices, 3);
  EXPECT_TRUE(CheckCut(cone, cut, {0}).ok());
}

TEST(CutGraph, TorusOfOneVertex) {
  const Triangulation torus = NumberEdges(1, {0, 0, 0, 0, 0, 0}, {3, 4, 5, 0, 1, 2});
  ASSERT_EQ(EulerCharacteristic(torus), 0);
  const Eigen::Vector3d costs(1, 3, 2);
  const Cut cut = *CutGraph(torus, costs, {0});
  ExpectGoodCut(torus, cut, {0});
  EXPECT_EQ(Length(cut, costs), 3);  // the two shortest loops
}

TEST(CutGraph, AnyCostsGiveACut) {
  std::mt19937 random(1);
  const Surface surface = GeneratedSurface("double_torus", 600);
  const Triangulation& t = surface.triangulation;
  for (int trial = 0; trial < 20; ++trial) {
    Eigen::VectorXd costs(t.num_edges());
    for (double& cost : costs) cost = static_cast<double>(random() % 4);  // ties and zeros
    ExpectGoodCut(t, *CutGraph(t, costs, {5, 77}), {5, 77});
  }
}

/// A mesh of the shared folder with its genus and number of boundary loops.
struct SharedMesh {
  const char* name;
  Index genus;
  std::size_t loops;
};

class SharedCuts : public ::testing::TestWithParam<SharedMesh> {};

TEST_P(SharedCuts, AreDisks) {
  const auto mesh = ReadSharedSurface(GetParam().name);
  if (!mesh) GTEST_SKIP() << GetParam().name << " is not there";
  const Triangulation& t = mesh->surface.triangulation;
  EXPECT_EQ(mesh->report.genus, GetParam().genus);
  EXPECT_EQ(BoundaryLoops(t).size(), GetParam().loops);
  for (const std::vector<Index>& cones : {std::vector<Index>{}, {0, 10, 500, 1000, 1500}}) {
    const StatusOr<Cut> cut = CutGraph(t, Lengths(mesh->surface), cones);
    ASSERT_TRUE(cut.ok()) << cut.status().message();
    ExpectGoodCut(t, *cut, cones);
  }
}

INSTANTIATE_TEST_SUITE_P(Shared, SharedCuts,
                         ::testing::Values(SharedMesh{"cgal-cheese", 133, 0},
                                           SharedMesh{"cgal-elephant-with-holes", 3, 106},
                                           SharedMesh{"oded-plane_holes", 0, 27}),
                         [](const auto& suite) {
                           std::string name = suite.param.name;
                           std::erase_if(name, [](char c) { return c == '-' || c == '_'; });
                           return name;
                         });

}  // namespace
}  // namespace cirque
