#include "cirque/verify/mesh_match.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <random>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cirque/verify/nearest_point.h"

#include "tests/verify/fixtures.h"

namespace cirque::verify {
namespace {

using Eigen::Vector3d;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

/// The map as another program writes it: a vertex for every UV, in an order of its own.
PolygonSoup SplitAtSeams(const PolygonSoup& map, int seed) {
  PolygonSoup split = map;
  std::vector<Index> number(map.texture.size());
  std::iota(number.begin(), number.end(), 0);
  std::mt19937 random(seed);
  std::shuffle(number.begin(), number.end(), random);
  split.position.assign(map.texture.size(), Vector3d::Zero());
  for (std::size_t c = 0; c < map.corner.size(); ++c) {
    const Index uv = map.corner_texture[c];
    split.corner[c] = number[uv];
    split.position[number[uv]] = map.position[map.corner[c]];
    split.texture[number[uv]] = map.texture[uv];
  }
  split.corner_texture = split.corner;
  return split;
}

/// A cone: 6 vertices, of which those of its seam have two UVs each; the mesh names each UV once.
PolygonSoup Cone() {
  PolygonSoup cone = Fan(5, kPi / 3);
  std::vector<Eigen::Vector2d> uv;
  for (Index& t : cone.corner_texture) {
    const Eigen::Vector2d at = cone.texture[t];
    const auto found = std::find(uv.begin(), uv.end(), at);
    t = static_cast<Index>(found - uv.begin());
    if (found == uv.end()) uv.push_back(at);
  }
  cone.texture = uv;
  return cone;
}

TEST(MatchMeshes, VerticesSplitAtSeamsAndRenumberedAreFoundByPosition) {
  const PolygonSoup in = Cone();
  for (int seed = 0; seed < 5; ++seed) {
    const PolygonSoup out = SplitAtSeams(in, seed);
    ASSERT_EQ(out.position.size(), in.position.size() + 1);
    const MapReport report = Judge(in, out);
    EXPECT_EQ(report.Verdict(), Judge(in, in).Verdict());
    EXPECT_TRUE(report.match.by_position);
    EXPECT_EQ(report.angles->cones.front().vertex, 0);
    EXPECT_THAT(ToText(report), HasSubstr("matched by their positions"));
  }
}

TEST(MatchMeshes, FacesInAnyOrderOfRenumberedVerticesKeepTheirUvs) {
  const PolygonSoup in = Sheet(3);
  PolygonSoup map = WithVertexUv(in, Flattened(in));
  map.texture[5] = {1.25, 1.25};  // so that triangles differ
  PolygonSoup out = SplitAtSeams(map, 3);
  std::rotate(out.corner.begin(), out.corner.begin() + 21, out.corner.end());
  out.corner_texture = out.corner;
  const MapReport report = Judge(in, out), expected = Judge(in, map);
  EXPECT_EQ(report.Verdict(), expected.Verdict());
  EXPECT_EQ(report.angles->smallest_angle, expected.angles->smallest_angle);
  std::vector<Eigen::Vector2d> uv = report.complex->uv;
  for (std::size_t h = 0; h < uv.size(); ++h) {
    EXPECT_EQ(uv[h], map.texture[report.complex->mesh().vertex[h]]);
  }
}

TEST(MatchMeshes, ACopyOfAnotherSizeElsewhereIsAcceptedAndSaid) {
  const PolygonSoup in = Sheet(3);
  for (const double scale : {0.001, 7.0}) {
    PolygonSoup out = WithVertexUv(in, Flattened(in));
    for (Vector3d& p : out.position) p = scale * p + Vector3d(1, -2, 30);
    const MapReport report = Judge(in, out);
    EXPECT_TRUE(report.valid()) << report.Verdict();
    EXPECT_NEAR(report.match.scale, scale, 1e-12 * scale);
    EXPECT_NEAR((report.match.shift - Vector3d(1, -2, 30)).norm(), 0, 1e-10);
    EXPECT_THAT(ToText(report), HasSubstr("OUT is IN times"));
    out.position[5].z() += 0.1 * scale;
    EXPECT_FALSE(Judge(in, out).valid());
    for (Vector3d& p : out.position) p.x() *= 2;  // no uniform scale
    EXPECT_FALSE(Judge(in, out).valid());
  }
}

TEST(MatchMeshes, AVertexAtAnothersPlaceIsNotFoundThere) {
  const PolygonSoup in = Sheet(3);
  PolygonSoup out = WithVertexUv(in, Flattened(in));
  std::swap(out.position[5], out.position[10]);
  EXPECT_THAT(Judge(in, out).Verdict(), HasSubstr("2 vertices moved (5, 10)"));
}

TEST(ComparePositions, IsRelativeToTheBoundingBoxWhateverItsSize) {
  for (const double scale : {1e-160, 1.0, 1e160}) {
    PolygonSoup in = MakeSoup({{0, 0, 0}, {3, 0, 0}, {0, 4, 0}}, {{0, 1, 2}});
    for (Vector3d& p : in.position) p *= scale;
    std::vector<Vector3d> out = in.position;
    out[1].z() += 0.05 * scale;  // of the diagonal 5
    EXPECT_NEAR(ComparePositions(in, out, 0.02).largest, 0.01, 1e-12) << scale;
    EXPECT_THAT(ComparePositions(in, out, 0.02).moved, IsEmpty()) << scale;
    EXPECT_THAT(ComparePositions(in, out, 0.005).moved, ElementsAre(1)) << scale;
  }
}

// A vertex of no face, far away, would make the bounding box large and everything near.
TEST(ComparePositions, VerticesWithoutAFaceNeitherLoosenTheToleranceNorCount) {
  PolygonSoup in = MakeSoup({{0, 0, 0}, {3, 0, 0}, {0, 4, 0}, {1e9, 0, 0}}, {{0, 1, 2}});
  std::vector<Vector3d> out = in.position;
  out[1].z() += 0.05;
  EXPECT_THAT(ComparePositions(in, out, 0.005).moved, ElementsAre(1));
  out = in.position;
  out[3].x() = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THAT(ComparePositions(in, out, 0.005).moved, IsEmpty());
}

TEST(ComparePositions, APointThatIsNotFiniteHasMoved) {
  const PolygonSoup in = MakeSoup({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}});
  for (const double bad : {std::numeric_limits<double>::quiet_NaN(), HUGE_VAL}) {
    std::vector<Vector3d> out = in.position;
    out[0].y() = bad;
    EXPECT_THAT(ComparePositions(in, out, 1e9).moved, ElementsAre(0));
  }
}

TEST(NearestPoint, IsTheNearestOfAll) {
  std::mt19937 random(8);
  std::uniform_real_distribution<double> coordinate(-1, 1);
  const auto point = [&] {
    return Vector3d(coordinate(random), coordinate(random), coordinate(random));
  };
  std::vector<Vector3d> points;
  for (int i = 0; i < 200; ++i) points.push_back(i % 2 == 0 ? point() : Vector3d(1e-9 * point()));
  std::vector<Index> even;
  for (Index i = 0; i < 200; i += 2) even.push_back(i);
  const NearestPoint nearest(points, even);
  for (int trial = 0; trial < 200; ++trial) {
    const Vector3d p = trial < 100 ? point() : points[2 * (trial - 100)];
    const Index best = *std::min_element(even.begin(), even.end(), [&](Index a, Index b) {
      return (points[a] - p).squaredNorm() < (points[b] - p).squaredNorm();
    });
    EXPECT_EQ(nearest.To(p), best);
  }
  EXPECT_EQ(NearestPoint(points, {}).To(points[0]), kNone);
}

}  // namespace
}  // namespace cirque::verify
