#include "cirque/remesh/flat_mesh.h"

#include <algorithm>
#include <random>
#include <vector>

#include <gtest/gtest.h>

#include "cirque/mesh/surface.h"
#include "cirque/remesh/even_triangles.h"

#include "tests/common/surfaces.h"

namespace cirque {
namespace {

FlatDomain DomainOf(const Surface& surface) {
  return {surface.triangulation, MeasureEdgeLengths(surface)};
}

FlatMesh MeshOf(const FlatDomain& domain) {
  return {domain, std::vector<bool>(domain.triangulation().num_vertices, false)};
}

double AreaOf(const FlatMesh& mesh) {
  double area = 0;
  for (Index h = 0; h < mesh.num_halfedges(); h += 3) {
    if (!mesh.IsGone(h)) area += mesh.TwiceArea(h / 3) / 2;
  }
  return area;
}

/// What holds of a mesh after any operation: twins match, triangles are positive and agree across
/// edges, frames lead to where vertices are.
void ExpectSound(const FlatMesh& mesh) {
  for (Index h = 0; h < mesh.num_halfedges(); ++h) {
    if (mesh.IsGone(h)) continue;
    const Index t = mesh.Twin(h);
    EXPECT_GT(mesh.TwiceArea(h / 3), 0);
    ASSERT_FALSE(mesh.vertex(mesh.VertexAt(h)).IsGone());
    if (t == kNone) continue;
    ASSERT_FALSE(mesh.IsGone(t));
    EXPECT_EQ(mesh.Twin(t), h);
    EXPECT_EQ(mesh.Tail(t), mesh.Tip(h));
    EXPECT_EQ(mesh.Tip(t), mesh.Tail(h));
    EXPECT_NEAR(mesh.Length(t), mesh.Length(h), 1e-10);
    const RigidMotion across = mesh.Across(h);
    EXPECT_LT(
        (across(mesh.Position(Triangulation::Next(t))) - mesh.Position(Triangulation::Prev(h)))
            .norm(),
        1e-10);
  }
  for (Index v = 0; v < mesh.num_vertices(); ++v) {
    if (mesh.vertex(v).IsGone()) continue;
    EXPECT_EQ(mesh.VertexAt(mesh.vertex(v).corner), v);
    EXPECT_GE(mesh.domain().Barycentric(mesh.vertex(v).point).minCoeff(), -1e-9);
  }
}

class FlatMeshTest : public testing::TestWithParam<const char*> {
 protected:
  /// A flat torus, a cone surface without boundary, disks with and without bends.
  static Surface Make() {
    const std::string name = GetParam();
    if (name == "octahedron") return RegularPolyhedron(8);
    if (name == "icosahedron") return RegularPolyhedron(20);
    if (name == "strip") return FlatStrip(6, 4);
    return GeneratedSurface(name, 300);
  }
};

TEST_P(FlatMeshTest, IsSoundThroughRandomOperations) {
  const Surface surface = Make();
  const FlatDomain domain = DomainOf(surface);
  FlatMesh mesh = MeshOf(domain);
  ExpectSound(mesh);
  const Index euler = EulerCharacteristic(surface.triangulation);
  std::mt19937 random(7);
  const auto uniform = [&random](double a, double b) {
    return std::uniform_real_distribution<double>(a, b)(random);
  };
  const auto never = [](Index, Index, double) { return false; };
  int done[4] = {0, 0, 0, 0};
  for (int i = 0; i < 3000; ++i) {
    const auto h = static_cast<Index>(uniform(0, 1) * mesh.num_halfedges());
    if (h >= mesh.num_halfedges() || mesh.IsGone(h)) continue;
    const int kind = static_cast<int>(uniform(0, 4));
    if (kind == 0) done[0] += mesh.Flip(h) ? 1 : 0;
    if (kind == 1 && mesh.num_alive() < 800) done[1] += mesh.Split(h) != kNone ? 1 : 0;
    if (kind == 2) done[2] += mesh.Collapse(h, i % 2 == 0, 0.02, never) ? 1 : 0;
    if (kind == 3) {
      const Index v = mesh.VertexAt(h);
      const Eigen::Vector2d step(uniform(-1, 1), uniform(-1, 1));
      const bool moved =
          mesh.Move(v, mesh.vertex(v).point.at + 0.1 * mesh.Length(Triangulation::Next(h)) * step,
                    0.02) ||
          mesh.Slide(v, mesh.vertex(v).distance + 0.1 * step.x() * mesh.Length(h), 0.02);
      done[3] += moved ? 1 : 0;
    }
  }
  for (const int count : done) EXPECT_GT(count, 20);
  ExpectSound(mesh);
  std::vector<Index> kept;
  const Triangulation made = mesh.MakeTriangulation(&kept);
  EXPECT_EQ(EulerCharacteristic(made), euler);
  EXPECT_EQ(BoundaryLoops(made).size(), BoundaryLoops(surface.triangulation).size());
  if (domain.loops().empty()) {
    EXPECT_NEAR(AreaOf(mesh) / domain.area(), 1, 1e-10);
  }
}

TEST_P(FlatMeshTest, DelaunayTrianglesHaveTheMetricsArea) {
  const Surface surface = Make();
  const FlatDomain domain = DomainOf(surface);
  FlatMesh mesh = MeshOf(domain);
  FlipToDelaunay(&mesh);
  ExpectSound(mesh);
  EXPECT_NEAR(AreaOf(mesh) / domain.area(), 1, 1e-10);
}

INSTANTIATE_TEST_SUITE_P(Surfaces, FlatMeshTest,
                         testing::Values("octahedron", "icosahedron", "strip", "torus"));

TEST(FlatMesh, RefusesWhatWouldBeNoTriangulation) {
  const FlatDomain octahedron = DomainOf(RegularPolyhedron(8));
  FlatMesh mesh = MeshOf(octahedron);
  EXPECT_EQ(mesh.num_alive(), 6 + 8) << "a vertex in every face of three cones";
  const auto never = [](Index, Index, double) { return false; };
  for (Index h = 0; h < mesh.num_halfedges(); ++h) {
    if (!mesh.IsGone(h) && mesh.vertex(mesh.Tail(h)).kind == FlatMesh::Kind::kCone) {
      EXPECT_FALSE(mesh.Collapse(h, false, 0, never)) << "a cone stays";
    }
  }
  const FlatDomain tetrahedron = DomainOf(RegularPolyhedron(4));
  FlatMesh small = MeshOf(tetrahedron);
  for (int pass = 0; pass < 5; ++pass) {
    for (Index h = 0; h < small.num_halfedges(); ++h)
      if (!small.IsGone(h)) small.Collapse(h, false, 0, never);
  }
  EXPECT_GE(small.num_alive(), 4);
  ExpectSound(small);
}

}  // namespace
}  // namespace cirque
