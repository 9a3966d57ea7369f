// Rotations along loops: measured, and made multiples.
#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cirque/cones/cone.h"
#include "cirque/intrinsic/dual_paths.h"
#include "cirque/layout/seams.h"
#include "cirque/pipeline/close_rotations.h"
#include "cirque/pipeline/cone_stages.h"
#include "cirque/pipeline/parameterize.h"

#include "tests/common/surfaces.h"

namespace cirque {
namespace {

using ::testing::HasSubstr;

struct Mapped {
  Status status;
  Parameterization map;
};

Mapped Map(const Surface& surface, const ParameterizeOptions& options) {
  Mapped mapped;
  mapped.status = Parameterize(surface, {options}, {}, &mapped.map);
  EXPECT_TRUE(mapped.status.ok()) << mapped.status.message();
  return mapped;
}

ParameterizeOptions Asking(HolonomyRule holonomy) {
  ParameterizeOptions options;
  options.holonomy = holonomy;
  return options;
}

/// The rotations across all seams of a map are multiples of 2 pi / order, as its UVs alone say.
void ExpectSeamless(const Surface& surface, const Parameterization& map, int order) {
  const Triangulation& t = surface.triangulation;
  const std::vector<Index> cones = [&] {
    std::vector<Index> vertices;
    for (const Cone& cone : ConesOf(t, map.targets)) vertices.push_back(cone.vertex);
    return vertices;
  }();
  const SeamReport report = MeasureSeams(t, map.cut, cones, map.flat.on_input.angles, map.uv);
  EXPECT_FALSE(report.seams.empty());
  const auto multiples = IntegerRotations(t, report, order, 1e-9);
  EXPECT_TRUE(multiples.ok()) << multiples.status().message();
  EXPECT_EQ(map.certificate.layout->rotation_order, order);
  EXPECT_EQ(map.certificate.layout->flipped_triangles, 0);
}

TEST(Holonomy, OfADoubleTorusBecomesMultiples) {
  const Surface surface = GeneratedSurface("double_torus", 2000);
  const Mapped free = Map(surface, {});
  EXPECT_FALSE(free.map.certificate.holonomy);
  EXPECT_GT(free.map.certificate.rotations->rotation_miss_halves, 0.05);
  for (const auto& [holonomy, order] :
       {std::pair(HolonomyRule::kHalves, 4), std::pair(HolonomyRule::kThirds, 6)}) {
    SCOPED_TRACE(order);
    const Mapped mapped = Map(surface, Asking(holonomy));
    const Certificate& certificate = mapped.map.certificate;
    EXPECT_EQ(certificate.outcome, "ok") << certificate.message;
    EXPECT_LE(certificate.holonomy->holonomy_miss, kRotationAccuracy);
    EXPECT_LT(certificate.holonomy->holonomy_angle_change, 0.05);
    const RotationSummary& rotations = *certificate.rotations;
    EXPECT_LE(order == 4 ? rotations.rotation_miss_halves : rotations.rotation_miss_thirds, 1e-10);
    EXPECT_GT(order == 4 ? rotations.rotation_miss_thirds : rotations.rotation_miss_halves, 1e-3);
    ExpectSeamless(surface, mapped.map, order);
    EXPECT_LT(certificate.distortion->quasi_conformal_mean,
              1.1 * free.map.certificate.distortion->quasi_conformal_mean);
  }
}

// A flat torus is a parallelogram: nothing turns whatever one asks for.
TEST(Holonomy, OfATorusWithoutConesIsNone) {
  const Surface surface = GeneratedSurface("torus", 800);
  ParameterizeOptions options;
  options.cones = "none";
  const Mapped mapped = Map(surface, options);
  ASSERT_EQ(mapped.map.certificate.rotations->rotations.size(), 2u);
  for (const double rotation : mapped.map.certificate.rotations->rotations) {
    EXPECT_NEAR(BeyondMultiple(rotation, 2 * kPi), 0, 1e-9);
  }
  options.holonomy = HolonomyRule::kThirds;
  EXPECT_EQ(Map(surface, options).map.certificate.outcome, "ok");
}

// The free boundary of a ring lets angles close what turns around it, without cones.
TEST(Holonomy, AroundTheBoundaryOfARingIsClosedByAngles) {
  const Surface surface = GeneratedSurface("catenoid", 800);
  const Mapped free = Map(surface, {});
  EXPECT_EQ(free.map.certificate.rotations->boundary_rotations, 1);
  EXPECT_EQ(free.map.certificate.rotations->boundary_turns.size(), 1u);
  const Mapped mapped = Map(surface, Asking(HolonomyRule::kHalves));
  EXPECT_EQ(mapped.map.certificate.outcome, "ok") << mapped.map.certificate.message;
  EXPECT_LE(mapped.map.certificate.holonomy->holonomy_miss, kRotationAccuracy);
  ExpectSeamless(surface, mapped.map, 4);
}

// Cones that are given stay; what their angles' rotations cannot become is said.
TEST(Holonomy, MissesOfGivenConesAreSaid) {
  const Surface surface = GeneratedSurface("double_torus", 2000);
  ParameterizeOptions rounded;
  rounded.cones = "greedy";
  rounded.cone_budget = 8;
  rounded.cone_angles = "pi/2";
  const EdgeLengths lengths = MeasureEdgeLengths(surface);
  const ConeTargets targets =
      *PlaceCones(ConeSite(MeasureSurface(surface.triangulation, lengths)), rounded);
  ParameterizeRequest request{Asking(HolonomyRule::kHalves)};
  request.targets = targets;
  Parameterization map;
  ASSERT_TRUE(Parameterize(surface, request, {}, &map).ok());
  EXPECT_EQ(map.targets.lower, targets.lower);
  const HolonomySummary& holonomy = *map.certificate.holonomy;
  EXPECT_GT(holonomy.holonomy_miss_before, 0.02);
  const bool met = holonomy.holonomy_miss <= kRotationAccuracy;
  EXPECT_EQ(map.certificate.outcome, met ? "ok" : kInaccurate);
  EXPECT_EQ(map.certificate.layout->rotation_order, met ? 4 : 0);
  if (!met) {
    EXPECT_EQ(holonomy.holonomy_miss, holonomy.holonomy_miss_before);
    EXPECT_THAT(map.certificate.message,
                HasSubstr("rotation_" + std::to_string(holonomy.holonomy_loop)));
  }
}

TEST(Holonomy, RefusesWhatDoesNotGoWithIt) {
  const auto message = [](const auto& change) {
    ParameterizeOptions options = Asking(HolonomyRule::kHalves);
    EXPECT_TRUE(CheckOptions(options).ok());
    change(&options);
    return CheckOptions(options).message();
  };
  using O = ParameterizeOptions;
  EXPECT_THAT(message([](O* o) { o->pattern = PatternKind::kEquivalence; }), HasSubstr("circle"));
  EXPECT_THAT(message([](O* o) { o->cone_angles = "pi/3"; }), HasSubstr("cone_angles"));
  EXPECT_THAT(message([](O* o) { o->refine_cones = 2; }), HasSubstr("refine_cones"));
  EXPECT_THAT(message([](O* o) { o->seams = SeamKind::kFree; }), HasSubstr("seams"));
}

TEST(Holonomy, AMissedRotationIsAnInaccurateMap) {
  Certificate certificate;
  EXPECT_EQ(Inaccuracy(certificate), "");
  HolonomySummary& holonomy = Fill(&certificate.holonomy);
  holonomy.holonomy_miss = 1e-11;
  EXPECT_EQ(Inaccuracy(certificate), "");
  holonomy.holonomy_miss = 0.25;
  holonomy.holonomy_loop = 3;
  EXPECT_THAT(Inaccuracy(certificate),
              HasSubstr("rotation_3 misses the next multiple by 0.25 rad"));
}

TEST(RotationMisses, AreTheLargestAndWhose) {
  const RotationMiss miss = MissOf(Eigen::Vector3d(0.1, kPi / 2 - 0.3, 3 * kPi), kPi / 2);
  EXPECT_NEAR(miss.largest, 0.3, 1e-14);
  EXPECT_EQ(miss.loop, 1);
  EXPECT_EQ(MissOf(Eigen::VectorXd(), kPi / 2).loop, -1);
  EXPECT_FALSE(RotationUnit(HolonomyRule::kFree));
  EXPECT_EQ(RotationUnit(HolonomyRule::kThirds), kPi / 3);
}

}  // namespace
}  // namespace cirque
