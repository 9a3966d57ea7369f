// What the options as they are by default make of surfaces that were mapped badly once.
#include <cstdint>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "cirque/mesh/surface.h"
#include "cirque/metrics/injectivity.h"

#include "tests/common/domain_maps.h"
#include "tests/common/surfaces.h"

namespace cirque {
namespace {

DistortionSummary DistortionByDefault(const Surface& surface, const std::string& domain) {
  const SurfaceMap map = MustMap(surface, RequestFor(domain));
  EXPECT_TRUE(FlippedFaces(surface.triangulation, map.uv).empty());
  return map.certificate.distortion.value_or(DistortionSummary());
}

/// An icosahedron's faces split into 64 on the sphere, one face taken out.
Surface SphereWithoutATriangle() {
  PolygonSoup soup = TrianglesOf(RegularPolyhedron(20));
  for (int i = 0; i < 3; ++i) {
    soup = MidpointSubdivision(soup, 1);
    for (Eigen::Vector3d& x : soup.position) x.normalize();
  }
  soup.first_corner.pop_back();
  soup.corner.resize(soup.corner.size() - 3);
  return SurfaceOf(soup);
}

TEST(DefaultQuality, ASphereOfAlmostNoHole) {
  const DistortionSummary distortion = DistortionByDefault(SphereWithoutATriangle(), "plane");
  EXPECT_GT(distortion.quasi_conformal_mean, 1);
  EXPECT_LT(distortion.quasi_conformal_mean, 1.2);
  EXPECT_LT(distortion.quasi_conformal_max, 20);
}

/// Two of its corners have one triangle, which lies with all three vertices on the circle.
TEST(DefaultQuality, ASquareOfEightTrianglesOnTheDisk) {
  std::vector<Eigen::Vector3d> points;
  std::vector<std::vector<std::int64_t>> triangles;
  for (int j = 0; j < 3; ++j) {
    for (int i = 0; i < 3; ++i) points.emplace_back(0.5 * i, 0.5 * j, 0);
  }
  for (const std::int64_t corner : {0, 1, 3, 4}) {
    triangles.push_back({corner, corner + 1, corner + 4});
    triangles.push_back({corner, corner + 4, corner + 3});
  }
  PolygonSoup soup;
  soup.position = points;
  for (const auto& triangle : triangles) ASSERT_EQ(AddPolygon(triangle, &soup), "");
  const DistortionSummary distortion = DistortionByDefault(SurfaceOf(soup), "disk");
  EXPECT_GT(distortion.quasi_conformal_mean, 1);
  EXPECT_LT(distortion.quasi_conformal_mean, 3.5);
  EXPECT_LT(distortion.quasi_conformal_max, 10);
}

}  // namespace
}  // namespace cirque
