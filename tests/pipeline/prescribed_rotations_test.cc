// Rotations along loops of a file: measured, and met at the price of conformality.
#include <cmath>
#include <complex>
#include <memory>
#include <utility>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cirque/cones/cone.h"
#include "cirque/intrinsic/loop_rotations.h"
#include "cirque/metrics/injectivity.h"
#include "cirque/pipeline/parameterize.h"

#include "tests/common/surfaces.h"

namespace cirque {
namespace {

using ::testing::HasSubstr;

/// What directions turn by along a path, as the uvs of the map alone tell it: the argument of the
/// product of the motions from each face to the next.
double RotationInImage(const Triangulation& t, const CornerUv& uv, const DualPath& path) {
  using Complex = std::complex<double>;
  const auto edge = [&](Index h) {
    const Eigen::Vector2d e = uv.value[Triangulation::Prev(h)] - uv.value[Triangulation::Next(h)];
    return Complex(e.x(), e.y());
  };
  Complex turn = 1;
  for (const Index h : path.entered) turn *= -edge(t.twin[h]) / edge(h);
  return std::arg(turn);
}

std::shared_ptr<const PrescribedRotations> Shared(PrescribedRotations rotations) {
  return std::make_shared<const PrescribedRotations>(std::move(rotations));
}

/// `double_torus` with its loops around handles.
class PrescribedRotationsTest : public ::testing::Test {
 protected:
  Status Map(const PrescribedRotations* rotations, Parameterization* map) const {
    ParameterizeRequest request;
    request.options.cones = "moving";
    request.options.cone_budget = 8;
    request.options.strict = true;
    if (rotations) request.rotations = Shared(*rotations);
    return Parameterize(surface_, request, {}, map);
  }

  /// What the cones make of them.
  PrescribedRotations Found(const Parameterization& map) const {
    PrescribedRotations found;
    for (const DualPath& path : HandleLoops(t_)) {
      found.loops.push_back({path, RotationInImage(t_, map.uv, path)});
    }
    return found;
  }

  const Surface surface_ = GeneratedSurface("double_torus", 1500);
  const Triangulation& t_ = surface_.triangulation;
};

TEST_F(PrescribedRotationsTest, AreMeasuredAsTheImageHasThem) {
  Parameterization plain, map;
  ASSERT_TRUE(Map(nullptr, &plain).ok());
  EXPECT_FALSE(plain.certificate.loops);
  PrescribedRotations asked = Found(plain);
  ASSERT_EQ(asked.loops.size(), 4u);
  asked.loops[1].rotation += 4 * kPi;  // the same directions
  asked.loops[2].rotation += 0.25;
  const Status status = Map(&asked, &map);
  ASSERT_TRUE(status.ok()) << status.message();
  EXPECT_EQ(map.certificate.outcome, "ok");
  EXPECT_EQ(map.uv.value, plain.uv.value) << "they are measured, nothing else";
  ASSERT_TRUE(map.certificate.loops);
  const LoopsSummary& loops = *map.certificate.loops;
  EXPECT_EQ(loops.loop_that_misses, 2);
  EXPECT_NEAR(loops.loop_miss, 0.25, 1e-7);
  ASSERT_EQ(loops.misses.size(), 4u);
  for (const std::size_t q : {0, 1, 3}) EXPECT_NEAR(loops.misses[q], 0, 1e-7);
  EXPECT_NEAR(loops.misses[2], 0.25, 1e-7);
}

TEST_F(PrescribedRotationsTest, AreMetAtThePriceOfConformality) {
  Parameterization plain, map;
  ASSERT_TRUE(Map(nullptr, &plain).ok());
  PrescribedRotations asked = Found(plain);
  asked.meet = true;
  constexpr double kTurned = 0.1;
  asked.loops[0].rotation += kTurned;
  asked.loops[3].rotation -= kTurned / 2;
  const Status status = Map(&asked, &map);
  ASSERT_TRUE(status.ok()) << status.message();
  EXPECT_EQ(map.certificate.outcome, "ok") << map.certificate.message;
  ASSERT_TRUE(map.certificate.loops);
  EXPECT_LT(map.certificate.loops->loop_miss, 1e-10);
  EXPECT_NEAR(map.certificate.loops->loop_miss_before.value_or(0), kTurned, 1e-6);
  EXPECT_GT(map.certificate.loops->loop_steps.value_or(0), 0);
  for (const LoopRotation& loop : asked.loops) {
    EXPECT_LT(
        std::abs(BeyondMultiple(RotationInImage(t_, map.uv, loop.path) - loop.rotation, 2 * kPi)),
        1e-7);
  }
  EXPECT_TRUE(FlippedFaces(t_, map.uv).empty());
  EXPECT_EQ(map.targets.lower, plain.targets.lower) << "cones stay";
  EXPECT_GT(map.certificate.distortion->quasi_conformal_mean,
            plain.certificate.distortion->quasi_conformal_mean + 1e-4);
}

TEST_F(PrescribedRotationsTest, AroundAVertexTheConesDecide) {
  DualPath around;
  t_.ForEachCornerAround(0, [&](Index c) { around.entered.push_back(Triangulation::Prev(c)); });
  PrescribedRotations asked{{{around, 0.3}}, true};
  Parameterization map;
  const Status status = Map(&asked, &map);
  EXPECT_EQ(map.certificate.outcome, "inaccurate") << status.message();
  EXPECT_THAT(map.certificate.message, HasSubstr("along loop 1 misses by 0.3 rad"));
  EXPECT_TRUE(FlippedFaces(t_, map.uv).empty());
}

TEST_F(PrescribedRotationsTest, RefuseWhatTheyDoNotGoWith) {
  ParameterizeRequest request;
  request.rotations = Shared({{{HandleLoops(t_)[0], 1}}, true});
  Parameterization map;
  const auto refusal = [&] { return Parameterize(surface_, request, {}, &map).message(); };
  request.options.holonomy = HolonomyRule::kHalves;
  EXPECT_THAT(refusal(), HasSubstr("holonomy"));
  request.options = {};
  request.options.pattern = PatternKind::kEquivalence;
  EXPECT_THAT(refusal(), HasSubstr("pattern = circle"));
  request.options = {};
  request.options.refine_cones = 1;
  EXPECT_THAT(refusal(), HasSubstr("refine_cones"));
  request.options = {};
  request.options.seams = SeamKind::kFree;
  EXPECT_THAT(refusal(), HasSubstr("seams = rigid"));
}

TEST_F(PrescribedRotationsTest, OfConformalEquivalenceAreMeasuredToo) {
  ParameterizeRequest request;
  request.options.cones = "moving";
  request.options.cone_budget = 8;
  request.options.pattern = PatternKind::kEquivalence;
  Parameterization plain, map;
  ASSERT_TRUE(Parameterize(surface_, request, {}, &plain).ok());
  request.rotations = Shared(Found(plain));
  ASSERT_TRUE(Parameterize(surface_, request, {}, &map).ok());
  ASSERT_TRUE(map.certificate.loops);
  EXPECT_LT(map.certificate.loops->loop_miss, 1e-7);
}

}  // namespace
}  // namespace cirque
