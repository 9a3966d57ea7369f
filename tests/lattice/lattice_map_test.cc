#include "cirque/lattice/lattice_map.h"

#include <cmath>
#include <complex>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cirque/mesh/surface.h"
#include "cirque/remesh/lattice_mesh.h"

#include "tests/common/surfaces.h"

namespace cirque {
namespace {

using testing::HasSubstr;

FlatDomain DomainOf(const Surface& surface) {
  return {surface.triangulation, MeasureEdgeLengths(surface)};
}

/// Two flat rectangles back to back: four cones of half a turn each, at the corners.
Surface Pillow(int columns, int rows, double width, double height) {
  const Surface front = FlatStrip(columns, rows);
  PolygonSoup soup = TrianglesOf(front);
  const auto n = static_cast<Index>(front.position.size());
  std::vector<Index> behind(n);
  for (Index v = 0; v < n; ++v) {
    const int i = v % (columns + 1), j = v / (columns + 1);
    behind[v] = v;
    if (i == 0 || i == columns || j == 0 || j == rows) continue;
    behind[v] = static_cast<Index>(soup.position.size());
    soup.position.push_back(front.position[v]);
  }
  for (Index f = 0; f < front.triangulation.num_faces(); ++f) {
    for (const Index k : {2, 1, 0})
      soup.corner.push_back(behind[front.triangulation.vertex[3 * f + k]]);
    soup.first_corner.push_back(soup.first_corner.back() + 3);
  }
  for (Eigen::Vector3d& x : soup.position) x = {x.x() * width / columns, x.y() * height / rows, 0};
  return SurfaceOf(soup);
}

/// Cones at lattice points, and every edge's two sides related by a motion of the lattice.
void ExpectLatticeMap(const FlatDomain& domain, LatticeKind kind, const LatticeMap& map) {
  using Complex = std::complex<double>;
  const Triangulation& t = domain.triangulation();
  const auto at = [&](Index c) { return Complex(map.uv.value[c].x(), map.uv.value[c].y()); };
  for (Index h = 0; h < t.num_halfedges(); ++h) {
    EXPECT_GT(Cross(map.uv.value[3 * (h / 3)], map.uv.value[3 * (h / 3) + 1],
                    map.uv.value[3 * (h / 3) + 2]),
              0);
    if (domain.IsCone(t.vertex[h])) {
      EXPECT_LT((NearestInLattice(kind, map.uv.value[h]) - map.uv.value[h]).norm(), 1e-8);
    }
    const Index twin = t.twin[h];
    const Complex a = at(Triangulation::Next(h)), b = at(Triangulation::Prev(h));
    const Complex a2 = at(Triangulation::Prev(twin)), b2 = at(Triangulation::Next(twin));
    const Complex turn = (b2 - a2) / (b - a);
    EXPECT_LT(std::abs(std::pow(turn, OrderOf(kind)) - 1.), 1e-8);
    const Complex shift = a2 - turn * a;
    EXPECT_LT((NearestInLattice(kind, {shift.real(), shift.imag()}) -
               Eigen::Vector2d(shift.real(), shift.imag()))
                  .norm(),
              1e-7);
  }
}

TEST(LatticeMap, OfAPillowIsTheRectangleOfWholeSides) {
  for (const double cell : {1., 0.5, 0.3}) {
    const Surface pillow = Pillow(6, 4, 6.2, 3.9);
    const FlatDomain domain = DomainOf(pillow);
    const StatusOr<LatticeMap> map = MakeLatticeMap(domain, LatticeKind::kSquares, cell);
    ASSERT_TRUE(map.ok()) << map.status().message();
    ExpectLatticeMap(domain, LatticeKind::kSquares, *map);
  }
}

TEST(LatticeMap, OfRegularPolyhedraHasTheirTriangles) {
  // Cones of 2 pi / 3 three times the fifth part, pi and 4 pi / 3: all of thirds.
  for (const int faces : {4, 8, 20}) {
    const Surface solid = RegularPolyhedron(faces);
    const FlatDomain domain = DomainOf(solid);
    const double edge = MeasureEdgeLengths(solid).value[0];
    for (const int parts : {1, 2, 3}) {
      const StatusOr<LatticeMap> map =
          MakeLatticeMap(domain, LatticeKind::kTriangles, 1.02 * edge / parts);
      ASSERT_TRUE(map.ok()) << faces << " " << map.status().message();
      ExpectLatticeMap(domain, LatticeKind::kTriangles, *map);
      const FlatDomain cells = DomainOf(domain.triangulation(), map->uv);
      EXPECT_NEAR(cells.area(), faces * parts * parts * std::sqrt(3.) / 4, 1e-7)
          << "all edges are of so many cells";
      if (parts == 1) continue;
      const StatusOr<FlatMesh> mesh =
          MakeLatticeMesh(cells, LatticeKind::kTriangles, *map, SolveControl());
      ASSERT_TRUE(mesh.ok()) << faces << " " << parts << " " << mesh.status().message();
      EXPECT_EQ(mesh->num_alive(), faces * parts * parts / 2 + 2);
    }
  }
}

TEST(LatticeMesh, OfAPillowIsItsSquares) {
  const Surface pillow = Pillow(6, 4, 6.2, 3.9);
  const FlatDomain domain = DomainOf(pillow);
  const StatusOr<LatticeMap> map = MakeLatticeMap(domain, LatticeKind::kSquares, 0.5);
  ASSERT_TRUE(map.ok()) << map.status().message();
  const FlatDomain cells = DomainOf(domain.triangulation(), map->uv);
  const StatusOr<FlatMesh> mesh =
      MakeLatticeMesh(cells, LatticeKind::kSquares, *map, SolveControl());
  ASSERT_TRUE(mesh.ok()) << mesh.status().message();
  const auto squares = SquaresOf(*mesh);
  EXPECT_NEAR(cells.area(), static_cast<double>(squares.size()), 1e-7);
  EXPECT_EQ(mesh->num_alive(), static_cast<Index>(squares.size()) + 2);  // Euler, four edges each
  std::vector<int> degree(mesh->num_vertices(), 0);
  for (const auto& square : squares) {
    for (std::size_t k = 0; k < 4; ++k) {
      ++degree[mesh->VertexAt(square[k])];
      EXPECT_NE(mesh->VertexAt(square[k]), mesh->VertexAt(square[(k + 1) % 4]));
    }
  }
  for (Index v = 0; v < mesh->num_vertices(); ++v) {
    if (mesh->vertex(v).IsGone()) continue;
    EXPECT_EQ(degree[v], mesh->vertex(v).kind == FlatMesh::Kind::kCone ? 2 : 4);
  }
}

TEST(LatticeMap, RefusesWhatHasNone) {
  const FlatDomain strip = DomainOf(FlatStrip(4, 4));
  const auto open = MakeLatticeMap(strip, LatticeKind::kSquares, 1);
  ASSERT_FALSE(open.ok());
  EXPECT_EQ(open.status().code(), StatusCode::kInvalidInput);
  EXPECT_THAT(open.status().message(), HasSubstr("boundary"));
  const FlatDomain solid = DomainOf(RegularPolyhedron(20));
  const auto turned = MakeLatticeMap(solid, LatticeKind::kSquares, 0.1);
  ASSERT_FALSE(turned.ok());
  EXPECT_THAT(turned.status().message(), HasSubstr("turns by"));
  const auto coarse = MakeLatticeMap(solid, LatticeKind::kTriangles, 50);
  ASSERT_FALSE(coarse.ok());
  EXPECT_EQ(coarse.status().code(), StatusCode::kNotConverged);
  EXPECT_THAT(coarse.status().message(), HasSubstr("shorter edges"));
}

}  // namespace
}  // namespace cirque
