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

PolygonSoup Polygons(std::vector<Eigen::Vector3d> position,
                     const std::vector<std::vector<Index>>& faces) {
  PolygonSoup soup = MakeSoup(std::move(position), {});
  for (const std::vector<Index>& face : faces) {
    soup.corner.insert(soup.corner.end(), face.begin(), face.end());
    soup.first_corner.push_back(static_cast<Index>(soup.corner.size()));
  }
  return soup;
}

const std::vector<Eigen::Vector3d> kCross = {
    {0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, -1, 0}};

TEST(VerifyMapSheets, AnEdgeOfThreeFacesIsOpenAndEveryFanHasItsOwnVertex) {
  // Three sheets at edge (0, 1), side by side in the plane.
  const PolygonSoup pages = MakeSoup(kCross, {{0, 1, 2}, {0, 1, 3}, {0, 1, 4}});
  const auto at = [](double x) { return std::vector<Eigen::Vector2d>{{x, 0}, {x + 1, 0}, {x, 1}}; };
  const auto with = [&](double a, double b, double c) {
    std::vector<Eigen::Vector2d> uv;
    for (const double x : {a, b, c}) {
      for (const Eigen::Vector2d& p : at(x)) uv.push_back(p);
    }
    return WithCornerUv(pages, uv);
  };
  const MapReport apart = Judge(pages, with(0, 2, 4));
  EXPECT_TRUE(apart.valid()) << apart.Verdict();
  EXPECT_FALSE(apart.overlap->overlaps());
  EXPECT_EQ(apart.complex->num_components, 3);
  EXPECT_FALSE(apart.complex->torn());
  // Sheets that lie on each other do, though they are components of their own.
  EXPECT_TRUE(Judge(pages, with(0, 2, 2.5)).overlap->overlaps());
}

TEST(VerifyMapSheets, ComponentsAreOrientedEachByItself) {
  // The second triangle is clockwise in its file and in the plane, seen with the first; by itself it
  // is what it is.
  const PolygonSoup two = MakeSoup(
      {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {5, 0, 0}, {6, 0, 0}, {5, 1, 0}}, {{0, 1, 2}, {3, 5, 4}});
  const MapReport report =
      Judge(two, WithCornerUv(two, {{0, 0}, {1, 0}, {0, 1}, {5, 0}, {6, 0}, {5, 1}}));
  EXPECT_TRUE(report.valid()) << report.Verdict();
  const MapReport mirrored =
      Judge(two, WithCornerUv(two, {{0, 0}, {1, 0}, {0, 1}, {5, 0}, {5, 1}, {6, 0}}));
  EXPECT_THAT(mirrored.orientations->flipped, ElementsAre(1));
}

TEST(VerifyMapSheets, AFinComesOffAClosedSurface) {
  // A tetrahedron with a fin at the edge (0, 1), which has three faces then. The two others stay
  // connected about both of its ends, and meet again: the tetrahedron is closed.
  const PolygonSoup with_fin = MakeSoup({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0.5, -1, -1}},
                                        {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}, {0, 1, 4}});
  std::vector<Eigen::Vector2d> uv;
  for (int f = 0; f < 5; ++f) {
    for (const auto& p : {Eigen::Vector2d(0, 0), Eigen::Vector2d(1, 0), Eigen::Vector2d(0, 1)}) {
      uv.push_back(p + Eigen::Vector2d(3 * f, 0));
    }
  }
  const MapReport report = Judge(with_fin, WithCornerUv(with_fin, uv));
  EXPECT_TRUE(report.valid()) << report.Verdict();
  EXPECT_EQ(report.complex->num_components, 2);
  EXPECT_EQ(report.complex->num_seam_edges, 6);
  EXPECT_EQ(report.angles->num_on_seam, 4);
  EXPECT_EQ(report.num_split, 2);
}

TEST(VerifyMapSetAside, FacesWithoutAreaAndDuplicatesMustCoverNothing) {
  // A square of two triangles, a needle of no area beside it, a face that names a vertex twice, and
  // the first triangle again.
  const PolygonSoup square = MakeSoup({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {2, 0, 0}},
                                      {{0, 1, 2}, {0, 2, 3}, {0, 1, 4}, {1, 1, 2}, {2, 1, 0}});
  std::vector<Eigen::Vector2d> uv = {{0, 0}, {1, 0}, {1, 1}, {0, 0}, {1, 1}, {0, 1}};
  uv.insert(uv.end(), 9, {1, 0});
  const MapReport good = Judge(square, WithCornerUv(square, uv));
  EXPECT_TRUE(good.valid()) << good.Verdict();
  EXPECT_THAT(good.set_aside, ElementsAre(2, 3, 4));
  EXPECT_THAT(ToText(good), HasSubstr("3 faces of IN set aside (2, 3, 4)"));
  uv[12] = {0, 5};  // the duplicate has an area, and lies on the others
  uv[13] = {5, 0};
  EXPECT_FALSE(Judge(square, WithCornerUv(square, uv)).set_aside.size() == 3);
  uv.assign(6, {0, 0});
  uv.insert(uv.end(), 9, {1, 0});
  EXPECT_FALSE(Judge(square, WithCornerUv(square, uv)).valid());  // these two are not set aside
}

TEST(VerifyMapPolygons, AKeyholeMayTouchItselfWhereItDoesInItsFile) {
  const PolygonSoup keyhole = Polygons(
      {{0, 0, 0}, {3, 0, 0}, {3, 3, 0}, {0, 3, 0}, {1, 1, 0}, {2, 1, 0}, {2, 2, 0}, {1, 2, 0}},
      {{0, 1, 2, 3, 0, 4, 7, 6, 5, 4}});
  std::vector<Eigen::Vector2d> uv;
  for (const Index v : keyhole.corner) uv.push_back(keyhole.position[v].head<2>());
  const MapReport closed = Judge(keyhole, WithCornerUv(keyhole, uv));
  EXPECT_TRUE(closed.valid()) << closed.Verdict();
  EXPECT_EQ(closed.complex->num_seam_edges, 0);
  EXPECT_EQ(closed.overlap->num_boundary_loops, 2);
  std::vector<Eigen::Vector2d> opened = uv;  // along the bridge
  opened[4] += Eigen::Vector2d(0, 0.2);
  opened[5] += Eigen::Vector2d(0, 0.2);
  const MapReport slit = Judge(keyhole, WithCornerUv(keyhole, opened));
  EXPECT_TRUE(slit.valid()) << slit.Verdict();
  EXPECT_EQ(slit.complex->num_seam_edges, 1);
  std::vector<Eigen::Vector2d> crossing = uv;  // the hole reaches over the rim
  crossing[7] = {4, 4};
  EXPECT_THAT(Judge(keyhole, WithCornerUv(keyhole, crossing)).orientations->folded, ElementsAre(0));
}

TEST(VerifyMapPolygons, NeedNoDiagonalsOfTheProgram) {
  // A dart, mapped as it is: every fan of it but one folds.
  const PolygonSoup dart =
      Polygons({{0, 0, 0}, {1, 0, 0}, {0.25, 0.25, 0}, {0, 1, 0}}, {{1, 2, 3, 0}});
  std::vector<Eigen::Vector2d> uv;
  for (const Index v : dart.corner) uv.push_back(dart.position[v].head<2>());
  const MapReport report = Judge(dart, WithCornerUv(dart, uv));
  EXPECT_TRUE(report.valid()) << report.Verdict();
  uv = {{0, 0}, {1, 1}, {1, 0}, {0, 1}};  // a bow tie
  EXPECT_THAT(Judge(dart, WithCornerUv(dart, uv)).orientations->folded, ElementsAre(0));
}

TEST(VerifyMapErrors, AnInputThatIsNoSurfaceIsBadInput) {
  const auto message = [](const PolygonSoup& in) {
    return VerifyMap(in, in, {}).status().message();
  };
  const std::vector<Eigen::Vector3d> five = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 1}};
  EXPECT_THAT(message(MakeSoup(five, {{0, 1, 1}})), HasSubstr("no face has an area"));
  EXPECT_THAT(message(MakeSoup(five, {{0, 1, 7}})), HasSubstr("names vertex 7"));
  EXPECT_THAT(message(MakeSoup(five, {})), HasSubstr("no faces"));
  EXPECT_THAT(message(MakeSoup(five, {{0, 1, 2}, {1, 2, 3}, {2, 3, 4}, {3, 4, 0}, {4, 0, 1}})),
              HasSubstr("not orientable"));
}

}  // namespace
}  // namespace cirque::verify
