#include "cirque/verify/map_check.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/verify/fixtures.h"

namespace cirque::verify {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::StartsWith;

const char kValid[] = "valid (injective), 1 patch, 0 seam edges";

PolygonSoup GoodMap() { return WithVertexUv(Sheet(4), Flattened(Sheet(4))); }

TEST(VerifyMapErrors, AGoodMapIsValidAndProvenInjective) {
  const MapReport report = Judge(Sheet(4), GoodMap());
  EXPECT_EQ(report.Verdict(), kValid);
  EXPECT_EQ(report.num_triangles, 32);
  EXPECT_EQ(report.overlap->num_boundary_loops, 1);
  EXPECT_EQ(report.overlap->num_boundary_edges, 16);
  EXPECT_EQ(report.angles->num_plain, 9);
  EXPECT_LT(report.angles->largest_plain_deviation, 1e-14);
  EXPECT_THAT(ToText(report),
              testing::EndsWith("verdict: valid (injective), 1 patch, 0 seam edges\n"));
  EXPECT_THAT(ToJson(report), HasSubstr("\"injective\": true"));
}

TEST(VerifyMapErrors, AVertexPulledAcrossItsStarFlipsTriangles) {
  PolygonSoup out = GoodMap();
  out.texture[6] = {2.2, 1.5};  // across the edge (7, 12) only
  const MapReport report = Judge(Sheet(4), out);
  EXPECT_THAT(report.orientations->flipped, ElementsAre(10));
  EXPECT_EQ(report.Verdict(), "INVALID: 1 flipped triangle (10)");
  EXPECT_FALSE(report.overlap.has_value());
  EXPECT_THAT(ToJson(report), HasSubstr("\"injective\": null"));
}

TEST(VerifyMapErrors, AVertexOnItsNeighboursEdgeMakesAZeroAreaTriangle) {
  PolygonSoup out = GoodMap();
  out.texture[6] = {1.5, 1.5};
  EXPECT_EQ(Judge(Sheet(4), out).Verdict(), kValid);
  out.texture[6] = {2, 1.25};
  EXPECT_EQ(Judge(Sheet(4), out).Verdict(), "INVALID: 1 zero-area triangle (10)");
}

TEST(VerifyMapErrors, NotANumberIsNamed) {
  PolygonSoup out = GoodMap();
  out.texture[0].x() = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(Judge(Sheet(4), out).Verdict(),
            "INVALID: 2 triangles with texture coordinates that are not finite (0, 1)");
  out.texture[0].x() = std::numeric_limits<double>::infinity();
  EXPECT_THAT(Judge(Sheet(4), out).Verdict(), HasSubstr("not finite (0, 1)"));
}

TEST(VerifyMapErrors, AMovedVertexIsNamedAndRoundingIsNot) {
  PolygonSoup out = GoodMap();
  out.position[7].z() += 1e-7;
  EXPECT_EQ(Judge(Sheet(4), out).Verdict(), kValid);
  EXPECT_NEAR(Judge(Sheet(4), out).match.displacement.largest, 1e-7 / std::sqrt(34.56), 1e-10);
  out.position[7].z() += 0.01;
  EXPECT_THAT(Judge(Sheet(4), out).Verdict(), StartsWith("INVALID: 1 vertex moved (7)"));
  out.position[7].z() = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THAT(Judge(Sheet(4), out).Verdict(), StartsWith("INVALID: 1 vertex moved (7)"));
}

TEST(VerifyMapErrors, MissingTextureIsNamed) {
  PolygonSoup out = GoodMap();
  out.corner_texture[10] = kNone;
  EXPECT_EQ(Judge(Sheet(4), out).Verdict(), "INVALID: 1 triangle without texture coordinates (3)");
  EXPECT_THAT(Judge(Sheet(4), Sheet(4)).Verdict(),
              HasSubstr("32 triangles without texture coordinates (0, 1, 2,"));
}

TEST(VerifyMapErrors, MissingForeignAndLostVerticesAreNamed) {
  PolygonSoup out = GoodMap();
  out.corner[5 * 3 + 1] = 24;
  EXPECT_EQ(
      Judge(Sheet(4), out).Verdict(),
      "INVALID: 1 triangle of IN missing from OUT (5); 1 triangle of OUT not in IN (numbers of "
      "OUT: 5)");
  out = GoodMap();
  out.first_corner.pop_back();
  out.corner.resize(out.corner.size() - 3);
  out.corner_texture = out.corner;
  EXPECT_EQ(Judge(Sheet(4), out).Verdict(), "INVALID: 1 triangle of IN missing from OUT (31)");
  out = GoodMap();
  out.position.emplace_back(0, 0, 0);  // of no face
  EXPECT_EQ(Judge(Sheet(4), out).Verdict(), kValid);
  out.corner[4] = 25;
  EXPECT_THAT(Judge(Sheet(4), out).Verdict(),
              HasSubstr("by their corners' positions: IN has 25 vertices and OUT 26"));
}

TEST(VerifyMapErrors, AMirroredMapIsCalledMirrored) {
  PolygonSoup out = GoodMap();
  for (Eigen::Vector2d& uv : out.texture) uv.x() = -uv.x();
  const MapReport report = Judge(Sheet(4), out);
  EXPECT_EQ(report.orientations->flipped.size(), 32u);
  EXPECT_THAT(report.Verdict(), HasSubstr("all 32 triangles flipped: the map is mirrored"));
}

TEST(VerifyMapErrors, OrderRotationAndOrientationOfFacesMayDiffer) {
  const PolygonSoup in = Sheet(4);
  PolygonSoup out = GoodMap();
  std::reverse(out.corner.begin() + 6, out.corner.begin() + 9);  // triangle 2, other way round
  std::rotate(out.corner.begin(), out.corner.begin() + 1, out.corner.begin() + 3);
  std::swap_ranges(out.corner.begin() + 12, out.corner.begin() + 15, out.corner.begin() + 30);
  out.corner_texture = out.corner;
  const MapReport report = Judge(in, out);
  EXPECT_EQ(report.Verdict(), kValid);
  EXPECT_FALSE(report.match.faces.same_order);
  EXPECT_THAT(report.match.faces.reversed, ElementsAre(2));
  EXPECT_THAT(report.turned, IsEmpty());
  // The writer repaired what IN had wrong.
  PolygonSoup disoriented = in;
  std::reverse(disoriented.corner.begin() + 6, disoriented.corner.begin() + 9);
  const MapReport repaired = Judge(disoriented, GoodMap());
  EXPECT_EQ(repaired.Verdict(), kValid);
  EXPECT_THAT(repaired.match.faces.reversed, ElementsAre(2));
  EXPECT_THAT(repaired.turned, ElementsAre(2));
}

TEST(VerifyMapErrors, AMirrorImageIsNotHiddenByReversedFaces) {
  PolygonSoup out = GoodMap();
  for (Eigen::Vector2d& uv : out.texture) uv.x() = -uv.x();
  for (Index f = 0; f < out.num_polygons(); ++f) {
    std::reverse(out.corner.begin() + 3 * f, out.corner.begin() + 3 * f + 3);
  }
  out.corner_texture = out.corner;
  const MapReport report = Judge(Sheet(4), out);
  EXPECT_EQ(report.orientations->flipped.size(), 32u);
  EXPECT_THAT(report.Verdict(), HasSubstr("mirrored as a whole"));
  EXPECT_THAT(ToText(report), HasSubstr("32 reversed in OUT"));
  EXPECT_THAT(ToText(report), HasSubstr("judged by IN's orientation"));
}

TEST(VerifyMapErrors, TrianglesThatTurnTwiceRoundAVertexAreCaught) {
  EXPECT_EQ(Judge(Fan(8, kPi / 4), Fan(8, kPi / 4)).Verdict(), kValid);
  const MapReport report = Judge(Fan(8, kPi / 2), Fan(8, kPi / 2));
  EXPECT_TRUE(report.orientations->flipped.empty());
  EXPECT_EQ(report.Verdict(), "INVALID: the triangles do not turn exactly once round 1 vertex (0)");
  EXPECT_NEAR(report.angles->largest_plain_deviation, 2 * kPi, 1e-12);
}

TEST(VerifyMapErrors, AWrongAngleAtAConeIsCaughtByTheTargets) {
  const PolygonSoup out = Fan(5, kPi / 3);
  VerifyOptions options;
  const MapReport free = Judge(out, out, options);
  EXPECT_EQ(free.Verdict(), "valid (injective), 1 patch, 1 seam edge");
  ASSERT_EQ(free.angles->cones.size(), 1u);
  EXPECT_EQ(free.angles->cones[0].vertex, 0);
  EXPECT_NEAR(free.angles->cones[0].angle_sum, 5 * kPi / 3, 1e-14);
  options.targets.at.assign(6, std::nullopt);
  options.targets.at[0] = AngleInterval{5.0 / 3, 5.0 / 3};
  EXPECT_TRUE(Judge(out, out, options).valid());
  options.targets.at[0] = AngleInterval{1.5, 1.7};
  EXPECT_TRUE(Judge(out, out, options).valid());
  options.targets.at[0] = AngleInterval{2, 2};
  EXPECT_THAT(Judge(out, out, options).Verdict(),
              HasSubstr("1 vertex with a wrong angle sum (0): off the target by up to 1.05 rad"));
}

TEST(VerifyMapErrors, NearlyDegenerateTrianglesAreJudgedExactly) {
  // Twice the area is 94906267 * 94906265 - 94906266^2 = -1, which doubles round to 0.
  const PolygonSoup in = MakeSoup({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}});
  const Eigen::Vector2d b(94906267, 94906266), c(94906266, 94906265), o(0, 0);
  ASSERT_EQ(b.x() * c.y() - b.y() * c.x(), 0.0);
  EXPECT_EQ(Judge(in, WithVertexUv(in, {o, c, b})).Verdict(), kValid);
  EXPECT_THAT(Judge(in, WithVertexUv(in, {o, b, c})).Verdict(), HasSubstr("flipped"));
}

TEST(VerifyMapErrors, ANaNAsToleranceDoesNotLetEverythingPass) {
  VerifyOptions options;
  options.angle_tolerance = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(VerifyMap(Sheet(4), GoodMap(), options).status().message(),
            "angle_tolerance = nan: a number >= 0 is needed");
}

TEST(VerifyMapErrors, AnInputThatIsNoSurfaceIsBadInput) {
  const auto message = [](const PolygonSoup& in) {
    return VerifyMap(in, in, {}).status().message();
  };
  const std::vector<Eigen::Vector3d> five = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 1}};
  EXPECT_THAT(message(MakeSoup(five, {{0, 1, 2}, {1, 0, 3}, {0, 1, 4}})),
              HasSubstr("edge (0, 1) has 3 faces"));
  EXPECT_THAT(message(MakeSoup(five, {{0, 1, 2}, {0, 3, 4}})), HasSubstr("vertex 0 joins several"));
  EXPECT_THAT(message(MakeSoup(five, {{0, 1, 1}})), HasSubstr("face 0 has vertex 1 twice"));
  EXPECT_THAT(message(MakeSoup(five, {{0, 1, 7}})), HasSubstr("names vertex 7"));
  EXPECT_THAT(message(MakeSoup(five, {})), HasSubstr("no faces"));
  EXPECT_THAT(message(MakeSoup(five, {{0, 1, 2}, {1, 2, 3}, {2, 3, 4}, {3, 4, 0}, {4, 0, 1}})),
              HasSubstr("not orientable"));
}

}  // namespace
}  // namespace cirque::verify
