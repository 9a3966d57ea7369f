#include <cmath>
#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "cirque/verify/infeasibility_check.h"
#include "cirque/verify/map_check.h"

#include "tests/verify/fixtures.h"

namespace cirque::verify {
namespace {

using ::testing::EndsWith;
using ::testing::HasSubstr;
using Json = nlohmann::json;

TEST(VerifyMapReport, JsonSaysWhatTheTextSays) {
  const PolygonSoup map = SquareStrip({{0, 0}, {1, 0}, {1, 1}, {0, 1}, {0, 0}, {0, -1}});
  const MapReport report = Judge(map, map);
  const Json json = Json::parse(ToJson(report));
  EXPECT_EQ(json["valid"], true);
  EXPECT_EQ(json["injective"], false);
  EXPECT_EQ(json["verdict"], report.Verdict());
  EXPECT_EQ(json["triangles"], 12);
  EXPECT_EQ(json["wrapped_boundary_vertices_ids"], Json::array({2}));
  EXPECT_EQ(json["flipped_triangles"], 0);
  EXPECT_EQ(json["overlapping_patches"], Json::array({0, 0}));
  EXPECT_EQ(json["patches"], 1);
  EXPECT_EQ(json["seam_edges"], 0);
  EXPECT_EQ(json["torn"], false);
  EXPECT_EQ(json["boundary_edges"], 14);
  EXPECT_FALSE(json.contains("largest_target_deviation"));
  EXPECT_THAT(ToText(report), HasSubstr("1 loop of 14 edges: the map goes round 1 vertex"));
  EXPECT_THAT(ToText(report), EndsWith("verdict: valid (locally injective, boundary overlaps "
                                       "itself), 1 patch, 0 seam edges\n"));
}

TEST(VerifyMapReport, QualityFiguresAreShownAndChangeNoVerdict) {
  const PolygonSoup map = Fan(6, kPi / 3);
  MapReport report = Judge(map, map);
  const std::string verdict = report.Verdict();
  EXPECT_FALSE(Json::parse(ToJson(report)).contains("quasi_conformal_worst_triangle"));
  report.quality = QualityFigures{"how far from conformal\n", {{"quasi_conformal_mean", 1e9}}, 4};
  const Json json = Json::parse(ToJson(report));
  EXPECT_EQ(json["quasi_conformal_mean"], 1e9);
  EXPECT_EQ(json["quasi_conformal_worst_triangle"], 4);
  EXPECT_THAT(ToText(report), HasSubstr("how far from conformal\nleast conformal   triangle 4\n"));
  EXPECT_EQ(report.Verdict(), verdict);
  EXPECT_TRUE(report.valid());
}

TEST(VerifyMapReport, WhatWasNotJudgedIsAbsent) {
  PolygonSoup out = Fan(6, kPi / 3);
  out.texture[0].x() = std::numeric_limits<double>::quiet_NaN();
  const MapReport report = Judge(out, out);
  const Json json = Json::parse(ToJson(report));
  EXPECT_EQ(json["valid"], false);
  EXPECT_TRUE(json["injective"].is_null());
  EXPECT_FALSE(json.contains("flipped_triangles"));
  EXPECT_EQ(json["triangles_not_finite_ids"], Json::array({0}));
  EXPECT_THAT(ToText(report), ::testing::Not(HasSubstr("orientation")));
}

// Whatever the numbers are, JSON holds those that are finite, and no null for the others.
TEST(VerifyMapReport, NumbersInJsonAreFiniteOrAbsent) {
  const PolygonSoup map = Fan(6, kPi / 3);
  MapReport report = Judge(map, map);
  report.quality = QualityFigures{
      "", {{"mean", std::nan("")}, {"max", HUGE_VAL}, {"least", -HUGE_VAL}, {"median", 2}}, kNone};
  PolygonSoup moved = map;
  moved.position[0].x() = HUGE_VAL;
  for (const MapReport& each : {report, Judge(map, moved)}) {
    const Json json = Json::parse(ToJson(each));
    for (const auto& [key, value] : json.items()) {
      EXPECT_TRUE(!value.is_null() || key == "injective") << key;
    }
    EXPECT_FALSE(json.contains("max"));
    EXPECT_FALSE(json.contains("quasi_conformal_worst_triangle"));
  }
  EXPECT_EQ(Json::parse(ToJson(report))["median"], 2);
  EXPECT_FALSE(Json::parse(ToJson(Judge(map, moved))).contains("largest_displacement"));
}

TEST(VerifyMapReport, ARejectedCertificateOfWrongFormHasNoSides) {
  const StatusOr<InfeasibilityReport> report = CheckInfeasibility({}, Fan(6, kPi / 3));
  ASSERT_TRUE(report.ok());
  const Json json = Json::parse(ToJson(*report));
  EXPECT_EQ(json["accepted"], false);
  EXPECT_FALSE(json.contains("left"));
  EXPECT_THAT(ToText(*report),
              EndsWith("verdict: REJECTED: face_multiplier has 0 entries instead of 6\n"));
}

}  // namespace
}  // namespace cirque::verify
