#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cirque/verify/map_check.h"

namespace cirque::verify {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

/// Points of the plane and their faces, the map being the points themselves.
PolygonSoup Flat(const std::vector<Eigen::Vector2d>& points,
                 const std::vector<std::vector<Index>>& faces) {
  PolygonSoup soup;
  for (const Eigen::Vector2d& p : points) soup.position.emplace_back(p.x(), p.y(), 0);
  for (const auto& face : faces) {
    soup.corner.insert(soup.corner.end(), face.begin(), face.end());
    soup.first_corner.push_back(static_cast<Index>(soup.corner.size()));
  }
  soup.texture = points;
  soup.corner_texture = soup.corner;
  return soup;
}

/// The face at one point of the map.
void Collapse(Index face, PolygonSoup* out) {
  for (Index c = out->first_corner[face]; c < out->first_corner[face + 1]; ++c) {
    out->corner_texture[c] = out->corner_texture[out->first_corner[face]];
  }
}

const std::vector<Eigen::Vector2d> kSquare = {{0, 0}, {1, 0}, {1, 1}, {0, 1}, {0.5, 0}};

TEST(VerifyMapRepairs, FacesOfNoAreaAndCopiesAtOnePointAreSetAside) {
  const PolygonSoup in = Flat(kSquare, {{0, 1, 2}, {0, 4, 1}, {0, 2, 3}, {2, 1, 0}, {3, 3, 2}});
  PolygonSoup out = in;
  Collapse(1, &out);
  Collapse(3, &out);
  Collapse(4, &out);
  const auto report = VerifyMap(in, out, {});
  ASSERT_TRUE(report.ok()) << report.status().message();
  EXPECT_TRUE(report->valid()) << report->Verdict();
  EXPECT_THAT(report->set_aside, ElementsAre(1, 3, 4));
  EXPECT_THAT(ToText(*report), HasSubstr("3 faces of IN set aside (1, 3, 4)"));
}

TEST(VerifyMapRepairs, AFaceWithAnAreaIsNeverSetAside) {
  const PolygonSoup in = Flat(kSquare, {{0, 1, 2}, {0, 2, 3}});
  PolygonSoup out = in;
  Collapse(1, &out);
  const auto report = VerifyMap(in, out, {});
  ASSERT_TRUE(report.ok());
  EXPECT_FALSE(report->valid());
  EXPECT_THAT(report->orientations->zero_area, ElementsAre(1));
}

TEST(VerifyMapRepairs, AFaceThatGoesRoundTwiceIsSetAside) {
  const PolygonSoup in = Flat(kSquare, {{0, 1, 2}, {0, 2, 3}, {0, 1, 2, 3, 0, 1, 2, 3}});
  PolygonSoup out = in;
  Collapse(2, &out);
  const auto report = VerifyMap(in, out, {});
  ASSERT_TRUE(report.ok()) << report.status().message();
  EXPECT_TRUE(report->valid()) << report->Verdict();
  EXPECT_THAT(report->set_aside, ElementsAre(2));
}

TEST(VerifyMapRepairs, LoopsThatMeetAtAVertexAndSpursAreSetAsideAndAKeyholeIsNot) {
  const std::vector<Eigen::Vector2d> points = {{0, 0}, {4, 0}, {4, 4}, {0, 4},
                                               {1, 1}, {2, 1}, {1, 2}};
  const PolygonSoup loops = Flat(kSquare, {{0, 1, 2}, {4, 1, 2, 4, 3, 0}, {0, 2, 3, 0, 1}});
  const PolygonSoup with_hole = Flat(points, {{0, 1, 2, 3, 0, 4, 6, 5, 4}});
  PolygonSoup out = loops;
  Collapse(1, &out);
  Collapse(2, &out);
  const auto aside = VerifyMap(loops, out, {});
  ASSERT_TRUE(aside.ok()) << aside.status().message();
  EXPECT_TRUE(aside->valid()) << aside->Verdict();
  EXPECT_THAT(aside->set_aside, ElementsAre(1, 2));
  out = with_hole;
  Collapse(0, &out);
  const auto collapsed = VerifyMap(with_hole, out, {});
  ASSERT_TRUE(collapsed.ok()) << collapsed.status().message();
  EXPECT_FALSE(collapsed->valid());
  EXPECT_TRUE(VerifyMap(with_hole, with_hole, {})->valid());
}

TEST(VerifyMapRepairs, AFlippedFaceBesideOneThatIsSetAsideIsFound) {
  const PolygonSoup in = Flat(kSquare, {{0, 1, 2}, {0, 4, 1}, {0, 2, 3}});
  PolygonSoup out = in;
  Collapse(1, &out);
  out.texture[3] = {2, -1};  // beyond the diagonal
  const auto report = VerifyMap(in, out, {});
  ASSERT_TRUE(report.ok());
  EXPECT_EQ(report->orientations->flipped.size(), 1u);
  EXPECT_FALSE(report->valid());
}

TEST(VerifyMapRepairs, FansAtAVertexAreTakenApart) {
  const PolygonSoup bowtie =
      Flat({{0, 0}, {1, 0}, {1, 1}, {-1, 0}, {-1, -1}}, {{0, 1, 2}, {0, 3, 4}});
  const auto report = VerifyMap(bowtie, bowtie, {});
  ASSERT_TRUE(report.ok()) << report.status().message();
  EXPECT_EQ(report->num_split, 1);
}

TEST(VerifyMapRepairs, SheetsAtAnEdgeOfThreeFacesAreTakenApart) {
  PolygonSoup fin =
      Flat({{0, 0}, {1, 0}, {0.5, 1}, {0.5, -1}, {0.5, 3}}, {{0, 1, 2}, {1, 0, 3}, {0, 1, 4}});
  fin.position[4] = {0.5, 0, 1};
  fin.texture.insert(fin.texture.end(), {{5, 0}, {6, 0}, {5.5, 1}});
  fin.corner_texture = {0, 1, 2, 1, 0, 3, 5, 6, 7};
  const auto report = VerifyMap(fin, fin, {});
  ASSERT_TRUE(report.ok()) << report.status().message();
  EXPECT_TRUE(report->valid()) << report->Verdict();
}

}  // namespace
}  // namespace cirque::verify
