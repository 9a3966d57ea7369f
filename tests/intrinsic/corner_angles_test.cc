#include <array>
#include <cmath>
#include <random>

#include <boost/multiprecision/cpp_dec_float.hpp>
#include <gtest/gtest.h>

#include "cirque/intrinsic/intrinsic_surface.h"

#include "tests/common/surfaces.h"
#include "tests/mesh/meshes.h"

namespace cirque {
namespace {

using Real = boost::multiprecision::number<boost::multiprecision::cpp_dec_float<50>,
                                           boost::multiprecision::et_off>;

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

TEST(CornerAngles, AgreeWithFiftyDigits) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> coordinate(-1, 1);
  for (int trial = 0; trial < 300; ++trial) {
    // Some triangles are squeezed until they are nearly flat.
    const double squeeze = std::pow(10, -(trial % 6));
    std::array<Eigen::Vector2d, 3> p;
    for (Eigen::Vector2d& x : p)
      x = Eigen::Vector2d(coordinate(random), squeeze * coordinate(random));
    const double side[] = {(p[1] - p[2]).norm(), (p[2] - p[0]).norm(), (p[0] - p[1]).norm()};
    const CornerAngles angles = AnglesOfSides(side[0], side[1], side[2]);
    for (std::size_t k = 0; k < 3; ++k) {
      const Real a(side[k]), b(side[(k + 1) % 3]), c(side[(k + 2) % 3]);
      const Real cosine = (b * b + c * c - a * a) / (2 * b * c);
      const Real exact = acos(cosine);
      EXPECT_LT(static_cast<double>(abs(Real(angles.value[static_cast<Index>(k)]) / exact - 1)),
                2e-15)
          << trial;
    }
  }
}

TEST(CornerAngles, DoNotDependOnNumberingOrScale) {
  const CornerAngles angles = AnglesOfSides(0.7, 1.1, 0.9), turned = AnglesOfSides(1.1, 0.9, 0.7);
  for (int k = 0; k < 3; ++k) EXPECT_EQ(turned.value[k], angles.value[(k + 1) % 3]);
  EXPECT_EQ(AnglesOfSides(0x1p300 * 0.7, 0x1p300 * 1.1, 0x1p300 * 0.9).value, angles.value);
}

TEST(VertexAngleSums, OfPlaneAndSphereObeyGaussBonnet) {
  const Surface patch = GeneratedSurface("flat_delaunay_patch", 400);
  const std::vector<bool> boundary = BoundaryVertices(patch.triangulation);
  const std::vector<double> flat = VertexAngleSums(patch.triangulation, AnglesOf(patch));
  double turned = 0;
  for (Index v = 0; v < patch.triangulation.num_vertices; ++v) {
    if (boundary[v]) turned += kPi - flat[v];
    if (!boundary[v]) {
      EXPECT_NEAR(flat[v], 2 * kPi, 1e-12);
    }
  }
  EXPECT_NEAR(turned, 2 * kPi, 1e-10);
  const Surface blob = GeneratedSurface("blob", 400);
  double curvature = 0;
  for (const double sum : VertexAngleSums(blob.triangulation, AnglesOf(blob))) {
    curvature += 2 * kPi - sum;
  }
  EXPECT_NEAR(curvature, 4 * kPi, 1e-10);
}

}  // namespace
}  // namespace cirque
