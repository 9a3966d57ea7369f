#include "cirque/mesh/surface.h"

#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cirque/intrinsic/corner_angles.h"

#include "tests/common/surfaces.h"
#include "tests/mesh/meshes.h"

namespace cirque {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

/// One triangle of these sides; side k lies opposite corner k.
CornerAngles AnglesOfSides(double a, double b, double c) {
  const Surface surface = SurfaceOf(testing::OneTriangle());
  EdgeLengths lengths;
  lengths.value.resize(3);
  for (int k = 0; k < 3; ++k) {
    lengths.value[surface.triangulation.edge[k]] = k == 0 ? a : (k == 1 ? b : c);
  }
  return MeasureCornerAngles(surface.triangulation, lengths);
}

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

TEST(CornerAngles, AreThoseOfKnownTriangles) {
  const CornerAngles equilateral = AnglesOfSides(2, 2, 2);
  for (int k = 0; k < 3; ++k) EXPECT_DOUBLE_EQ(equilateral.value[k], kPi / 3);
  const CornerAngles right = AnglesOfSides(3, 5, 4);
  EXPECT_DOUBLE_EQ(right.value[0], std::atan2(3, 4));
  EXPECT_DOUBLE_EQ(right.value[1], kPi / 2);
  EXPECT_DOUBLE_EQ(right.value[2], std::atan2(4, 3));
}

TEST(CornerAngles, AreAccurateForNeedlesAtEveryScale) {
  for (const double scale : {0x1p-900, 1.0, 0x1p900}) {
    // Two equal sides and a short one: 2 asin(c / 2a) at the tip, where c/a is tiny.
    const CornerAngles needle = AnglesOfSides(scale, scale, 1e-12 * scale);
    EXPECT_NEAR(needle.value[2], 1e-12, 1e-27);
    EXPECT_DOUBLE_EQ(needle.value[0], kPi / 2 - 5e-13);
    // Almost flat: sides 1, 1, 2 - d with exactly representable d; the angle at the top is
    // pi - 2 acos(1 - d/2), and acos(1 - x) = sqrt(2 x) (1 + x / 12 + ...).
    const double d = 0x1p-40;
    const CornerAngles flat = AnglesOfSides(scale, scale, (2 - d) * scale);
    EXPECT_NEAR(flat.value[0] / (std::sqrt(d) * (1 + d / 24)), 1, 1e-15);
    EXPECT_DOUBLE_EQ(flat.value[0], flat.value[1]);
    EXPECT_DOUBLE_EQ(flat.value[2], kPi - 2 * flat.value[0]);
  }
}

TEST(CornerAngles, WithoutTheTriangleInequalityTheLongestEdgeFacesPi) {
  const auto expect_flat = [](const CornerAngles& angles) {
    EXPECT_EQ(angles.value, Eigen::Vector3d(0, kPi, 0));
  };
  expect_flat(AnglesOfSides(1, 3, 1.5));
  expect_flat(AnglesOfSides(1, 2, 1));  // equality: no triangle either
  expect_flat(AnglesOfSides(0, 1, 0));
}

TEST(CornerAngles, OfAClosedSurfaceSumToPiAFace) {
  const Surface surface = SurfaceOf(testing::Torus());
  const CornerAngles angles =
      MeasureCornerAngles(surface.triangulation, MeasureEdgeLengths(surface));
  double least = kPi;
  for (Index h = 0; h < angles.value.size(); h += 3) {
    EXPECT_NEAR(angles.value.segment<3>(h).sum(), kPi, 1e-15 * 8);
    least = std::min(least, angles.value.segment<3>(h).minCoeff());
  }
  EXPECT_GT(least, 0.1);
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

}  // namespace
}  // namespace cirque
