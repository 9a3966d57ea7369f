#include "cirque/mesh/surface.h"

#include <algorithm>
#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cirque/intrinsic/intrinsic_surface.h"
#include "cirque/metrics/injectivity.h"

#include "tests/common/surfaces.h"
#include "tests/mesh/meshes.h"

namespace cirque {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

TEST(Surface, EdgeLengthsAreEuclideanAtEveryScale) {
  for (const double scale : {1e-200, 1.0, 1e200}) {
    PolygonSoup soup = testing::OneTriangle();
    soup.position = {{0, 0, 0}, {3 * scale, 0, 0}, {3 * scale, 0, 4 * scale}};
    const Surface surface = SurfaceOf(soup);
    const EdgeLengths lengths = MeasureEdgeLengths(surface);
    ASSERT_EQ(lengths.value.size(), 3);
    const auto at = [&](Index h) { return lengths.value[surface.triangulation.edge[h]] / scale; };
    EXPECT_DOUBLE_EQ(at(0), 4);
    EXPECT_DOUBLE_EQ(at(1), 5);
    EXPECT_DOUBLE_EQ(at(2), 3);
  }
}

TEST(Surface, AnglesOfNeedlesAreThoseOfTheirPoints) {
  // Of a height that lengths do not show: sqrt(1 + 1e-22) is 1.
  PolygonSoup soup;
  soup.position = {{0, 0, 0}, {2, 0, 0}, {1, 1e-11, 0}, {1, -1, 0}};
  for (const auto& face : {std::vector<std::int64_t>{0, 1, 2}, {1, 0, 3}}) {
    ASSERT_EQ(AddPolygon(face, &soup), "");
  }
  const Surface surface = SurfaceOf(soup);
  CornerAngles angles = MeasureCornerAngles(surface.triangulation, MeasureEdgeLengths(surface));
  const CornerAngles by_lengths = angles;
  EXPECT_EQ(angles.value[0], 0);
  MeasureNeedles(surface, &angles);
  EXPECT_NEAR(angles.value[0], 1e-11, 1e-24);
  EXPECT_NEAR(angles.value[1], 1e-11, 1e-24);
  EXPECT_NEAR(angles.value[2], kPi - 2e-11, 1e-15);
  for (Index h = 3; h < 6; ++h) EXPECT_EQ(angles.value[h], by_lengths.value[h]);
}

TEST(AttachUv, WritesEachUvOfAVertexOnce) {
  // A strip of two triangles 0-1-2 and 1-3-2 behind an isolated vertex; vertex 2 lies on a seam.
  PolygonSoup input = testing::MakeSoup({{9, 9, 9}, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}},
                                        {{1, 2, 3}, {2, 4, 3}});
  input.texture = {{5, 5}};
  input.corner_texture.assign(6, 0);
  CornerUv uv;
  uv.value = {{0, 0}, {1, 0}, {0, 1}, {1, 0}, {1, 1}, {0.25, 1}};
  const PolygonSoup soup = AttachUv(input, SurfaceOf(input), uv);
  EXPECT_EQ(soup.position, input.position);
  EXPECT_EQ(soup.corner, input.corner);
  EXPECT_THAT(soup.first_corner, ElementsAre(0, 3, 6));
  EXPECT_THAT(soup.texture,
              ElementsAre(Eigen::Vector2d(0, 0), Eigen::Vector2d(1, 0), Eigen::Vector2d(0, 1),
                          Eigen::Vector2d(0.25, 1), Eigen::Vector2d(1, 1)));
  EXPECT_THAT(soup.corner_texture, ElementsAre(0, 1, 2, 1, 4, 3));
}

TEST(AttachUv, EveryCornerGetsItsOwnUvBack) {
  const PolygonSoup input = testing::Torus();
  const Surface surface = SurfaceOf(input);
  CornerUv uv;
  for (Index h = 0; h < surface.triangulation.num_halfedges(); ++h) {
    uv.value.emplace_back(h % 4, surface.triangulation.vertex[h]);
  }
  const PolygonSoup soup = AttachUv(input, surface, uv);
  EXPECT_LE(soup.texture.size(), 4u * 9u);
  for (std::size_t c = 0; c < soup.corner.size(); ++c) {
    EXPECT_EQ(soup.texture[soup.corner_texture[c]], uv.value[c]);
  }
}

/// A quadrilateral and a triangle that runs against it.
PolygonSoup QuadAndTurnedTriangle() {
  return testing::MakeSoup({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {2, 0, 0}},
                           {{0, 1, 2, 3}, {1, 2, 4}});
}

TEST(AttachUv, WritesPolygonsAndTurnedFacesAsTheyStandInTheFile) {
  const PolygonSoup input = QuadAndTurnedTriangle();
  const Surface surface = SurfaceOf(input);
  CornerUv uv;
  for (const Index v : surface.triangulation.vertex) {
    uv.value.emplace_back(surface.position[v].head<2>());
  }
  const PolygonSoup soup = AttachUv(input, surface, uv);
  EXPECT_EQ(soup.first_corner, input.first_corner);
  EXPECT_EQ(soup.corner, input.corner);
  for (std::size_t c = 0; c < soup.corner.size(); ++c) {
    EXPECT_EQ(soup.texture[soup.corner_texture[c]], input.position[input.corner[c]].head<2>());
  }
}

TEST(AttachUv, APolygonWhoseTrianglesCoverEachOtherComesAsItsTriangles) {
  // Between the others, which bend towards the first, is no room for a diagonal.
  std::vector<Eigen::Vector3d> points = {{0, -10, 0}};
  for (int i = 0; i < 6; ++i) {
    const double x = 3 - 1.2 * i;
    points.emplace_back(x, -0.2 * (9 - x * x), 0);
  }
  const PolygonSoup input = testing::MakeSoup(points, {{0, 1, 2, 3, 4, 5, 6}});
  const Surface surface = SurfaceOf(input);
  // All five triangles at one corner, which turn by 5 times the angle.
  const std::vector<Index> corners = CornersPerVertex(surface.triangulation);
  const auto apex = std::max_element(corners.begin(), corners.end()) - corners.begin();
  ASSERT_EQ(corners[apex], 5);
  for (const double angle : {0.3, 1.4}) {
    CornerUv uv;
    for (const Index v : surface.triangulation.vertex) {
      const double step = static_cast<double>((v - apex + 7) % 7);
      const double length = v == apex ? 0 : step;
      uv.value.emplace_back(length * std::cos(angle * step), length * std::sin(angle * step));
    }
    EXPECT_TRUE(FlippedFaces(surface.triangulation, uv).empty());
    EXPECT_EQ(AttachUv(input, surface, uv).num_polygons(), angle < 1 ? 1 : 5);
  }
}

TEST(AttachUv, APolygonTornAlongADiagonalComesAsItsTriangles) {
  const PolygonSoup input = QuadAndTurnedTriangle();
  const Surface surface = SurfaceOf(input);
  CornerUv uv;
  for (Index h = 0; h < surface.triangulation.num_halfedges(); ++h) uv.value.emplace_back(h, 1);
  const PolygonSoup soup = AttachUv(input, surface, uv);
  EXPECT_THAT(soup.first_corner, ElementsAre(0, 3, 6, 9));
  for (Index h = 0; h < 6; ++h) {
    EXPECT_EQ(soup.corner[h], input.corner[surface.soup_corner[h]]);
    EXPECT_EQ(soup.texture[soup.corner_texture[h]], uv.value[h]);
  }
  EXPECT_THAT(std::vector<Index>(soup.corner.begin() + 6, soup.corner.end()), ElementsAre(1, 2, 4));
  // Corner by corner of the input it is one of its triangles' at each.
  const std::vector<Eigen::Vector2d> of_corner = UvOfCorners(input, {{surface, uv}});
  ASSERT_EQ(of_corner.size(), input.corner.size());
  std::vector<bool> seen(of_corner.size(), false);
  for (Index h = 0; h < surface.triangulation.num_halfedges(); ++h) {
    const Index c = surface.soup_corner[h];
    if (of_corner[c] == uv.value[h]) seen[c] = true;
  }
  EXPECT_THAT(seen, ::testing::Each(true));
}

}  // namespace
}  // namespace cirque
