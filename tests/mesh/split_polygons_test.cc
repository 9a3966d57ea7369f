#include <algorithm>
#include <array>
#include <numeric>
#include <random>
#include <set>

#include <Eigen/Geometry>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cirque/mesh/assembly.h"
#include "cirque/mesh/preflight.h"

#include "tests/common/surfaces.h"
#include "tests/mesh/meshes.h"

namespace cirque {
namespace {

using testing::MakeSoup;

/// n x m quads, their inner points moved at random so that no two diagonals are alike.
PolygonSoup QuadGrid(Index columns, Index rows, double noise) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> shift(-noise, noise);
  std::vector<Eigen::Vector3d> position;
  std::vector<std::vector<Index>> faces;
  for (Index j = 0; j <= rows; ++j) {
    for (Index i = 0; i <= columns; ++i) {
      position.emplace_back(i + shift(random), j + shift(random), shift(random));
    }
  }
  for (Index j = 0; j < rows; ++j) {
    for (Index i = 0; i < columns; ++i) {
      const Index a = j * (columns + 1) + i;
      faces.push_back({a, a + 1, a + columns + 2, a + columns + 1});
    }
  }
  return MakeSoup(std::move(position), faces);
}

using Place = std::array<double, 3>;

/// The diagonals by the places of their ends.
std::set<std::set<Place>> Diagonals(const PolygonSoup& soup) {
  BadFaces bad;
  const TriangleSoup triangles = SplitIntoTriangles(soup, &bad);
  std::set<std::set<Place>> diagonals;
  const auto place = [&](Index h) {
    const Eigen::Vector3d& x = soup.position[triangles.vertex[h]];
    return Place{x.x(), x.y(), x.z()};
  };
  for (Index h = 0; h < static_cast<Index>(triangles.mate.size()); ++h) {
    if (triangles.mate[h] == kNone) continue;
    EXPECT_EQ(triangles.mate[triangles.mate[h]], h);
    diagonals.insert({place(Triangulation::Next(h)), place(Triangulation::Prev(h))});
  }
  return diagonals;
}

/// The same polygons with vertices, faces and first corners in another order.
PolygonSoup Shuffled(const PolygonSoup& soup, unsigned seed) {
  std::mt19937 random(seed);
  std::vector<Index> number(soup.position.size()), order(soup.num_polygons());
  std::iota(number.begin(), number.end(), 0);
  std::iota(order.begin(), order.end(), 0);
  std::shuffle(number.begin(), number.end(), random);
  std::shuffle(order.begin(), order.end(), random);
  std::vector<Eigen::Vector3d> position(number.size());
  for (std::size_t v = 0; v < number.size(); ++v) position[number[v]] = soup.position[v];
  std::vector<std::vector<Index>> faces;
  for (const Index p : order) {
    std::vector<Index>& face = faces.emplace_back();
    for (Index c = soup.first_corner[p]; c < soup.first_corner[p + 1]; ++c) {
      face.push_back(number[soup.corner[c]]);
    }
    std::rotate(face.begin(), face.begin() + random() % face.size(), face.end());
  }
  return MakeSoup(std::move(position), faces);
}

TEST(SplitIntoTriangles, DependsOnTheShapesAndNotOnTheNumbering) {
  for (const double noise : {0.0, 0.3}) {  // squares, and no two quads alike
    const PolygonSoup grid = QuadGrid(7, 5, noise);
    const auto diagonals = Diagonals(grid);
    EXPECT_EQ(diagonals.size(), 35u);
    for (const unsigned seed : {1u, 2u, 3u}) {
      EXPECT_EQ(Diagonals(Shuffled(grid, seed)), diagonals) << noise;
    }
  }
}

TEST(SplitIntoTriangles, AQuadIsCutAlongTheDiagonalWithTheLargerLeastAngle) {
  // A kite: its long diagonal leaves angles of 20 degrees, its short one two good triangles.
  const PolygonSoup kite =
      MakeSoup({{0, 0, 0}, {1, -0.4, 0}, {2, 0, 0}, {1, 0.4, 0}}, {{0, 1, 2, 3}});
  EXPECT_EQ(Diagonals(kite), (std::set<std::set<Place>>{{{1, -0.4, 0}, {1, 0.4, 0}}}));
}

std::vector<Index> Valences(const Surface& surface) {
  return CornersPerVertex(surface.triangulation);
}

// Two quads that share two sides: the vertex between these has but the two.
TEST(RaiseValences, AVertexOfTwoQuadsGetsADiagonal) {
  // Whatever the height of the vertex, and whichever of the four diagonals is the better one.
  for (const double height : {0.0, 0.1, 0.3}) {
    for (const double x : {0.3, 0.4, 0.5, 0.6}) {
      const PolygonSoup doublet =
          MakeSoup({{0, 0, 0}, {1, 0, 0}, {1, 1, 0.2}, {0, 1, 0}, {x, 1 - x, height}},
                   {{0, 1, 2, 4}, {0, 4, 2, 3}});
      const std::vector<Index> valences = Valences(SurfaceOf(doublet));
      EXPECT_GE(valences[4], 3) << x << " " << height;
    }
  }
}

TEST(RaiseValences, CornersOfAGridHaveTwoTrianglesAndNoInnerVertexLessThanFour) {
  const Surface surface = SurfaceOf(QuadGrid(6, 4, 0));
  const std::vector<Index> valences = Valences(surface);
  const std::vector<bool> boundary = BoundaryVertices(surface.triangulation);
  for (Index v = 0; v < static_cast<Index>(valences.size()); ++v) {
    EXPECT_GE(valences[v], boundary[v] ? 2 : 4) << v;
  }
}

/// A square with a square hole as one polygon, which goes round the hole along a bridge.
PolygonSoup Keyhole() {
  return MakeSoup(
      {{0, 0, 0}, {3, 0, 0}, {3, 3, 0}, {0, 3, 0}, {1, 1, 0}, {2, 1, 0}, {2, 2, 0}, {1, 2, 0}},
      {{0, 1, 2, 3, 0, 4, 7, 6, 5, 4}});
}

TEST(Preflight, AKeyholeIsAnAnnulusGluedAlongItsBridge) {
  PreflightReport report;
  const StatusOr<Surface> surface = Preflight(Keyhole(), &report);
  ASSERT_TRUE(surface.ok()) << surface.status().message();
  EXPECT_EQ(report.boundary_loops, 2);
  EXPECT_EQ(surface->triangulation.num_faces(), 8);
  EXPECT_EQ(EulerCharacteristic(surface->triangulation), 0);
  double area = 0;
  for (Index f = 0; f < 8; ++f) {
    const Index* v = &surface->triangulation.vertex[3 * f];
    const Eigen::Vector3d a = surface->position[v[1]] - surface->position[v[0]];
    const Eigen::Vector3d b = surface->position[v[2]] - surface->position[v[0]];
    EXPECT_GT(a.cross(b).z(), 0);
    area += 0.5 * a.cross(b).z();
  }
  EXPECT_DOUBLE_EQ(area, 8);
}

TEST(EdgesInsidePolygons, AreTheDiagonalsAndNotTheBridgeOfAKeyhole) {
  const Surface keyhole = SurfaceOf(Keyhole());
  const std::vector<bool> inside = EdgesInsidePolygons(keyhole);
  EXPECT_EQ(std::count(inside.begin(), inside.end(), true), 7);
  const Triangulation& t = keyhole.triangulation;
  int bridges = 0;
  for (Index e = 0; e < t.num_edges(); ++e) bridges += !inside[e] && !t.IsBoundaryEdge(e);
  EXPECT_EQ(bridges, 1);
  const std::vector<bool> none = EdgesInsidePolygons(RegularPolyhedron(20));
  EXPECT_EQ(std::count(none.begin(), none.end(), true), 0);
}

}  // namespace
}  // namespace cirque
