#include "cirque/pipeline/certificate.h"

#include <cmath>
#include <fstream>
#include <set>
#include <sstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "cirque/pipeline/parameterize.h"

#include "tests/common/paths.h"
#include "tests/common/surfaces.h"

namespace cirque {
namespace {

nlohmann::json Parse(const Certificate& certificate) {
  return nlohmann::json::parse(certificate.ToJson());
}

/// Every summary there, with the numbers that it has untouched.
Certificate WithAllSummaries() {
  Certificate c;
  Fill(&c.triangulation), Fill(&c.angle_fit), Fill(&c.radii), Fill(&c.cone_repair);
  Fill(&c.cone_refinement), Fill(&c.layout), Fill(&c.seams), Fill(&c.map_refinement);
  Fill(&c.distortion), Fill(&c.sphere), Fill(&c.disk), Fill(&c.half_plane), Fill(&c.polygon);
  Fill(&c.process), Fill(&c.injectivity), Fill(&c.periodic);
  return c;
}

TEST(Certificate, ParsingGivesBackEveryNumber) {
  ParameterizeOptions options;
  options.cones = "greedy:cones=4";
  options.refine_map = "mips:steps=1";
  Parameterization map;
  ASSERT_TRUE(Parameterize(GeneratedSurface("blob", 300), {options}, {}, &map).ok());
  const auto json = Parse(map.certificate);
  EXPECT_EQ(json["schema"], "cirque-certificate");
  EXPECT_EQ(json["version"], 1);
  EXPECT_EQ(json["outcome"], "ok");
  const std::map<std::string, double> numbers = NumbersOf(map.certificate);
  EXPECT_EQ(json["values"].size(), numbers.size());
  EXPECT_GT(numbers.size(), 35u);
  for (const auto& [name, value] : numbers) {
    ASSERT_TRUE(std::isfinite(value)) << name;
    EXPECT_EQ(json["values"][name].get<double>(), value) << name;
  }
  for (const auto& [stage, seconds] : SecondsOf(map.certificate)) {
    EXPECT_EQ(json["seconds"][stage].get<double>(), seconds) << stage;
  }
  EXPECT_EQ(json["history"]["radii"].get<std::vector<double>>(), map.certificate.radii->gradients);
  EXPECT_EQ(json["solvers"]["angles"], map.certificate.angle_fit->solver);
}

TEST(Certificate, WhatARunDidNotComeToIsAbsentAndNoNumberIsNull) {
  EXPECT_TRUE(NumbersOf({}).empty());
  EXPECT_TRUE(SecondsOf({}).empty());
  EXPECT_TRUE(Parse({})["values"].empty());
  EXPECT_FALSE(Parse({}).contains("infeasibility"));
  Certificate certificate;
  AngleFitSummary& angles = Fill(&certificate.angle_fit);
  angles.smallest_angle = 0.25;
  angles.angle_primal = -std::numeric_limits<double>::infinity();
  angles.gradients = {1, kUnset, 1e-300};
  const auto json = Parse(certificate);
  EXPECT_EQ(json["values"]["smallest_angle"], 0.25);
  EXPECT_TRUE(json["values"]["angle_gap"].is_null());
  EXPECT_TRUE(json["values"]["angle_primal"].is_null());
  EXPECT_FALSE(json["values"].contains("angle_fit_retried"));
  EXPECT_FALSE(json["values"].contains("radii_gap"));
  EXPECT_TRUE(json["history"]["angles"][1].is_null());
  EXPECT_EQ(json["history"]["angles"][2], 1e-300);
}

TEST(Certificate, EveryFieldReadsItsOwnMember) {
  Certificate certificate = WithAllSummaries();
  const auto before = NumbersOf(certificate);
  certificate.radii->log_radius_range = 7;
  certificate.seams->seams = 3;
  certificate.layout->cones = 5;
  certificate.sphere->degree = 2;
  certificate.process->peak_memory_mib = 11;
  auto expected = before;
  for (const auto& [name, value] : std::map<std::string, double>{{"log_radius_range", 7},
                                                                 {"seams", 3},
                                                                 {"cones", 5},
                                                                 {"degree", 2},
                                                                 {"peak_memory_mib", 11}}) {
    expected[name] = value;
  }
  const auto after = NumbersOf(certificate);
  ASSERT_EQ(after.size(), expected.size());
  for (const auto& [name, value] : after) {
    EXPECT_TRUE(value == expected[name] || (std::isnan(value) && std::isnan(expected[name])))
        << name;
  }
}

TEST(Certificate, NamesAreUniqueWithinASummaryAndDescribed) {
  std::set<std::pair<std::string, std::string>> seen;
  for (const auto* table : {&CertificateFields(), &SecondsFields()}) {
    for (const CertificateField& field : *table) {
      EXPECT_TRUE(seen.emplace(field.summary, field.name).second) << field.name;
      EXPECT_FALSE(field.meaning.empty()) << field.name;
    }
  }
  EXPECT_EQ(CertificateFields()[0].Label(), "intrinsic flips");
  EXPECT_EQ(SecondsFields()[0].Label(), "time of reading the mesh [s]");
}

TEST(Certificate, CornersAreNumberedOneByOne) {
  Certificate certificate;
  Fill(&certificate.polygon).corner_vertices = {4, 0, 9};
  const auto numbers = NumbersOf(certificate);
  EXPECT_EQ(numbers.at("corner_vertex_0"), 4);
  EXPECT_EQ(numbers.at("corner_vertex_2"), 9);
  EXPECT_EQ(numbers.count("corner_vertex_3"), 0u);
}

TEST(Certificate, ItsReferencePageIsCurrent) {
  std::ifstream file(ProjectPath("framework/docs/certificate.md"));
  std::ostringstream page;
  page << file.rdbuf();
  EXPECT_EQ(page.str(), CertificateReference())
      << "write it anew: circle_patterns --certificate_help > framework/docs/certificate.md";
}

TEST(Certificate, TimesOfAStageAddUp) {
  std::optional<double> seconds;
  AddSeconds(Timer(), &seconds);
  ASSERT_TRUE(seconds.has_value());
  EXPECT_LT(*seconds, 1);
  seconds = 100;
  AddSeconds(Timer(), &seconds);
  EXPECT_GE(*seconds, 100);
  EXPECT_LT(*seconds, 101);
}

TEST(Certificate, AMapThatMissesTheAccuracyIsNamedAndNeverOk) {
  Certificate certificate;
  certificate.radii.emplace().log_radius_range = 30.9;
  LayoutSummary& layout = certificate.layout.emplace();
  SeamSummary& seams = certificate.seams.emplace();
  for (const auto& [closure, lengths] :
       {std::pair(0.5 * kAccuracy, 0.0), std::pair(0.0, 0.9 * kAccuracy)}) {
    layout.layout_closure = closure, seams.seam_length_mismatch = lengths;
    EXPECT_TRUE(Conclude({}, Timer(), &certificate).ok());
    EXPECT_EQ(certificate.outcome, "ok");
    EXPECT_EQ(certificate.message, "");
  }
  for (const auto& [closure, lengths] : {std::pair(2 * kAccuracy, 0.0), std::pair(0.0, 8e-4)}) {
    layout.layout_closure = closure, seams.seam_length_mismatch = lengths;
    EXPECT_TRUE(Conclude({}, Timer(), &certificate).ok());
    EXPECT_EQ(certificate.outcome, kInaccurate);
    EXPECT_THAT(certificate.message, testing::HasSubstr("log radii range over 30.9"));
  }
  // Another outcome stays what it is.
  const Status infeasible(StatusCode::kInfeasible, "why");
  EXPECT_EQ(Conclude(infeasible, Timer(), &certificate).code(), StatusCode::kInfeasible);
  EXPECT_EQ(certificate.outcome, "infeasible");
  EXPECT_EQ(certificate.message, "why");
}

}  // namespace
}  // namespace cirque
