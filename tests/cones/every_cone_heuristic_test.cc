// What every registered heuristic promises, on generated surfaces of genus 0, 1, 2 and on a disk.
#include <cmath>
#include <fstream>

#include <gtest/gtest.h>

#include "cirque/cones/registry.h"
#include "cirque/core/metric.h"
#include "cirque/intrinsic/intrinsic_delaunay.h"
#include "cirque/pipeline/cone_stages.h"
#include "cirque/pipeline/parameterize.h"

#include "tests/common/surfaces.h"

namespace cirque {
namespace {

constexpr int kBudget = 10;

struct Case {
  std::string heuristic, generator;
};

std::ostream& operator<<(std::ostream& stream, const Case& c) {
  return stream << c.heuristic << "_" << c.generator;
}

std::vector<Case> Cases() {
  std::vector<Case> cases;
  for (const std::string& heuristic : ConeHeuristics().Names()) {
    for (const char* generator : {"blob", "torus", "double_torus", "bumpy_terrain"}) {
      cases.push_back({heuristic, generator});
    }
  }
  return cases;
}

class EveryConeHeuristic : public testing::TestWithParam<Case> {
 protected:
  EveryConeHeuristic() : surface_(GeneratedSurface(GetParam().generator, 1200)) {
    options_.cones = GetParam().heuristic;
    if (options_.cones == "given") {
      WriteGivenCones();
    } else if (options_.cones != "none") {
      options_.cone_budget = kBudget;
    }
  }

  bool NeedsCones() const {
    return BoundaryLoops(surface_.triangulation).empty() &&
           EulerCharacteristic(surface_.triangulation) != 0;
  }

  StatusOr<ConeTargets> Choose() const {
    const EdgeLengths lengths = MeasureEdgeLengths(surface_);
    return PlaceCones(ConeSite(MeasureSurface(surface_.triangulation, lengths)), options_);
  }

  Surface surface_;
  ParameterizeOptions options_;

 private:
  /// The default's cones, as a file.
  void WriteGivenCones() {
    const std::string path = testing::TempDir() + "given_" + GetParam().generator + ".cones";
    std::ofstream file(path);
    file.precision(17);
    for (const Cone& c : ConesOf(surface_.triangulation, *DefaultTargets(surface_))) {
      file << c.vertex + 1 << " " << c.lower / kPi << " " << c.upper / kPi << "\n";
    }
    options_.cones = "given:file=" + path;
  }
};

TEST_P(EveryConeHeuristic, KeepsItsPromises) {
  const StatusOr<ConeTargets> targets = Choose();
  if (GetParam().heuristic == "none" && NeedsCones()) {
    EXPECT_EQ(targets.status().code(), StatusCode::kInvalidInput);
    EXPECT_NE(targets.status().message().find("Gauss-Bonnet"), std::string::npos);
    return;
  }
  ASSERT_TRUE(targets.ok()) << targets.status().message();
  const Triangulation& t = surface_.triangulation;
  const std::vector<Cone> cones = ConesOf(t, *targets);
  EXPECT_LE(cones.size(), kBudget);
  if (NeedsCones()) {
    EXPECT_GE(cones.size(), 3u);
  }
  const std::vector<Index> corners = CornersPerVertex(t);
  for (const Cone& c : cones) {
    EXPECT_GE(c.lower, kPi / 4 - 1e-12);
    EXPECT_LE(c.upper, kPi * (corners[c.vertex] - 0.5));
  }
  if (BoundaryLoops(t).empty()) {
    EXPECT_NEAR(MeasureGaussBonnetDefect(t, *targets).lower, 0, 1e-10);
    EXPECT_NEAR(MeasureGaussBonnetDefect(t, *targets).upper, 0, 1e-10);
  }
  const StatusOr<ConeTargets> again = Choose();
  EXPECT_EQ(again->lower, targets->lower);
  EXPECT_EQ(again->upper, targets->upper);
}

TEST_P(EveryConeHeuristic, EndsInAMap) {
  if (GetParam().heuristic == "none" && NeedsCones()) GTEST_SKIP() << "refused, as tested above";
  Parameterization map;
  const Status status = Parameterize(surface_, {options_}, {}, &map);
  ASSERT_TRUE(status.ok()) << status.message();
  EXPECT_EQ(map.certificate.layout->flipped_triangles, 0);
  EXPECT_LT(map.certificate.distortion->quasi_conformal_mean, 1.25);
}

INSTANTIATE_TEST_SUITE_P(Registry, EveryConeHeuristic, testing::ValuesIn(Cases()),
                         testing::PrintToStringParamName());

TEST(ConeHeuristics, BetterConesAreBetterThanPeaks) {
  // Realised, at equal budget: what the others are for.
  const Surface surface = GeneratedSurface("blob", 2000);
  const auto distortion = [&](const std::string& name) {
    ParameterizeOptions options;
    options.cones = name;
    options.cone_budget = 12;
    Parameterization map;
    EXPECT_TRUE(Parameterize(surface, {options}, {}, &map).ok()) << name;
    return map.certificate.distortion->log_area_ratio_l2;
  };
  const double moving = distortion("moving");
  EXPECT_GT(moving, 0.01);
  EXPECT_LT(moving, distortion("greedy"));
  EXPECT_LT(moving, distortion("curvature_peaks"));
}

TEST(ConeHeuristics, UnknownNamesAndOptionsAreRefused) {
  const auto message = [](const std::string& name, const OptionMap& options) {
    return MakeConeHeuristic(name, options).status().message();
  };
  EXPECT_NE(message("gredy", {}).find("did you mean 'greedy'?"), std::string::npos);
  EXPECT_NE(message("greedy", {{"cone", "3"}}).find("did you mean 'cones'?"), std::string::npos);
  EXPECT_NE(message("greedy", {{"pick", "any"}}).find("extreme, descent"), std::string::npos);
  EXPECT_NE(message("l1", {{"target", "-1"}}).find("[0,"), std::string::npos);
  EXPECT_NE(message("none", {{"cones", "3"}}).find("unknown none option"), std::string::npos);
  EXPECT_NE(message("moving", {{"start", "moving"}}).find("never begin"), std::string::npos);
  EXPECT_NE(message("moving", {{"start", "none"}, {"cones", "4"}}).find("moving"),
            std::string::npos);
}

TEST(ConeHeuristics, ATargetTakesTheFewestConesThatMeetIt) {
  const Surface surface = GeneratedSurface("blob", 1200);
  const EdgeLengths lengths = MeasureEdgeLengths(surface);
  const ConeProblem problem(surface.triangulation, lengths);
  const auto place = [&](const OptionMap& options) {
    return *(*MakeConeHeuristic("greedy", options))->Choose(problem);
  };
  const auto norm = [&](const std::vector<Cone>& cones) {
    return AreaNorm(problem, PredictedLogScale(problem, cones));
  };
  const std::vector<Cone> met = place({{"target", "0.1"}});
  EXPECT_LE(norm(met), 0.1);
  EXPECT_GT(norm(place({{"cones", std::to_string(met.size() - 1)}})), 0.1);
}

TEST(ConeHeuristics, TooFewConesBecomeAsManyAsGaussBonnetNeeds) {
  const Surface surface = GeneratedSurface("sphere", 500);
  const EdgeLengths lengths = MeasureEdgeLengths(surface);
  const ConeProblem problem(surface.triangulation, lengths);
  for (const char* name : {"curvature_peaks", "greedy", "l1", "reweighted", "moving"}) {
    const auto cones = (*MakeConeHeuristic(name, {{"cones", "1"}}))->Choose(problem);
    ASSERT_TRUE(cones.ok()) << name << ": " << cones.status().message();
    EXPECT_EQ(cones->size(), 3u) << name;  // of at most 1.75 pi each
    EXPECT_TRUE(ConeTargetsOf(surface.triangulation, *cones).ok()) << name;
  }
  ParameterizeOptions options;
  options.cones = "greedy:cones=2";
  Parameterization map;
  ASSERT_TRUE(Parameterize(surface, {options}, {}, &map).ok());
  EXPECT_EQ(map.certificate.cone_budget->cones_asked, 2);
  EXPECT_EQ(map.certificate.cone_budget->cones_needed, 3);
}

TEST(ConeHeuristics, MultiplesTakeMoreConesWhereFewDoNotAddUp) {
  // Genus 2 with two cones of -2 pi each: what few corners cannot carry.
  const Surface surface = GeneratedSurface("double_torus", 400);
  const EdgeLengths lengths = MeasureEdgeLengths(surface);
  const IntrinsicSurface measured = MeasureSurface(surface.triangulation, lengths);
  for (const char* angles : {"pi/2", "pi/3"}) {
    ParameterizeOptions options;
    options.cones = "greedy:cones=3";
    options.cone_angles = angles;
    const auto targets = PlaceCones(ConeSite(measured), options);
    ASSERT_TRUE(targets.ok()) << targets.status().message();
    EXPECT_NEAR(MeasureGaussBonnetDefect(surface.triangulation, *targets).lower, 0, 1e-9);
  }
}

TEST(ConeHeuristics, NoHeuristicRefusesASmallClosedSurface) {
  for (const auto& [generator, triangles] :
       {std::pair("sphere", 8), std::pair("blob", 20), std::pair("torus", 40),
        std::pair("double_torus", 100)}) {
    const Surface surface = GeneratedSurface(generator, triangles);
    const EdgeLengths lengths = MeasureEdgeLengths(surface);
    const IntrinsicSurface measured = MeasureSurface(surface.triangulation, lengths);
    for (const std::string& name : ConeHeuristics().Names()) {
      if (name == "none" || name == "given") continue;
      ParameterizeOptions options;
      options.cones = name;
      const auto targets = PlaceCones(ConeSite(measured), options);
      EXPECT_TRUE(targets.ok()) << generator << " " << name << ": " << targets.status().message();
    }
  }
}

}  // namespace
}  // namespace cirque
