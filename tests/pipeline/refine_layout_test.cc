#include "cirque/pipeline/refine_layout.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cirque/cuts/cut_graph.h"
#include "cirque/layout/map_objective.h"
#include "cirque/layout/seams.h"
#include "cirque/metrics/injectivity.h"
#include "cirque/pipeline/certificate_fields.h"
#include "cirque/pipeline/parameterize.h"

#include "tests/common/surfaces.h"

namespace cirque {
namespace {

using ::testing::HasSubstr;

Parameterization MapOf(const Surface& surface, const ParameterizeOptions& options) {
  Parameterization map;
  const Status status = Parameterize(surface, {options}, {}, &map);
  EXPECT_TRUE(status.ok()) << status.message();
  return map;
}

double Distortion(const Parameterization& map) {
  return map.certificate.distortion->quasi_conformal_mean - 1;
}

TEST(EveryMapObjective, LowersTheDistortionWhileConesAndSeamsStay) {
  for (const char* surface_name : {"bumpy_terrain", "blob", "torus", "double_torus"}) {
    const Surface surface = GeneratedSurface(surface_name, 1000);
    const Triangulation& t = surface.triangulation;
    const Parameterization plain = MapOf(surface, {});
    for (const std::string& name : MapObjectives().Names()) {
      SCOPED_TRACE(std::string(surface_name) + " " + name);
      ParameterizeOptions options;
      options.refine_map = name;
      const Parameterization refined = MapOf(surface, options);
      EXPECT_LT(Distortion(refined), 0.99 * Distortion(plain));
      EXPECT_TRUE(FlippedFaces(t, refined.uv).empty());
      const Certificate& certificate = refined.certificate;
      EXPECT_GE(certificate.map_refinement->map_refinement_steps, 1);
      EXPECT_LT(certificate.map_refinement->map_refinement_after,
                certificate.map_refinement->map_refinement_before);
      EXPECT_EQ(refined.cut.edge, plain.cut.edge);
      // Every seam turns by what it turned, and the cones' angles are what was asked for.
      EXPECT_LT(certificate.seams->seam_gap, 1e-12);
      EXPECT_LT(certificate.seams->seam_rotation_mismatch, 1e-9);
      EXPECT_LT(certificate.seams->cone_rotation_mismatch, 1e-9);
      const std::vector<Index> cones = ConeVertices(t, plain.targets);
      const auto rotations = [&](const Parameterization& map) {
        return MeasureSeams(t, map.cut, cones, map.flat.on_input.angles, map.uv).seams;
      };
      const std::vector<Seam> before = rotations(plain), after = rotations(refined);
      ASSERT_EQ(before.size(), after.size());
      for (std::size_t i = 0; i < before.size(); ++i) {
        EXPECT_NEAR(std::remainder(before[i].rotation - after[i].rotation, 2 * kPi), 0, 1e-9);
      }
    }
  }
}

TEST(FreeSeams, OpenTheSurfaceAlongTheCutOfItsCones) {
  for (const char* surface_name : {"blob", "torus", "double_torus"}) {
    SCOPED_TRACE(surface_name);
    const Surface surface = GeneratedSurface(surface_name, 1000);
    ParameterizeOptions options;
    const Parameterization rigid = MapOf(surface, options);
    options.seams = SeamKind::kFree;
    const Parameterization open = MapOf(surface, options);
    EXPECT_EQ(open.cut.edge, rigid.cut.edge);
    double stages = 0;
    for (const char* stage : {"cones", "triangulation", "angles", "radii", "layout", "measures"}) {
      stages += SecondsOf(open.certificate).at(stage);
    }
    EXPECT_LE(stages, *open.certificate.seconds.total);
    EXPECT_EQ(open.certificate.layout->cones, rigid.certificate.layout->cones);
    EXPECT_EQ(open.certificate.layout->cut_length, rigid.certificate.layout->cut_length);
    EXPECT_LT(Distortion(open), Distortion(rigid));
    EXPECT_TRUE(FlippedFaces(surface.triangulation, open.uv).empty());
    // What is given up: the sides of the cut are not congruent any more.
    const std::vector<Index> cones = ConeVertices(surface.triangulation, rigid.targets);
    const SeamReport seams =
        MeasureSeams(surface.triangulation, open.cut, cones, rigid.flat.on_input.angles, open.uv);
    EXPECT_GT(seams.max_length_mismatch, 1e-3);
  }
}

TEST(FreeSeams, AreTheSameWhereNothingIsCut) {
  const Surface surface = GeneratedSurface("bumpy_terrain", 500);
  ParameterizeOptions options;
  const Parameterization rigid = MapOf(surface, options);
  options.seams = SeamKind::kFree;
  EXPECT_EQ(MapOf(surface, options).uv.value, rigid.uv.value);
  EXPECT_TRUE(FlippedFaces(surface.triangulation, rigid.uv).empty());
}

TEST(RefineLayout, WrongNamesAndOptionsAreRefusedBeforeTheSolve) {
  const Surface surface = GeneratedSurface("blob", 500);
  const auto refusal = [&](const ParameterizeOptions& options) {
    Parameterization map;
    const Status status = Parameterize(surface, {options}, {}, &map);
    EXPECT_EQ(status.code(), StatusCode::kInvalidInput);
    EXPECT_FALSE(map.certificate.seconds.angles.has_value());
    return status.message();
  };
  ParameterizeOptions options;
  options.refine_map = "mipz";
  EXPECT_THAT(refusal(options), HasSubstr("did you mean 'mips'"));
  options.refine_map = "mips:steps=0";
  EXPECT_THAT(refusal(options), HasSubstr("steps = '0' is not an integer in [1, 1e+06]"));
  options.refine_map = "none";
  options.epsilon = 2;
  EXPECT_EQ(refusal(options), "parameterize: epsilon = '2' is not a number in [1e-12, 1] rad");
}

}  // namespace
}  // namespace cirque
