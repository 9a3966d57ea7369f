#include "cirque/domains/polygon_corners.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cirque/metrics/injectivity.h"

#include "tests/common/domain_maps.h"
#include "tests/common/surfaces.h"

namespace cirque {
namespace {

using ::testing::UnorderedElementsAre;

/// A fan about vertex 0 with its rim 1 .. 6, an ear beyond the edge 1-2, and beyond 3-4 a piece about
/// an inner vertex.
Surface FanWithPieces() {
  std::vector<Eigen::Vector3d> points = {{0, 0, 0}};
  for (int k = 0; k < 6; ++k) {
    points.emplace_back(std::cos(kPi * k / 3), std::sin(kPi * k / 3), 0);
  }
  points.emplace_back(1.6, 1.0, 0);   // 7: an ear on 1-2
  points.emplace_back(-1.3, 1.6, 0);  // 8, 9, 10: a piece on 3-4 about the inner vertex 10
  points.emplace_back(-2.0, 0.5, 0);
  points.emplace_back(-1.3, 0.8, 0);
  std::vector<std::array<Index, 3>> faces;
  for (Index k = 0; k < 6; ++k) faces.push_back({0, 1 + k, 1 + (k + 1) % 6});
  faces.push_back({1, 7, 2});
  faces.push_back({3, 8, 10});
  faces.push_back({8, 9, 10});
  faces.push_back({9, 4, 10});
  faces.push_back({4, 3, 10});
  return *SurfaceFromTriangles(points, faces);
}

TEST(CornersBeyondChords, AreOneInEveryPieceWithOneChord) {
  const std::vector<Index> corners = CornersBeyondChords(FanWithPieces().triangulation);
  EXPECT_EQ(corners.size(), 2u);
  EXPECT_EQ(std::count(corners.begin(), corners.end(), 7), 1);
  EXPECT_EQ(
      std::count(corners.begin(), corners.end(), 8) + std::count(corners.begin(), corners.end(), 9),
      1);
}

TEST(CornersBeyondChords, AreNoneWithoutChords) {
  EXPECT_TRUE(CornersBeyondChords(FlatStrip(4, 2).triangulation).empty());
}

TEST(CornersBeyondChords, OfAStripOfTrianglesAreItsEnds) {
  const Surface strip =
      *SurfaceFromTriangles({{0, 0, 0}, {1, 0, 0}, {0.5, 1, 0}, {1.5, 1, 0}, {2, 0, 0}},
                            {{0, 1, 2}, {1, 3, 2}, {1, 4, 3}});
  EXPECT_THAT(CornersBeyondChords(strip.triangulation), UnorderedElementsAre(0, 4));
}

TEST(RectangleDomain, TakesACornerInEveryPieceThatAChordCutsOff) {
  const Surface surface = FanWithPieces();
  const SurfaceMap map = MustMap(surface, RequestFor("rectangle"));
  EXPECT_TRUE(FlippedFaces(surface.triangulation, map.uv).empty());
  const std::vector<Index>& corners = map.certificate.polygon->corner_vertices;
  for (const Index v : CornersBeyondChords(surface.triangulation)) {
    EXPECT_EQ(std::count(corners.begin(), corners.end(), v), 1);
  }
}

TEST(PolygonDomain, MorePiecesThanCornersAreAProofAtOnce) {
  // A fan of eight with an ear on five edges of its rim.
  std::vector<Eigen::Vector3d> points = {{0, 0, 0}};
  std::vector<std::array<Index, 3>> faces;
  for (Index k = 0; k < 8; ++k) {
    points.emplace_back(std::cos(kPi * k / 4), std::sin(kPi * k / 4), 0);
    faces.push_back({0, 1 + k, 1 + (k + 1) % 8});
  }
  for (Index k = 0; k < 5; ++k) {
    points.emplace_back(1.5 * std::cos(kPi * (k + 0.5) / 4), 1.5 * std::sin(kPi * (k + 0.5) / 4),
                        0);
    faces.push_back({1 + k, 9 + k, 2 + k});
  }
  const Surface surface = *SurfaceFromTriangles(points, faces);
  const Certificate failed = MustFail(surface, RequestFor("polygon"), StatusCode::kInfeasible);
  EXPECT_FALSE(failed.infeasibility.empty());
  DomainOptions five;
  five.sides = 5;
  const SurfaceMap map = MustMap(surface, RequestFor("polygon", five));
  EXPECT_TRUE(FlippedFaces(surface.triangulation, map.uv).empty());
}

}  // namespace
}  // namespace cirque
