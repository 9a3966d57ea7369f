// Two arrays give the surface that a file of them would, and what is wrong with them is named.
#include <array>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cirque/mesh/preflight.h"

#include "tests/common/surfaces.h"

namespace cirque {
namespace {

using testing::HasSubstr;

std::vector<std::array<Index, 3>> TrianglesOfSoup(const PolygonSoup& soup) {
  std::vector<std::array<Index, 3>> triangles;
  for (std::size_t c = 0; c < soup.corner.size(); c += 3) {
    triangles.push_back({soup.corner[c], soup.corner[c + 1], soup.corner[c + 2]});
  }
  return triangles;
}

TEST(SurfaceFromTriangles, IsTheSurfaceOfTheSoup) {
  const Surface wanted = GeneratedSurface("torus", 500);
  const auto found = SurfaceFromTriangles(wanted.position, TrianglesOfSoup(TrianglesOf(wanted)));
  ASSERT_TRUE(found.ok()) << found.status().message();
  EXPECT_EQ(found->triangulation.vertex, wanted.triangulation.vertex);
  EXPECT_EQ(found->triangulation.twin, wanted.triangulation.twin);
  EXPECT_EQ(found->position, wanted.position);
}

TEST(SurfaceFromTriangles, KeepsTheWayBackToThePoints) {
  // Point 1 belongs to no triangle, and the second triangle is turned around.
  const auto surface = SurfaceFromTriangles({{0, 0, 0}, {9, 9, 9}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}},
                                            {{0, 2, 3}, {0, 4, 3}});
  ASSERT_TRUE(surface.ok()) << surface.status().message();
  EXPECT_EQ(surface->soup_vertex, (std::vector<Index>{0, 2, 3, 4}));
  EXPECT_EQ(surface->soup_polygon, (std::vector<Index>{0, 1}));
  EXPECT_NE(surface->triangulation.twin, std::vector<Index>(6, kNone));
}

TEST(SurfaceFromTriangles, NamesATriangleWithoutAPoint) {
  for (const Index wrong : {-1, 3}) {
    const Status status =
        SurfaceFromTriangles({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}, {0, wrong, 1}})
            .status();
    EXPECT_EQ(status.code(), StatusCode::kInvalidInput);
    EXPECT_THAT(status.message(), HasSubstr("triangle 1 has a corner " + std::to_string(wrong)));
    EXPECT_THAT(status.message(), HasSubstr("3 points"));
  }
}

TEST(SurfaceFromTriangles, RefusesWhatPreflightRefuses) {
  EXPECT_EQ(SurfaceFromTriangles({}, {}).status().code(), StatusCode::kInvalidInput);
  const Status thrice =
      SurfaceFromTriangles({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}},
                           {{0, 1, 2}, {1, 0, 3}, {0, 1, 4}})
          .status();
  EXPECT_THAT(thrice.message(), HasSubstr("edge"));
}

}  // namespace
}  // namespace cirque
