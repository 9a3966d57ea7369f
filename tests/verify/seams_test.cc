#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cirque/verify/boundary_check.h"

#include "tests/verify/fixtures.h"

namespace cirque::verify {
namespace {

using ::testing::HasSubstr;

TEST(Seams, SeamsAgreeWhenTheirSidesAreCongruent) {
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

TEST(Seams, PatchesMayHaveTheirOwnScales) {
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

}  // namespace
}  // namespace cirque::verify
