// Meshes that are no surfaces, and what SurfacesOf makes of them.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cirque/mesh/preflight.h"

#include "tests/mesh/meshes.h"

namespace cirque {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using testing::MakeSoup;
using ::testing::Pair;

struct Repaired {
  std::vector<MeshComponent> components;
  PreflightReport report;
  RepairSummary summary;

  const Surface& surface(std::size_t i) const { return *components[i].surface; }
};

Repaired Repair(const PolygonSoup& soup, const std::string& how = "safe") {
  Repaired repaired;
  auto components = SurfacesOf(soup, *ParseRepair(how), &repaired.report, &repaired.summary);
  EXPECT_TRUE(components.ok()) << components.status().message();
  if (components.ok()) repaired.components = *std::move(components);
  // Whatever was done, every corner of a surface is one of the file, at its place.
  for (const MeshComponent& component : repaired.components) {
    if (!component.surface.ok()) continue;
    const Surface& surface = *component.surface;
    for (Index h = 0; h < surface.triangulation.num_halfedges(); ++h) {
      const Index v = soup.corner[surface.soup_corner[h]];
      EXPECT_LE((surface.position[surface.triangulation.vertex[h]] - soup.position[v]).norm(), 0.1);
    }
  }
  return repaired;
}

std::string Refusal(const PolygonSoup& soup, const std::string& how) {
  PreflightReport report;
  RepairSummary summary;
  const auto components = SurfacesOf(soup, *ParseRepair(how), &report, &summary);
  EXPECT_EQ(components.status().code(), StatusCode::kInvalidInput);
  return components.status().message();
}

/// A unit square of two triangles from (x, y) on, on four vertices of its own.
void AddSquare(double x, double y, PolygonSoup* soup) {
  const auto v = static_cast<Index>(soup->position.size());
  for (const auto& [i, j] : {std::pair(0, 0), {1, 0}, {1, 1}, {0, 1}}) {
    soup->position.emplace_back(x + i, y + j, 0);
  }
  for (const Index k : {0, 1, 2, 0, 2, 3}) soup->corner.push_back(v + k);
  for (int f = 0; f < 2; ++f) soup->first_corner.push_back(soup->first_corner.back() + 3);
}

/// A cube of six quadrilaterals, each on four vertices of its own.
PolygonSoup UnweldedCube() {
  const std::vector<Eigen::Vector3d> corner = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0},
                                               {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}};
  PolygonSoup soup;
  for (const auto& side : std::vector<std::vector<int>>{
           {0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}}) {
    for (const int v : side) {
      soup.corner.push_back(static_cast<Index>(soup.position.size()));
      soup.position.push_back(corner[v]);
    }
    soup.first_corner.push_back(static_cast<Index>(soup.corner.size()));
  }
  return soup;
}

TEST(Repair, ASoundMeshStaysAsItIs) {
  const Repaired repaired = Repair(testing::Tetrahedron());
  ASSERT_EQ(repaired.components.size(), 1u);
  EXPECT_TRUE(repaired.summary.ChangesNothing());
  EXPECT_EQ(repaired.summary.Text(), "");
  EXPECT_EQ(repaired.components[0].num_polygons, 4);
  EXPECT_EQ(repaired.surface(0).triangulation.vertex, testing::Tetrahedron().corner);
}

TEST(Repair, ComponentsComeApartInTheOrderOfTheirFirstFaces) {
  PolygonSoup soup = MakeSoup({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {5, 0, 0}, {6, 0, 0}, {5, 1, 0}},
                              {{3, 4, 5}, {0, 1, 2}});
  const Repaired repaired = Repair(soup, "none");
  ASSERT_EQ(repaired.components.size(), 2u);
  EXPECT_EQ(repaired.components[1].first_polygon, 1);
  EXPECT_THAT(repaired.surface(0).soup_vertex, ElementsAre(3, 4, 5));
  EXPECT_THAT(repaired.surface(1).soup_corner, ElementsAre(3, 4, 5));
  EXPECT_THAT(repaired.surface(1).soup_polygon, ElementsAre(1));
}

TEST(Repair, FansThatMeetInAVertexComeApart) {
  const PolygonSoup bowtie =
      MakeSoup({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {-1, 0, 0}, {-1, -1, 0}}, {{0, 1, 2}, {0, 3, 4}});
  const Repaired repaired = Repair(bowtie);
  ASSERT_EQ(repaired.components.size(), 2u);
  EXPECT_THAT(repaired.summary.split_vertices, ElementsAre(0));
  EXPECT_THAT(repaired.surface(0).soup_vertex, ElementsAre(0, 1, 2));
  // The second fan's copy is numbered behind, and is the file's vertex 0 all the same.
  EXPECT_THAT(repaired.surface(1).soup_vertex, ElementsAre(3, 4, 0));
  EXPECT_THAT(Refusal(bowtie, "none"), HasSubstr("--repair=safe"));
}

TEST(Repair, AWallOnAClosedBoxComesOffAndTheBoxStaysClosed) {
  PolygonSoup soup = testing::Tetrahedron();
  soup.position.emplace_back(9, 9, 9);
  soup.corner.insert(soup.corner.end(), {0, 1, 4});
  soup.first_corner.push_back(15);
  const Repaired repaired = Repair(soup);
  ASSERT_EQ(repaired.components.size(), 2u);
  EXPECT_THAT(repaired.summary.split_edges, ElementsAre(Pair(0, 1)));
  EXPECT_TRUE(BoundaryLoops(repaired.surface(0).triangulation).empty());
  EXPECT_EQ(repaired.surface(0).triangulation.num_vertices, 4);
  EXPECT_EQ(repaired.summary.coincident_edges, 0);  // one edge of the file, not two that coincide
}

TEST(Repair, FacesThatSayNothingAreSetAside) {
  // A square; a face of no area along its side; its first triangle again; a face of two vertices.
  const PolygonSoup soup =
      MakeSoup({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0.5, 0, 0}, {2, 1, 0}},
               {{0, 1, 2}, {0, 4, 1}, {0, 2, 3}, {2, 1, 0}, {2, 2, 5}, {0, 2, 5}});
  const Repaired repaired = Repair(soup);
  EXPECT_THAT(repaired.summary.zero_area_faces, ElementsAre(1));
  EXPECT_THAT(repaired.summary.repeated_vertex_faces, ElementsAre(4));
  EXPECT_THAT(repaired.summary.duplicate_faces, ElementsAre(3));
  EXPECT_EQ(repaired.summary.num_set_aside(), 3);
  EXPECT_THAT(repaired.summary.Text(), HasSubstr("1 face of no area set aside: 2\n"));
}

TEST(Repair, AQuadrilateralWithARepeatedCornerIsATriangle) {
  const Repaired repaired =
      Repair(MakeSoup({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 1, 2}, {2, 1, 1}}));
  ASSERT_EQ(repaired.components.size(), 1u);
  EXPECT_THAT(repaired.surface(0).soup_corner, ElementsAre(0, 1, 3));
  EXPECT_THAT(repaired.summary.repeated_vertex_faces, ElementsAre(1));
}

TEST(Repair, WeldingMakesOneOfCopiesAndSaysSo) {
  const PolygonSoup cube = UnweldedCube();
  const Repaired apart = Repair(cube);
  EXPECT_EQ(apart.components.size(), 6u);
  EXPECT_EQ(apart.summary.coincident_edges, 24);
  EXPECT_THAT(apart.summary.Text(), HasSubstr("--repair=weld"));
  const Repaired welded = Repair(cube, "weld");
  ASSERT_EQ(welded.components.size(), 1u);
  const Surface& surface = welded.surface(0);
  EXPECT_EQ(surface.triangulation.num_vertices, 8);
  EXPECT_TRUE(BoundaryLoops(surface.triangulation).empty());
  EXPECT_EQ(welded.summary.welded_vertices.size(), 16u);
  EXPECT_EQ(welded.summary.coincident_edges, 0);
}

TEST(Repair, ToleranceIsOfTheBoundingBoxAndBoundariesAlone) {
  PolygonSoup soup;
  AddSquare(0, 0, &soup);
  AddSquare(1.01, 0, &soup);
  EXPECT_EQ(Repair(soup, "weld").components.size(), 2u);
  EXPECT_EQ(Repair(soup, "weld:0.001").components.size(), 2u);
  const Repaired welded = Repair(soup, "weld:0.01");
  ASSERT_EQ(welded.components.size(), 1u);
  EXPECT_THAT(welded.summary.welded_vertices, ElementsAre(4, 7));
  // Two apexes that coincide, both inside: they stay two.
  const PolygonSoup fans =
      MakeSoup({{0, 0, 0},
                {1, 0, 1},
                {0, 1, 1},
                {-1, -1, 1},
                {0, 0, 0},
                {1, 0, -1},
                {0, 1, -1},
                {-1, -1, -1}},
               {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {4, 6, 5}, {4, 7, 6}, {4, 5, 7}});
  EXPECT_THAT(Repair(fans, "weld").summary.welded_vertices, IsEmpty());
}

TEST(Repair, TheSidesOfAFaceWithoutAreaAreWeldedToo) {
  const PolygonSoup soup = MakeSoup({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {1, 1, 0}, {0, 1, 0}},
                                    {{0, 1, 2}, {0, 2, 3}, {0, 3, 4}});
  EXPECT_EQ(Repair(soup).components.size(), 2u);
  const Repaired welded = Repair(soup, "weld");
  EXPECT_EQ(welded.components.size(), 1u);
  EXPECT_THAT(welded.summary.zero_area_faces, ElementsAre(1));
  EXPECT_THAT(welded.summary.welded_vertices, ElementsAre(3));
}

TEST(Repair, TJunctionsAreNamedAndLeft) {
  const PolygonSoup soup =
      MakeSoup({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {2, 0, 0}, {2, 1, 0}, {1, 0.25, 0}},
               {{0, 1, 2}, {0, 2, 3}, {1, 4, 6}, {4, 5, 6}, {5, 2, 6}});
  const Repaired repaired = Repair(soup);
  EXPECT_THAT(repaired.summary.t_junctions, ElementsAre(6));
  EXPECT_EQ(repaired.components.size(), 2u);  // they share no edge, and touch in two vertices
}

TEST(Repair, AOneSidedComponentIsRefusedAndTheOthersCome) {
  PolygonSoup soup = testing::Ring(5, true);
  AddSquare(20, 20, &soup);
  const Repaired repaired = Repair(soup);
  ASSERT_EQ(repaired.components.size(), 2u);
  EXPECT_THAT(repaired.components[0].surface.status().message(), HasSubstr("only one side"));
  EXPECT_TRUE(repaired.components[1].surface.ok());
}

TEST(Repair, WhatNothingIsLeftOfIsRefused) {
  for (const char* how : {"safe", "weld"}) {
    EXPECT_THAT(Refusal(MakeSoup({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}, {{0, 1, 2}}), how),
                HasSubstr("no face has an area"));
    EXPECT_THAT(Refusal(PolygonSoup(), how), HasSubstr("no faces"));
  }
}

TEST(ParseRepair, TakesItsWordsAlone) {
  EXPECT_EQ(ParseRepair("weld:1e-5")->tolerance, 1e-5);
  for (const char* wrong :
       {"", "wled", "safe:1", "weld:", "weld:x", "weld:-1", "weld:2", "weld:1e-30"}) {
    EXPECT_EQ(ParseRepair(wrong).status().code(), StatusCode::kInvalidInput) << wrong;
  }
}

}  // namespace
}  // namespace cirque
