#include "cirque/verify/refinement_check.h"

#include <string>
#include <utility>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace cirque::verify {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

/// A square of two triangles.
PolygonSoup Square() {
  PolygonSoup soup;
  soup.position = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  soup.first_corner = {0, 3, 6};
  soup.corner = {0, 1, 2, 0, 2, 3};
  return soup;
}

struct Refined {
  PolygonSoup mesh = Square();
  std::vector<Index> group = {0, 0, 1, 1};

  /// Cut along the other diagonal; point 4 is where they cross.
  Refined() {
    mesh.position.emplace_back(0.5, 0.5, 0);
    mesh.first_corner = {0, 3, 6, 9, 12};
    mesh.corner = {0, 1, 4, 1, 2, 4, 2, 3, 4, 3, 0, 4};
  }

  std::string Errors() const {
    const auto report = CheckRefinement(Square(), mesh, group);
    EXPECT_TRUE(report.ok());
    std::string all;
    for (const std::string& error : report->errors) all += error + "\n";
    return all;
  }
};

TEST(RefinementCheck, SheetsAtAnEdgeOfThreeFacesHavePointsOfTheirOwn) {
  // The first triangle has a point on the diagonal, which the others lack.
  PolygonSoup in = Square(), out = Square();
  out.position.emplace_back(0.5, 0.5, 0);
  out.corner = {0, 1, 4, 1, 2, 4, 0, 2, 3};
  out.first_corner = {0, 3, 6, 9};
  auto report = CheckRefinement(in, out, {0, 0, 1});
  ASSERT_TRUE(report.ok());
  ASSERT_EQ(report->errors.size(), 1u);
  EXPECT_THAT(report->errors[0], HasSubstr("other points from their other side"));
  in.position.emplace_back(0.5, 0.5, 1);
  in.corner.insert(in.corner.end(), {0, 2, 4});
  in.first_corner.push_back(9);
  out.position.insert(out.position.begin() + 4, in.position[4]);
  out.corner = {0, 1, 5, 1, 2, 5, 0, 2, 3, 0, 2, 4};
  out.first_corner.push_back(12);
  report = CheckRefinement(in, out, {0, 0, 1, 2});
  ASSERT_TRUE(report.ok());
  EXPECT_TRUE(report->errors.empty()) << report->errors.front();
}

TEST(RefinementCheck, AcceptsWhatFillsEveryFace) {
  const Refined good;
  EXPECT_EQ(good.Errors(), "");
  const auto report = CheckRefinement(Square(), good.mesh, good.group);
  EXPECT_EQ(report->num_pieces, 4);
  EXPECT_EQ(report->most_pieces, 2);
  EXPECT_EQ(report->area_error, 0);
  EXPECT_THAT(ToText(*report), HasSubstr("4 pieces of 2 faces"));
}

TEST(RefinementCheck, RefusesPlantedErrors) {
  Refined moved;
  moved.mesh.position[2].z() = 1e-9;
  EXPECT_THAT(moved.Errors(), HasSubstr("1 vertices that are not where IN has them (2)"));

  Refined off;
  off.mesh.position[4] = {0.5, 0.6, 0};
  EXPECT_THAT(off.Errors(), HasSubstr("2 faces whose edges have points beside them"));
  EXPECT_THAT(off.Errors(), HasSubstr("2 faces whose pieces have another area"));

  Refined other_group;
  other_group.group = {0, 1, 1, 1};
  EXPECT_THAT(other_group.Errors(), HasSubstr("1 faces whose pieces do not have their border (0)"));
  EXPECT_THAT(other_group.Errors(), HasSubstr("1 faces whose edges have points beside them"));

  Refined missing;
  missing.mesh.first_corner.pop_back();
  missing.mesh.corner.resize(9);
  missing.group.pop_back();
  EXPECT_THAT(missing.Errors(), HasSubstr("1 faces whose pieces do not have their border (1)"));

  Refined torn;  // the diagonal has its point from one side only
  torn.mesh.first_corner = {0, 3, 6, 9};
  torn.mesh.corner = {0, 1, 4, 1, 2, 4, 0, 2, 3};
  torn.group = {0, 0, 1};
  EXPECT_THAT(torn.Errors(), HasSubstr("1 faces whose edges have other points"));

  Refined turned;  // the point beyond the vertex 2 of its edge: one piece is turned over
  turned.mesh.position[4] = {1.5, 1.5, 0};
  EXPECT_THAT(turned.Errors(), HasSubstr("with a piece turned over"));
}

TEST(RefinementCheck, AsksForNoPiecesOfFacesWithoutArea) {
  PolygonSoup in = Square();
  in.first_corner.push_back(9);
  in.corner.insert(in.corner.end(), {0, 1, 1});
  const Refined refined;
  const auto report = CheckRefinement(in, refined.mesh, refined.group);
  EXPECT_THAT(report->errors, testing::IsEmpty());
  EXPECT_THAT(report->set_aside, ElementsAre(2));
}

TEST(RefinementCheck, ReadsTheGroupsOfAnObj) {
  const auto groups = ReadGroups("v 0 0 0\ng face_2\nf 1 2 3\nf 1 3 4\ng face_11\nf 1/1 2/2 3/3\n");
  ASSERT_TRUE(groups.ok());
  EXPECT_THAT(*groups, ElementsAre(1, 1, 10));
  EXPECT_FALSE(ReadGroups("f 1 2 3\n").ok());
  EXPECT_FALSE(ReadGroups("g default\nf 1 2 3\n").ok());
  EXPECT_FALSE(ReadGroups("g face_0\nf 1 2 3\n").ok());
}

TEST(RefinementCheck, ReadsWhereThePointsOfASphereLieOnTheMesh) {
  PolygonSoup mesh = Square();
  mesh.corner_texture = mesh.corner;
  const std::string good = "v 1 0 0\nvt 0 0 0\nvt 1 0 -2.5e-1\nvt 1 1 0\nvt 0 1 0\n";
  const auto points = ReadTextureInSpace(good, mesh);
  ASSERT_TRUE(points.ok()) << points.status().message();
  ASSERT_EQ(points->size(), 4u);
  EXPECT_EQ((*points)[1], Eigen::Vector3d(1, 0, -0.25));
  EXPECT_THAT(ReadTextureInSpace("vt 0 0\n" + good, mesh).status().message(),
              HasSubstr("three numbers"));
  EXPECT_THAT(ReadTextureInSpace("vt 0 0 0\n" + good, mesh).status().message(),
              HasSubstr("5 lines 'vt' for 4 vertices"));
  EXPECT_FALSE(ReadTextureInSpace("vt 0 0 nan\nvt 1 0 0\nvt 1 1 0\nvt 0 1 0\n", mesh).ok());
  std::swap(mesh.corner_texture[0], mesh.corner_texture[1]);
  EXPECT_FALSE(ReadTextureInSpace(good, mesh).ok());
}

TEST(RefinementCheck, RefusesNumbersThatDoNotFit) {
  Refined refined;
  EXPECT_FALSE(CheckRefinement(Square(), refined.mesh, {0, 0}).ok());
  EXPECT_FALSE(CheckRefinement(Square(), refined.mesh, {0, 0, 1, 2}).ok());
  refined.mesh.position.resize(3);
  EXPECT_FALSE(CheckRefinement(Square(), refined.mesh, refined.group).ok());
}

}  // namespace
}  // namespace cirque::verify
