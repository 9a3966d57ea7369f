// Maps whose measures are known in closed form.
#include <cmath>

#include <gtest/gtest.h>

#include "tests/metrics/maps.h"

namespace cirque {
namespace {

using Eigen::Vector2d;
using Triangle = std::array<Vector2d, 3>;

constexpr double kSmall = 1e-12;

TEST(KnownValues, AnIsometryIsPerfect) {
  const MapMeasures m = DroppedToPlane(Grid(4, 4)).Measure();
  for (const char* one : {"quasi_conformal_mean", "quasi_conformal_p99", "quasi_conformal_max",
                          "singular_value_min", "singular_value_max"}) {
    EXPECT_NEAR(m.ValueOf(one), 1, kSmall) << one;
  }
  for (const char* zero :
       {"angle_error_max", "angle_discrepancy", "angle_distortion_max", "log_area_ratio_min",
        "log_area_ratio_max", "log_scale_max", "area_distortion_max", "area_discrepancy",
        "cut_length", "flipped_share", "overlap_area", "covered_twice_area", "degenerate_faces"}) {
    EXPECT_NEAR(m.ValueOf(zero), 0, kSmall) << zero;
  }
  EXPECT_NEAR(m.ValueOf("symmetric_dirichlet"), 2, kSmall);
  EXPECT_NEAR(m.ValueOf("resolution"), 4, kSmall);
  EXPECT_NEAR(m.ValueOf("resolution_unit_area"), 1, kSmall);
}

TEST(KnownValues, AStretchByTwoAndAHalf) {
  const MapMeasures m = MapOf(Grid(3, 3), [](const Eigen::Vector3d& p) {
                          return Vector2d(2 * p.x(), p.y() / 2);
                        }).Measure();
  EXPECT_NEAR(m.ValueOf("singular_value_max"), 2, kSmall);
  EXPECT_NEAR(m.ValueOf("singular_value_min"), 0.5, kSmall);
  EXPECT_NEAR(m.ValueOf("quasi_conformal_mean"), 4, kSmall);
  EXPECT_NEAR(m.ValueOf("quasi_conformal_p50"), 4, kSmall);
  EXPECT_NEAR(m.ValueOf("angle_distortion_max"), 4 + 0.25 - 2, kSmall);
  EXPECT_NEAR(m.ValueOf("symmetric_dirichlet"), (4 + 0.25 + 0.25 + 4) / 2, kSmall);
  EXPECT_NEAR(m.ValueOf("area_distortion_max"), 0, kSmall);
  EXPECT_NEAR(m.ValueOf("log_area_ratio_l2"), 0, kSmall);
  // Half a square: the angles of 45 degrees become those of slopes 1/4 and 4.
  const double lost = kPi / 4 - std::atan(0.25);
  EXPECT_NEAR(m.ValueOf("angle_discrepancy"), 2 * lost, kSmall);
  EXPECT_NEAR(m.ValueOf("angle_error_mean"), 2 * lost / 3, kSmall);
  EXPECT_NEAR(m.ValueOf("angle_error_max"), lost, kSmall);
}

TEST(KnownValues, AConeOntoItsBase) {
  // An n-fan of height h: each face's altitude from the rim edge grows from a to hypot(a, h).
  const double a = std::cos(kPi / 6), h = 0.7;
  const MapMeasures m = DroppedToPlane(Fan(6, h)).Measure();
  EXPECT_NEAR(m.ValueOf("quasi_conformal_mean"), std::hypot(a, h) / a, kSmall);
  EXPECT_NEAR(m.ValueOf("log_area_ratio_l2"), 0, kSmall);
}

TEST(KnownValues, TwoTrianglesOfDifferentWeight) {
  // Areas 9 and 1 of ten; the small one is stretched fourfold in the plane: 9 and 4 of 13.
  const MapMeasures m =
      LooseTriangles({Triangle{{{0, 0}, {3, 0}, {0, 6}}}, Triangle{{{0, 5}, {1, 5}, {0, 7}}}},
                     {Triangle{{{0, 0}, {3, 0}, {0, 6}}}, Triangle{{{10, 0}, {14, 0}, {10, 2}}}})
          .Measure();
  EXPECT_NEAR(m.ValueOf("quasi_conformal_mean"), 0.9 * 1 + 0.1 * 4, kSmall);
  EXPECT_NEAR(m.ValueOf("quasi_conformal_p50"), 1, kSmall);
  EXPECT_NEAR(m.ValueOf("quasi_conformal_p95"), 4, kSmall);
  EXPECT_NEAR(m.ValueOf("quasi_conformal_max"), 4, kSmall);
  const double large = std::log((9.0 / 13) / 0.9), small = std::log((4.0 / 13) / 0.1);
  EXPECT_NEAR(m.ValueOf("log_area_ratio_min"), large, kSmall);
  EXPECT_NEAR(m.ValueOf("log_area_ratio_max"), small, kSmall);
  const double mean = 0.9 * large + 0.1 * small;
  EXPECT_NEAR(m.ValueOf("log_area_ratio_mean"), mean, kSmall);
  EXPECT_NEAR(m.ValueOf("log_area_ratio_l2"), std::sqrt(0.9 * large * large + 0.1 * small * small),
              kSmall);
  EXPECT_NEAR(m.ValueOf("log_scale_max"), (small - mean) / 2, kSmall);
  // A two-valued variable of weights 0.9 and 0.1 deviates by 0.3 of its span.
  EXPECT_NEAR(m.ValueOf("log_scale_l2"), 0.3 * (small - large) / 2, kSmall);
  EXPECT_NEAR(m.ValueOf("area_discrepancy"), 0.9 - 9.0 / 13 + 4.0 / 13 - 0.1, kSmall);
  const double grown = 40.0 / 13;
  EXPECT_NEAR(m.ValueOf("area_distortion_max"), grown + 1 / grown - 2, kSmall);
}

TEST(KnownValues, PlantedFlipsAreCountedTheSmallerWay) {
  for (const int planted : {0, 1, 4, 7, 10}) {
    TestMap map = LooseTriangles(std::vector<Triangle>(10, {{{0, 0}, {1, 0}, {0, 1}}}),
                                 std::vector<Triangle>(10, {{{0, 0}, {1, 0}, {0, 1}}}));
    for (int f = 0; f < planted; ++f) std::swap(map.uv.value[3 * f], map.uv.value[3 * f + 1]);
    const MapMeasures m = map.Measure();
    EXPECT_NEAR(m.ValueOf("flipped_share"), std::min(planted, 10 - planted) / 10.0, kSmall);
    EXPECT_EQ(m.FaceValuesOf("flipped").value.sum(), planted);
  }
}

TEST(KnownValues, ResolutionIsThatOfTheUnitSquare) {
  const auto shrink = [](const Eigen::Vector3d& p) { return Vector2d(p.x() / 7, p.y() / 7); };
  const MapMeasures m = MapOf(Grid(6, 2), shrink).Measure();
  EXPECT_NEAR(m.ValueOf("resolution"), 6, kSmall);
  EXPECT_NEAR(m.ValueOf("resolution_unit_area"), 6 / std::sqrt(12.0), kSmall);
}

TEST(KnownValues, ATearIsAsLongAsItsEdges) {
  TestMap map = DroppedToPlane(Grid(3, 2));
  for (Index h = 0; h < 18; ++h) map.uv.value[h].y() -= 1;  // the lower row
  EXPECT_NEAR(map.Measure().ValueOf("cut_length"), 3 / std::sqrt(6.0), kSmall);
}

TEST(KnownValues, DegenerateFacesAreCountedAndLeftOut) {
  const Triangle half = {{{0, 0}, {1, 0}, {0, 1}}}, wide = {{{0, 0}, {3, 0}, {0, 1}}};
  const Triangle flat = {{{0, 0}, {1, 0}, {2, 0}}}, lost = {{{0, 0}, {1, 0}, {NAN, 1}}};
  const MapMeasures m =
      LooseTriangles({half, half, half, flat}, {wide, flat, lost, half}).Measure();
  EXPECT_EQ(m.ValueOf("degenerate_faces"), 3);
  EXPECT_NEAR(m.ValueOf("quasi_conformal_max"), 3, kSmall);
  EXPECT_NEAR(m.ValueOf("log_area_ratio_mean"), 0, kSmall);
  const Eigen::VectorXd& ratio = m.FaceValuesOf("quasi_conformal").value;
  EXPECT_NEAR(ratio[0], 3, kSmall);
  for (const Index f : {1, 2, 3}) EXPECT_TRUE(std::isnan(ratio[f])) << f;
}

TEST(KnownValues, ExtremeUnitsAndNeedlesDoNotHurt) {
  const Triangle needle = {{{0, 0}, {1, 0}, {1, 1e-12}}};
  TestMap map = LooseTriangles({needle}, {needle});
  for (Vector2d& p : map.uv.value) p.y() *= 2;
  const double expected = map.Measure().ValueOf("quasi_conformal_max");
  EXPECT_NEAR(expected, 2, 1e-9);
  map.lengths.value *= 0x1p+600;
  for (Vector2d& p : map.uv.value) p *= 0x1p-600;
  EXPECT_EQ(map.Measure().ValueOf("quasi_conformal_max"), expected);
}

TEST(KnownValues, AnglesKnownBetterThanFromLengthsAreUsed) {
  // Of a cap this flat the lengths do not know the height.
  const double height = 1e-9;
  const Triangle cap = {{{0, 0}, {1, 0}, {0.5, height}}};
  TestMap map = LooseTriangles({cap}, {cap});
  for (Vector2d& p : map.uv.value) p.y() *= 2;
  EXPECT_EQ(map.Measure().ValueOf("degenerate_faces"), 1);
  CornerAngles angles;
  angles.value.resize(3);
  angles.value << std::atan(2 * height), std::atan(2 * height), kPi - 2 * std::atan(2 * height);
  const MapMeasures m = MeasureMap(map.triangulation, map.lengths, map.uv, &angles);
  EXPECT_NEAR(m.ValueOf("quasi_conformal_max"), 2, 1e-6);
}

}  // namespace
}  // namespace cirque
