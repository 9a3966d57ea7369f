#include <cmath>
#include <cstdio>
#include <fstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "experiments/verify_map/verify.h"
#include "tests/experiments/verify_map_fixtures.h"

namespace cirque::verify_map {
namespace {

using ::testing::HasSubstr;

PolygonSoup FlatSheet(int n) {
  PolygonSoup mesh = Sheet(n);
  for (Eigen::Vector3d& p : mesh.position) p.z() = 0;
  return mesh;
}

TEST(VerifyMapMeasures, AnAffineMapHasItsSingularValuesRatioEverywhere) {
  const PolygonSoup in = FlatSheet(3);
  std::vector<Eigen::Vector2d> uv = Flattened(in);
  Eigen::Matrix2d turn, stretch;
  turn << std::cos(0.7), -std::sin(0.7), std::sin(0.7), std::cos(0.7);
  stretch << 6, 0, 0, 1.5;
  for (Eigen::Vector2d& p : uv) p = turn * stretch * turn * p + Eigen::Vector2d(5, -8);
  const MapMeasures m = *Judge(in, WithVertexUv(in, uv)).measures;
  for (const char* name : {"quasi_conformal_mean", "quasi_conformal_p50", "quasi_conformal_max"}) {
    EXPECT_NEAR(m.ValueOf(name), 4, 1e-12) << name;
  }
  for (const char* name : {"log_area_ratio_min", "log_area_ratio_max", "log_area_ratio_l2"}) {
    EXPECT_NEAR(m.ValueOf(name), 0, 1e-12) << name;
  }
}

TEST(VerifyMapMeasures, TheWorstTriangleAndSeamsAreFound) {
  // The second triangle is stretched fourfold in the plane; then the two halves are torn apart.
  const PolygonSoup in = MakeSoup(
      {{0, 0, 0}, {3, 0, 0}, {0, 6, 0}, {0, 0, 5}, {1, 0, 5}, {0, 2, 5}}, {{0, 1, 2}, {3, 4, 5}});
  const PolygonSoup out = WithVertexUv(in, {{0, 0}, {3, 0}, {0, 6}, {10, 0}, {14, 0}, {10, 2}});
  EXPECT_EQ(WorstTriangle(*Judge(in, out).measures), 1);
  const PolygonSoup sheet = FlatSheet(1);
  std::vector<Eigen::Vector2d> uv;
  for (const Index v : sheet.corner) uv.emplace_back(sheet.position[v].head<2>());
  EXPECT_EQ(Judge(sheet, WithCornerUv(sheet, uv)).measures->ValueOf("cut_length"), 0);
  for (int i = 3; i < 6; ++i) uv[i].x() -= 7;
  EXPECT_NEAR(Judge(sheet, WithCornerUv(sheet, uv)).measures->ValueOf("cut_length"), std::sqrt(2.0),
              1e-14);
}

TEST(VerifyMapMeasures, DelaunayMarginAndSmallestAngleOfARhombus) {
  const double h = std::sqrt(3.0) / 2;
  const PolygonSoup in =
      MakeSoup({{0, 0, 0}, {1, 0, 0}, {0.5, h, 0}, {0.5, -h, 0}}, {{0, 1, 2}, {1, 0, 3}});
  const AngleMeasures regular = *Judge(in, WithVertexUv(in, Flattened(in))).angles;
  EXPECT_NEAR(regular.delaunay_margin, kPi / 3, 1e-14);
  EXPECT_NEAR(regular.smallest_angle, kPi / 3, 1e-14);
  const AngleMeasures other_diagonal =
      *Judge(in, WithVertexUv(in, {{0, 0}, {1, 0}, {0.5, 0.5}, {0.5, -h}})).angles;
  EXPECT_NEAR(other_diagonal.delaunay_margin, kPi - kPi / 2 - kPi / 3, 1e-14);
  EXPECT_NEAR(other_diagonal.smallest_angle, kPi / 4, 1e-14);
}

TEST(VerifyMapMeasures, SeamsAgreeWhenTheirSidesAreCongruent) {
  PolygonSoup map = Fan(5, kPi / 3);
  const MapReport rigid = Judge(map, map);
  EXPECT_EQ(rigid.seams->num_edges, 1);
  EXPECT_LT(rigid.seams->largest_difference, 1e-15);
  EXPECT_EQ(rigid.num_patches, 1);
  map.texture.back() *= 1.25;
  VerifyOptions options;
  EXPECT_NEAR(Judge(map, map).seams->largest_difference, 0.2, 1e-12);
  EXPECT_TRUE(Judge(map, map).valid());
  options.require_rigid_seams = true;
  EXPECT_THAT(Judge(map, map, options).Verdict(),
              HasSubstr("the two sides of seam edge (0, 1) of triangle 0 differ in length by 0.2"));
}

TEST(VerifyMapMeasures, PatchesMayHaveTheirOwnScales) {
  const PolygonSoup in = FlatSheet(1);
  const auto halves = [&](double u_scale, double v_scale) {
    std::vector<Eigen::Vector2d> uv;
    for (const Index v : in.corner) uv.emplace_back(in.position[v].head<2>());
    for (int i = 3; i < 6; ++i) uv[i] = {u_scale * uv[i].x() - 20, v_scale * uv[i].y()};
    return WithCornerUv(in, uv);
  };
  const MapReport scaled = Judge(in, halves(3, 3));
  EXPECT_EQ(scaled.num_patches, 2);
  EXPECT_EQ(scaled.Verdict(), "valid (injective)");
  EXPECT_LT(scaled.seams->largest_difference, 1e-14);
}

TEST(VerifyMapMeasures, TargetsAreReadOrRefusedWithTheirLine) {
  const std::string path = testing::TempDir() + "verify_map_targets.txt";
  const auto read = [&](const std::string& content, Index num_vertices) {
    std::ofstream(path) << content;
    return ReadTargets(path, num_vertices);
  };
  const auto targets = read("6.25\r\nfree\n\n1e-1\n", 3);
  ASSERT_TRUE(targets.ok()) << targets.status().message();
  EXPECT_EQ(*targets, (std::vector<std::optional<double>>{6.25, std::nullopt, 0.1}));
  EXPECT_THAT(read("1\ntwo\n", 2).status().message(), HasSubstr(":2: 'two' is no angle sum"));
  EXPECT_THAT(read("1\nnan\n", 2).status().message(), HasSubstr(":2: 'nan' is no angle sum"));
  EXPECT_THAT(read("1\n2\n", 3).status().message(), HasSubstr("2 angle sums for 3 vertices"));
  std::remove(path.c_str());
  EXPECT_THAT(ReadTargets(path, 1).status().message(), HasSubstr("cannot be read"));
}

}  // namespace
}  // namespace cirque::verify_map
