// Small meshes of polygons whose maps are known: flat ones come back as they are, and what can be
// unfolded along its cut is.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "cirque/domains/map_arrays.h"

namespace cirque {
namespace {

constexpr double kIsometric = 1 + 1e-9;

using Points = std::vector<Eigen::Vector3d>;
using Polygons = std::vector<std::vector<std::int64_t>>;

MeshMap MapOf(const Points& points, const Polygons& polygons, const MapOptions& options = {}) {
  PolygonSoup soup;
  soup.position = points;
  for (const auto& polygon : polygons) EXPECT_EQ(AddPolygon(polygon, &soup), "");
  const StatusOr<MeshMap> map = MapSurface(ArraysOf(soup), options);
  EXPECT_TRUE(map.ok()) << map.status().message();
  return map.ok() ? *map : MeshMap();
}

double MeanDistortion(const MeshMap& map) {
  EXPECT_TRUE(map.certificate.distortion.has_value());
  EXPECT_EQ(map.certificate.layout.value_or(LayoutSummary()).flipped_triangles, 0);
  return map.certificate.distortion.value_or(DistortionSummary()).quasi_conformal_mean;
}

/// n points of a circle of radius 1 in a height, counterclockwise.
Points Circle(int n, double height) {
  Points points;
  for (int i = 0; i < n; ++i) {
    points.emplace_back(std::cos(2 * kPi * i / n), std::sin(2 * kPi * i / n), height);
  }
  return points;
}

std::vector<std::int64_t> UpTo(int n) {
  std::vector<std::int64_t> numbers;
  for (int i = 0; i < n; ++i) numbers.push_back(i);
  return numbers;
}

TEST(PolygonsByDefault, FlatOnesComeBackAsTheyAre) {
  const Points square_of_twelve = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0},
                                   {3, 1, 0}, {3, 2, 0}, {3, 3, 0}, {2, 3, 0},
                                   {1, 3, 0}, {0, 3, 0}, {0, 2, 0}, {0, 1, 0}};
  const Points concave = {{1, 0, 0}, {0.25, 0.25, 0}, {0, 1, 0}, {0, 0, 0}};
  const Points angle = {{2, 1, 0}, {1, 1, 0}, {1, 2, 0}, {0, 2, 0}, {0, 0, 0}, {2, 0, 0}};
  for (const Points& points : {Circle(1000, 0), square_of_twelve, concave, angle}) {
    const MeshMap map = MapOf(points, {UpTo(static_cast<int>(points.size()))});
    EXPECT_LT(map.certificate.distortion->quasi_conformal_max, kIsometric) << points.size();
    // A polygon's sides keep their lengths, as all of it does.
    for (std::size_t c = 0; c < points.size(); ++c) {
      const std::size_t next = (c + 1) % points.size();
      EXPECT_NEAR((map.UvOfCorner(c) - map.UvOfCorner(next)).norm(),
                  (points[c] - points[next]).norm(), 1e-9);
    }
  }
}

TEST(PolygonsByDefault, ASquareIsTheRectangleOfModulusOne) {
  MapOptions options;
  options.domain = "rectangle";
  const MeshMap map = MapOf({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {UpTo(4)}, options);
  ASSERT_TRUE(map.certificate.polygon.has_value());
  EXPECT_NEAR(map.certificate.polygon->conformal_modulus.value_or(0), 1, 1e-12);
}

TEST(PolygonsByDefault, ASideHasABackAndTwoQuadrilateralsShareTwoEdges) {
  const Points sheet = {{0, 0, 0}, {2, 0, 0}, {2, 1, 0}, {0, 1, 0}};
  EXPECT_LT(MeanDistortion(MapOf(sheet, {{0, 1, 2, 3}, {0, 2, 1}, {0, 3, 2}})), kIsometric);
  const Points doublet = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0.2}, {0, 1, 0}, {0.35, 0.65, 0.1}};
  EXPECT_LT(MeanDistortion(MapOf(doublet, {{0, 1, 2, 4}, {0, 4, 2, 3}})), 1.1);
}

/// The side of a can as quadrilaterals, and its bottom.
TEST(PolygonsByDefault, ACanUnfoldsAlongItsSeams) {
  constexpr int kSides = 32;
  Points points = Circle(kSides, 0);
  for (const Eigen::Vector3d& x : Circle(kSides, 2)) points.push_back(x);
  Polygons polygons = {UpTo(kSides)};
  std::reverse(polygons.front().begin(), polygons.front().end());
  MapOptions seams;
  for (Index i = 0; i < kSides; ++i) {
    const Index next = (i + 1) % kSides;
    polygons.push_back({i, next, next + kSides, i + kSides});
    if (next != 0) seams.cut.emplace_back(i, next);
  }
  EXPECT_LT(MeanDistortion(MapOf(points, polygons)), 2);  // in one piece it cannot be near 1
  seams.cut.emplace_back(0, kSides);
  EXPECT_LT(MeanDistortion(MapOf(points, polygons, seams)), kIsometric);
}

}  // namespace
}  // namespace cirque
