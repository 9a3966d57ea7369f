#include <cmath>

#include <gtest/gtest.h>

#include "experiments/common/judged_measures.h"
#include "tests/verify/fixtures.h"

namespace cirque::verify {
namespace {

MapMeasures MeasuresOf(const PolygonSoup& in, const PolygonSoup& out) {
  return MeasureComplex(*Judge(in, out).complex, in.position);
}

TEST(VerifyMapMeasures, AnAffineMapHasItsSingularValuesRatioEverywhere) {
  const PolygonSoup in = FlatSheet(3);
  std::vector<Eigen::Vector2d> uv = Flattened(in);
  Eigen::Matrix2d turn, stretch;
  turn << std::cos(0.7), -std::sin(0.7), std::sin(0.7), std::cos(0.7);
  stretch << 6, 0, 0, 1.5;
  for (Eigen::Vector2d& p : uv) p = turn * stretch * turn * p + Eigen::Vector2d(5, -8);
  const MapMeasures m = MeasuresOf(in, WithVertexUv(in, uv));
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
  EXPECT_EQ(WorstTriangle(MeasuresOf(in, out)), 1);
  const PolygonSoup sheet = FlatSheet(1);
  std::vector<Eigen::Vector2d> uv;
  for (const Index v : sheet.corner) uv.emplace_back(sheet.position[v].head<2>());
  EXPECT_EQ(MeasuresOf(sheet, WithCornerUv(sheet, uv)).ValueOf("cut_length"), 0);
  for (int i = 3; i < 6; ++i) uv[i].x() -= 7;
  EXPECT_NEAR(MeasuresOf(sheet, WithCornerUv(sheet, uv)).ValueOf("cut_length"), std::sqrt(2.0),
              1e-14);
}

// What is not searched for where there is nothing to find is nothing, and all else stays.
TEST(VerifyMapMeasures, OfAnInjectiveMapTheOverlapIsZeroWithoutASearch) {
  const PolygonSoup in = Sheet(4);
  const UvComplex complex = *Judge(in, WithVertexUv(in, Flattened(in))).complex;
  const MapMeasures searched = MeasureComplex(complex, in.position);
  const MapMeasures known = MeasureComplex(complex, in.position, true);
  ASSERT_EQ(known.figures.size(), searched.figures.size());
  for (std::size_t i = 0; i < known.figures.size(); ++i) {
    EXPECT_EQ(known.figures[i].name, searched.figures[i].name);
    EXPECT_NEAR(known.figures[i].value, searched.figures[i].value, 1e-15) << known.figures[i].name;
  }
}

}  // namespace
}  // namespace cirque::verify
