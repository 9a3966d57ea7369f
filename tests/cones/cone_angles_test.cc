#include <cmath>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "cirque/cones/cone.h"
#include "cirque/cones/registry.h"

#include "tests/common/surfaces.h"

namespace cirque {
namespace {

TEST(ConeAngles, RoundedOnesAreMultiplesThatAddUp) {
  for (const char* name : {"blob", "torus", "double_torus"}) {
    const Surface surface = GeneratedSurface(name, 1500);
    const EdgeLengths lengths = MeasureEdgeLengths(surface);
    const ConeProblem problem(surface.triangulation, lengths);
    const auto cones = *(*MakeConeHeuristic("moving", {{"cones", "12"}}))->Choose(problem);
    for (const int parts : {2, 3}) {
      SCOPED_TRACE(fmt::format("{} pi/{}", name, parts));
      const auto options = ParseConeAngles(fmt::format("pi/{}", parts));
      const auto rounded = ApplyConeAngles(problem, cones, *options);
      ASSERT_TRUE(rounded.ok()) << rounded.status().message();
      double total = 0;
      for (const Cone& c : *rounded) {
        const double multiple = c.lower / kPi * parts;
        EXPECT_NEAR(multiple, std::round(multiple), 1e-12);
        EXPECT_NE(c.lower, 2 * kPi);
        EXPECT_EQ(c.lower, c.upper);
        total += 2 * kPi - c.lower;
      }
      EXPECT_NEAR(total, problem.TotalCurvature(), 1e-10);
      EXPECT_TRUE(ConeTargetsOf(surface.triangulation, *rounded).ok());
    }
  }
}

TEST(ConeAngles, RangesHoldTheProposedAngle) {
  const Surface surface = GeneratedSurface("blob", 800);
  const EdgeLengths lengths = MeasureEdgeLengths(surface);
  const ConeProblem problem(surface.triangulation, lengths);
  const auto cones = *(*MakeConeHeuristic("greedy"))->Choose(problem);
  const auto ranged = *ApplyConeAngles(problem, cones, *ParseConeAngles("ranges:width=0.2"));
  ASSERT_EQ(ranged.size(), cones.size());
  for (std::size_t i = 0; i < cones.size(); ++i) {
    EXPECT_LT(ranged[i].lower, ranged[i].upper);
    EXPECT_LE(ranged[i].lower, cones[i].lower);
    EXPECT_GE(ranged[i].upper, cones[i].upper);
    EXPECT_LE(ranged[i].upper - ranged[i].lower, 0.4 + 1e-12);
  }
}

TEST(ConeAngles, WordsAreRead) {
  EXPECT_EQ(ParseConeAngles("pi/3")->angles, ConeAngleRule::kThirds);
  EXPECT_EQ(ParseConeAngles("ranges:width=0.5")->width, 0.5);
  for (const char* bad : {"", "pi/4", "free:width=1", "ranges:width=-1", "ranges:wide=1",
                          "ranges:width", "ranges:width=1,width=2"}) {
    EXPECT_EQ(ParseConeAngles(bad).status().code(), StatusCode::kInvalidInput) << bad;
  }
}

TEST(ConeTargetsOf, RefusesWhatNoSurfaceHas) {
  const Surface surface = GeneratedSurface("sphere", 200);
  const Triangulation& t = surface.triangulation;
  const auto message = [&](const std::vector<Cone>& cones) {
    return ConeTargetsOf(t, cones).status().message();
  };
  EXPECT_NE(message({}).find("curvature 4 pi"), std::string::npos);
  EXPECT_NE(message({{-1, 1, 1}}).find("vertex -1"), std::string::npos);
  EXPECT_NE(message({{5, 1, 1}, {5, 1, 1}}).find("named twice"), std::string::npos);
  EXPECT_NE(message({{5, 2, 1}}).find("lower <= upper"), std::string::npos);
  EXPECT_NE(message({{5, 99, 99}}).find("corners"), std::string::npos);
  std::vector<Cone> cones;
  for (const Index v : {0, 10, 20, 30}) cones.push_back(ConeOfCurvature(v, kPi));
  const StatusOr<ConeTargets> targets = ConeTargetsOf(t, cones);
  ASSERT_TRUE(targets.ok()) << targets.status().message();
  EXPECT_EQ(ConesOf(t, *targets).size(), 4u);
  EXPECT_EQ(ConesOf(t, *targets)[1].vertex, 10);
}

}  // namespace
}  // namespace cirque
