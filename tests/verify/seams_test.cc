#include <cmath>
#include <cstdio>
#include <fstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cirque/verify/seam_check.h"

#include "tests/verify/fixtures.h"

namespace cirque::verify {
namespace {

using ::testing::HasSubstr;

TEST(Seams, SeamsAgreeWhenTheirSidesAreCongruent) {
  PolygonSoup map = Fan(5, kPi / 3);
  const MapReport rigid = Judge(map, map);
  EXPECT_EQ(rigid.complex->num_seam_edges, 1);
  EXPECT_LT(rigid.seams->largest_difference, 1e-15);
  EXPECT_EQ(rigid.complex->num_patches, 1);
  map.texture.back() *= 1.25;
  VerifyOptions options;
  EXPECT_NEAR(Judge(map, map).seams->largest_difference, 0.2, 1e-12);
  EXPECT_TRUE(Judge(map, map).valid());
  options.seams.rigid = true;
  EXPECT_THAT(Judge(map, map, options).Verdict(),
              HasSubstr("the two sides of seam edge (0, 1) of face 0 differ in length by 0.2"));
}

TEST(Seams, PatchesMayHaveTheirOwnScales) {
  const PolygonSoup in = FlatSheet(1);
  const auto halves = [&](double u_scale, double v_scale) {
    std::vector<Eigen::Vector2d> uv;
    for (const Index v : in.corner) uv.emplace_back(in.position[v].head<2>());
    for (int i = 3; i < 6; ++i) uv[i] = {u_scale * uv[i].x() - 20, v_scale * uv[i].y()};
    return WithCornerUv(in, uv);
  };
  const MapReport scaled = Judge(in, halves(3, 3));
  EXPECT_EQ(scaled.complex->num_patches, 2);
  EXPECT_EQ(scaled.Verdict(), "valid (injective), torn: 2 patches of 1 component, 1 seam edge");
  EXPECT_LT(scaled.seams->largest_difference, 1e-14);
}

TEST(Seams, LimitsOfPatchesAndSeamsBind) {
  const PolygonSoup cone = Fan(5, kPi / 3);
  VerifyOptions options;
  options.seams.max_patches = 1;
  options.seams.max_edges = 1;
  EXPECT_TRUE(Judge(cone, cone, options).valid());
  options.seams.max_edges = 0;
  EXPECT_EQ(Judge(cone, cone, options).Verdict(), "INVALID: 1 seam edge, 0 allowed");
  options.seams.max_patches = 0;
  EXPECT_THAT(Judge(cone, cone, options).Verdict(), HasSubstr("1 patch, 0 allowed"));
}

TEST(Seams, TheEdgesAskedForMustBeTheSeamsAndNoOthers) {
  const PolygonSoup cone = Fan(5, kPi / 3);
  VerifyOptions options;
  options.seams.edges = {{1, 0}};
  EXPECT_TRUE(Judge(cone, cone, options).valid());
  options.seams.edges = {{0, 1}, {0, 3}};
  EXPECT_EQ(Judge(cone, cone, options).Verdict(),
            "INVALID: 1 edge that should be a seam is none: 0-3");
  options.seams.edges = std::vector<VertexPair>{};
  EXPECT_EQ(Judge(cone, cone, options).Verdict(),
            "INVALID: 1 seam edge that should not be there: 0-1");
}

// Round a cone of angle 5 pi / 3 the map comes back turned by pi / 3.
TEST(Seams, RotationsAreMeasuredFromMultiplesOfAPartOfTheFullTurn) {
  const PolygonSoup cone = Fan(5, kPi / 3);
  VerifyOptions options;
  for (const int order : {6, 12}) {
    options.seams.rotation_order = order;
    const MapReport report = Judge(cone, cone, options);
    EXPECT_LT(report.seams->largest_rotation_gap, 1e-14);
    EXPECT_TRUE(report.valid());
  }
  options.seams.rotation_order = 4;
  const MapReport report = Judge(cone, cone, options);
  EXPECT_NEAR(report.seams->largest_rotation_gap, kPi / 6, 1e-14);
  EXPECT_THAT(report.Verdict(), HasSubstr("by no multiple of 2 pi / 4: 0.524 rad off"));
}

TEST(Seams, EdgesAreReadFromFilesOfPairsAndOfCuts) {
  const std::string path = testing::TempDir() + "verify_map_edges.txt";
  const auto read = [&](const std::string& content) {
    std::ofstream(path) << content;
    return ReadEdges(path, 5);
  };
  EXPECT_THAT(*read("# a cut\n1 2\n\n 3 5 7 # of face 7\r\n"),
              testing::ElementsAre(VertexPair(0, 1), VertexPair(2, 4)));
  EXPECT_THAT(read("1 2\n1\n").status().message(), HasSubstr(":2: an edge is 'from to'"));
  EXPECT_THAT(read("1 2.5\n").status().message(), HasSubstr(":1: an edge is"));
  EXPECT_THAT(read("1 6\n").status().message(), HasSubstr(":1: no vertex 6; there are 5"));
  EXPECT_THAT(read("0 1\n").status().message(), HasSubstr(":1: no vertex 0"));
  std::remove(path.c_str());
  EXPECT_THAT(ReadEdges(path, 5).status().message(), HasSubstr("cannot be read"));
}

}  // namespace
}  // namespace cirque::verify
