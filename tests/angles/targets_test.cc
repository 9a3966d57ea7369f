#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cirque/angles/infeasibility.h"

#include "tests/common/surfaces.h"

namespace cirque {
namespace {

/// The check takes of a surface its connectivity alone.
Status Check(const Triangulation& t, const ConeTargets& targets,
             InfeasibilityCertificate* proof = nullptr) {
  const EdgeLengths equal = {Eigen::VectorXd::Ones(t.num_edges())};
  return CheckTargets(MeasureSurface(t, equal), targets, proof);
}

using ::testing::HasSubstr;

ConeTargets FanTargets(Index v, double lower, double upper) {
  ConeTargets targets = FreeBoundaryTargets(Fan(6, 0.5).triangulation);
  targets.lower[v] = lower;
  targets.upper[v] = upper;
  return targets;
}

/// Two triangles glued along two edges: a disk whose inner vertex 0 has valence 2.
Triangulation Pillow() { return NumberEdges(3, {0, 1, 2, 0, 2, 1}, {kNone, 5, 4, kNone, 2, 1}); }

void ExpectRefused(const Triangulation& t, const ConeTargets& targets, const std::string& words) {
  InfeasibilityCertificate certificate;
  const Status status = Check(t, targets, &certificate);
  EXPECT_EQ(status.code(), StatusCode::kInfeasible);
  EXPECT_THAT(status.message(), HasSubstr(words));
  EXPECT_TRUE(HoldsExactly(t, certificate)) << status.message();
}

TEST(CheckTargets, AcceptsFlatDisksAndSpheresWithEnoughCurvature) {
  EXPECT_TRUE(Check(Fan(6, 0.5).triangulation, FanTargets(1, 0.3, 2)).ok());
  const Triangulation torus = GeneratedSurface("torus", 300).triangulation;
  EXPECT_TRUE(Check(torus, FreeBoundaryTargets(torus)).ok());
  const Triangulation sphere = GeneratedSurface("sphere", 300).triangulation;
  ConeTargets cones = FreeBoundaryTargets(sphere);
  // 12 cones of curvature pi / 3, whose sums are not exact in floating point.
  for (Index v = 0; v < 12; ++v) cones.lower[v] = cones.upper[v] = 5 * kPi / 3;
  EXPECT_TRUE(Check(sphere, cones).ok()) << Check(sphere, cones).message();
}

TEST(CheckTargets, RefusesNumbersThatMeanNothing) {
  const Triangulation t = Fan(6, 0.5).triangulation;
  const std::pair<ConeTargets, std::string> cases[] = {
      {FanTargets(3, 2, 1), "[2, 1] rad of vertex 3 (0-based) is empty"},
      {FanTargets(2, -1, 1), "vertex 2 (0-based) is negative"},
      {FanTargets(2, 0, std::numeric_limits<double>::quiet_NaN()), "is not finite"},
      {ConeTargets{{1}, {1}}, "1 lower and 1 upper angle sums for 7 vertices"},
  };
  for (const auto& [targets, words] : cases) {
    const Status status = Check(t, targets);
    EXPECT_EQ(status.code(), StatusCode::kInvalidInput);
    EXPECT_THAT(status.message(), HasSubstr(words));
  }
}

TEST(CheckTargets, RefusesAFullAngleAtTwoCorners) {
  ExpectRefused(Fan(6, 0.5).triangulation, FanTargets(1, 2 * kPi, 2 * kPi),
                "boundary vertex 1 (0-based) has 2 corners");
  ExpectRefused(Pillow(), FreeBoundaryTargets(Pillow()), "inner vertex 0 (0-based) has 2 corners");
}

TEST(CheckTargets, RefusesAConeOfValenceTimesPiAndAnAngleSumOfZero) {
  ExpectRefused(Fan(6, 0.5).triangulation, FanTargets(0, 6 * kPi, 6 * kPi),
                "inner vertex 0 (0-based) has 6 corners, each less than pi, and must reach 6 pi");
  EXPECT_TRUE(Check(Fan(6, 0.5).triangulation, FanTargets(0, 5.99 * kPi, 6 * kPi)).ok());
  ExpectRefused(Fan(6, 0.5).triangulation, FanTargets(4, 0, 0), "vertices 4 (0-based) must be 0");
}

TEST(CheckTargets, RefusesWhatGaussAndBonnetExclude) {
  const Triangulation sphere = GeneratedSurface("sphere", 300).triangulation;
  ExpectRefused(sphere, FreeBoundaryTargets(sphere),
                "take away 4 pi in all; all vertices are to be flat");
  ConeTargets cones = FreeBoundaryTargets(sphere);
  for (Index v = 0; v < 5; ++v) cones.lower[v] = cones.upper[v] = kPi;
  ExpectRefused(sphere, cones, "add 1 pi in all; not flat are the vertices 0, 1, 2, 3, 4");
  // With intervals: the upper ends alone must reach far enough.
  cones.upper[2] = 2 * kPi;
  EXPECT_TRUE(Check(sphere, cones).ok());
  cones.upper[2] = 1.5 * kPi;
  ExpectRefused(sphere, cones, "at most");
}

}  // namespace
}  // namespace cirque
