#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "cirque/mesh/holes.h"
#include "cirque/mesh/preflight.h"

#include "tests/common/surfaces.h"
#include "tests/mesh/meshes.h"

namespace cirque {
namespace {

/// Everything that FillHoles promises of connectivity, by preflight of the result as a soup.
void ExpectFilled(const Surface& input, const FilledSurface& filled, Index loops_left) {
  const Triangulation& before = input.triangulation;
  const Triangulation& after = filled.surface.triangulation;
  const auto loops = static_cast<Index>(BoundaryLoops(before).size());
  EXPECT_EQ(filled.num_filled_loops, loops - loops_left);
  EXPECT_EQ(static_cast<Index>(BoundaryLoops(after).size()), loops_left);
  EXPECT_EQ(EulerCharacteristic(after), EulerCharacteristic(before) + loops - loops_left);
  ASSERT_GE(after.num_faces(), before.num_faces());
  EXPECT_TRUE(std::equal(before.vertex.begin(), before.vertex.end(), after.vertex.begin()));
  EXPECT_TRUE(
      std::equal(input.position.begin(), input.position.end(), filled.surface.position.begin()));

  PolygonSoup soup;
  soup.position = filled.surface.position;
  for (Index h = 0; h < after.num_halfedges(); ++h) {
    soup.corner.push_back(after.vertex[h]);
    if (h % 3 == 2) soup.first_corner.push_back(h + 1);
  }
  PreflightReport report;
  const StatusOr<Surface> checked = Preflight(soup, &report);
  ASSERT_TRUE(checked.ok()) << checked.status().message();
  EXPECT_TRUE(report.reoriented_faces.empty());
  EXPECT_TRUE(report.zero_area_faces.empty());
  EXPECT_EQ(report.boundary_loops, loops_left);
  EXPECT_EQ(checked->triangulation.twin, after.twin);
  for (Index f = 0; f < after.num_faces(); ++f) {
    EXPECT_EQ(filled.surface.soup_polygon[f] == kNone, f >= filled.num_input_faces);
  }
  for (Index h = 0; h < after.num_halfedges(); ++h) {
    EXPECT_EQ(filled.surface.soup_corner[h] == kNone, h >= 3 * filled.num_input_faces);
  }
  for (Index v = 0; v < after.num_vertices; ++v) {
    EXPECT_EQ(filled.surface.soup_vertex[v] == kNone, v >= filled.num_input_vertices);
  }
}

FilledSurface MustFill(const Surface& surface, KeptLoops kept) {
  StatusOr<FilledSurface> filled = FillHoles(surface, kept);
  EXPECT_TRUE(filled.ok()) << filled.status().message();
  return *std::move(filled);
}

TEST(HoleFilling, KeepsTheLongestLoopOrNone) {
  for (const char* name : {"annulus", "catenoid", "bumpy_terrain", "capped_tube"}) {
    SCOPED_TRACE(name);
    const Surface surface = GeneratedSurface(name, 600);
    ExpectFilled(surface, MustFill(surface, KeptLoops::kLongest), 1);
    ExpectFilled(surface, MustFill(surface, KeptLoops::kNoLoop), 0);
  }
  // The annulus keeps its outer circle: the new vertex lies in the middle, and the area is pi.
  const Surface ring = GeneratedSurface("annulus", 600);
  const FilledSurface disk = MustFill(ring, KeptLoops::kLongest);
  ASSERT_EQ(disk.surface.position.size(), ring.position.size() + 1);
  EXPECT_LT(disk.surface.position.back().norm(), 0.1);
  double area = 0;
  const Triangulation& t = disk.surface.triangulation;
  for (Index h = 0; h < t.num_halfedges(); h += 3) {
    const auto at = [&](Index corner) { return disk.surface.position[t.vertex[corner]]; };
    area += (at(h + 1) - at(h)).cross(at(h + 2) - at(h)).z() / 2;
  }
  EXPECT_NEAR(area, kPi, 0.06);
  EXPECT_LT(area, kPi);
}

TEST(HoleFilling, ATriangularHoleTakesOneTriangle) {
  PolygonSoup open = testing::Tetrahedron();
  open.corner.resize(9);
  open.first_corner.resize(4);
  const Surface surface = SurfaceOf(open);
  const FilledSurface filled = MustFill(surface, KeptLoops::kNoLoop);
  EXPECT_EQ(filled.surface.triangulation.num_faces(), 4);
  ExpectFilled(surface, filled, 0);
  EXPECT_EQ(MustFill(surface, KeptLoops::kLongest).num_filled_loops, 0);
}

TEST(HoleFilling, ALoneTriangleIsClosedByALiftedFan) {
  const Surface surface = SurfaceOf(testing::OneTriangle());
  const FilledSurface filled = MustFill(surface, KeptLoops::kNoLoop);
  EXPECT_EQ(filled.surface.triangulation.num_faces(), 4);
  ExpectFilled(surface, filled, 0);
}

TEST(HoleFilling, AHoleWithItsMeanOnAnEdgeIsLifted) {
  // A slit: the square hole of a flat ring pressed so that the mean of its corners lies on an edge.
  std::vector<Eigen::Vector3d> position = {{-4, -4, 0}, {4, -4, 0}, {4, 4, 0},  {-4, 4, 0},
                                           {-1, 0, 0},  {1, 0, 0},  {2, -1, 0}, {-2, 1, 0}};
  // The hole's corners 6, 5, 4, 7 have the mean (0, 0), in the middle of the edge from 5 to 4.
  const PolygonSoup soup = testing::MakeSoup(
      position,
      {{0, 1, 6}, {0, 6, 4}, {0, 4, 7}, {0, 7, 3}, {1, 2, 6}, {2, 5, 6}, {2, 7, 5}, {2, 3, 7}});
  const Surface surface = SurfaceOf(soup);
  ASSERT_EQ(BoundaryLoops(surface.triangulation).size(), 2u);
  ExpectFilled(surface, MustFill(surface, KeptLoops::kLongest), 1);
}

TEST(HoleFilling, TheFillDoesNotAppearInTheOutput) {
  const Surface ring = GeneratedSurface("annulus", 300);
  const FilledSurface disk = MustFill(ring, KeptLoops::kLongest);
  const Triangulation& t = disk.surface.triangulation;
  CornerUv uv;
  for (Index h = 0; h < t.num_halfedges(); ++h) {
    uv.value.emplace_back(disk.surface.position[t.vertex[h]].head<2>());
  }
  const CornerUv kept = WithoutFill(disk, uv);
  ASSERT_EQ(kept.value.size(), ring.triangulation.vertex.size());
  for (std::size_t h = 0; h < kept.value.size(); ++h) EXPECT_EQ(kept.value[h], uv.value[h]);
}

TEST(HoleFilling, ClosesTheHolesOfSharedMeshesSlow) {
  for (const std::string name : {"cgal-elephant-with-holes", "oded-plane_holes", "bff-beetle",
                                 "cgal-holes", "trimesh-featuretype", "bff-inverted_triangles"}) {
    SCOPED_TRACE(name);
    const auto mesh = ReadSharedSurface(name);
    if (!mesh) GTEST_SKIP() << name << " is not there";
    ExpectFilled(mesh->surface, MustFill(mesh->surface, KeptLoops::kLongest), 1);
    ExpectFilled(mesh->surface, MustFill(mesh->surface, KeptLoops::kNoLoop), 0);
  }
}

}  // namespace
}  // namespace cirque
