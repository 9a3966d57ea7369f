// Maps of surfaces that are their own mirror images.
#include "cirque/domains/map_mirrored.h"

#include <cmath>
#include <complex>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cirque/math/similarity.h"
#include "cirque/metrics/injectivity.h"

#include "tests/common/domain_maps.h"
#include "tests/common/surfaces.h"

namespace cirque {
namespace {

using Complex = std::complex<double>;
using ::testing::HasSubstr;

MapRequest Symmetric() {
  DomainOptions shape;
  shape.symmetric = true;
  return RequestFor("plane", shape);
}

/// Symmetric about x = 6 and about nothing else.
Surface Saddle() {
  return Moved(FlatStrip(12, 8), [](const Eigen::Vector3d& x) {
    const double from = std::abs(x.x() - 6);
    return Eigen::Vector3d(x.x(), x.y(),
                           0.08 * from * from - 0.05 * x.y() * from + std::sin(0.5 * x.y()));
  });
}

TEST(MapMirrored, VerticesLieWhereTheirMirrorImagesDoMirrored) {
  const Surface saddle = Saddle();
  const SurfaceMap map = MustMap(saddle, Symmetric());
  EXPECT_TRUE(FlippedFaces(saddle.triangulation, map.uv).empty());
  EXPECT_EQ(map.certificate.overlap, "injective");
  EXPECT_EQ(map.certificate.mirror->on_axis, 9);
  EXPECT_EQ(map.certificate.mirror->across_axis, 0);
  const std::vector<Complex> place = PlacesOf(saddle, map);
  for (int j = 0; j <= 8; ++j) {
    for (int i = 0; i <= 12; ++i) {
      const Complex here = place[13 * j + i], there = place[13 * j + 12 - i];
      EXPECT_EQ(there, -std::conj(here));
      if (i < 6) {
        EXPECT_GT(std::abs(here.real()), 0.1);
      }
    }
  }
}

TEST(MapMirrored, IsTheMapOfTheWholeButForRounding) {
  const Surface saddle = Saddle();
  MapRequest whole;
  whole.options.refine_map = "none";
  MapRequest symmetric = Symmetric();
  symmetric.options.refine_map = "none";
  const std::vector<Complex> expected = PlacesOf(saddle, MustMap(saddle, whole));
  const std::vector<Complex> found = PlacesOf(saddle, MustMap(saddle, symmetric));
  const Similarity similarity = *NearestSimilarity(found, expected);
  // Both keep the surface's area.
  EXPECT_NEAR(std::abs(similarity.factor), 1, 1e-3);
  double farthest = 0;
  for (std::size_t v = 0; v < found.size(); ++v) {
    farthest = std::max(farthest, std::abs(similarity(found[v]) - expected[v]));
  }
  EXPECT_LT(farthest, 1e-2);  // of a surface 12 wide
}

TEST(MapMirrored, AnAxisThroughFacesIsNoHindrance) {
  const Surface fan = Fan(5, 0.4);
  const SurfaceMap map = MustMap(fan, Symmetric());
  EXPECT_EQ(map.certificate.mirror->across_axis, 1);
  EXPECT_EQ(map.certificate.mirror->on_axis, 2);
  EXPECT_TRUE(FlippedFaces(fan.triangulation, map.uv).empty());
  int paired = 0;
  const std::vector<Complex> place = PlacesOf(fan, map);
  for (const Complex a : place) {
    for (const Complex b : place) paired += b == -std::conj(a);
  }
  EXPECT_EQ(paired, 6);
}

/// Quads whose middle column lies across the axis.
TEST(MapMirrored, QuadsAcrossTheAxisAreHalved) {
  PolygonSoup soup;
  for (int j = 0; j <= 4; ++j) {
    for (int i = 0; i <= 5; ++i) soup.position.emplace_back(i, j, 0.1 * j * (i - 2.5) * (i - 2.5));
  }
  for (int j = 0; j < 4; ++j) {
    for (int i = 0; i < 5; ++i) {
      for (const int v : {6 * j + i, 6 * j + i + 1, 6 * j + i + 7, 6 * j + i + 6}) {
        soup.corner.push_back(v);
      }
      soup.first_corner.push_back(static_cast<Index>(soup.corner.size()));
    }
  }
  const Surface grid = SurfaceOf(soup);
  const SurfaceMap map = MustMap(grid, Symmetric());
  EXPECT_EQ(map.certificate.mirror->across_axis, 5);
  EXPECT_EQ(map.certificate.mirror->on_axis, 0);
  EXPECT_TRUE(FlippedFaces(grid.triangulation, map.uv).empty());
  const std::vector<Complex> place = PlacesOf(grid, map);
  for (Index j = 0; j <= 4; ++j) {
    for (Index i = 0; i <= 5; ++i) {
      EXPECT_EQ(place[6 * j + 5 - i], -std::conj(place[6 * j + i]));
    }
  }
}

TEST(MapMirrored, RefusesWhatIsNotSymmetric) {
  const auto message = [](const Surface& surface, const MapRequest& request) {
    return MustFail(surface, request, StatusCode::kInvalidInput).message;
  };
  EXPECT_THAT(message(GeneratedSurface("bumpy_terrain", 200), Symmetric()),
              HasSubstr("no mirror image of the mesh is the mesh itself"));
  EXPECT_THAT(message(GeneratedSurface("blob", 200), Symmetric()), HasSubstr("disk"));
  MapRequest request = Symmetric();
  request.options.cones = "greedy";
  EXPECT_THAT(message(Saddle(), request), HasSubstr("takes no cones"));
  request = Symmetric();
  request.domain = "disk";
  EXPECT_THAT(message(Saddle(), request), HasSubstr("the domain disk takes no symmetric"));
}

}  // namespace
}  // namespace cirque
