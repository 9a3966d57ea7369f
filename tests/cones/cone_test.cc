// Cones and targets: there and back, and every way in which cones are refused.
#include "cirque/cones/cone.h"

#include <initializer_list>
#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/common/surfaces.h"

namespace cirque {
namespace {

using testing::HasSubstr;

const Triangulation& Icosahedron() {
  static const Triangulation t = RegularPolyhedron(20).triangulation;
  return t;
}

std::vector<Cone> ConesAt(std::initializer_list<Index> vertices, double curvature) {
  std::vector<Cone> cones;
  for (const Index v : vertices) cones.push_back(ConeOfCurvature(v, curvature));
  return cones;
}

TEST(Cones, BecomeTargetsAndTargetsConesAgain) {
  std::vector<Cone> cones = ConesAt({1, 4, 7}, kPi);
  cones.push_back({9, 0.5 * kPi, 1.5 * kPi});
  const auto targets = ConeTargetsOf(Icosahedron(), cones);
  ASSERT_TRUE(targets.ok()) << targets.status().message();
  EXPECT_EQ(targets->lower[4], kPi);
  EXPECT_EQ(targets->upper[4], kPi);
  EXPECT_EQ(targets->lower[0], 2 * kPi);
  EXPECT_FALSE(targets->IsFixed(9));
  const std::vector<Cone> back = ConesOf(Icosahedron(), *targets);
  ASSERT_EQ(back.size(), cones.size());
  for (std::size_t i = 0; i < cones.size(); ++i) {
    EXPECT_EQ(back[i].vertex, cones[i].vertex);
    EXPECT_EQ(back[i].lower, cones[i].lower);
    EXPECT_EQ(back[i].upper, cones[i].upper);
  }
  EXPECT_TRUE(ConesOf(Icosahedron(), FreeBoundaryTargets(Icosahedron())).empty());
}

TEST(Cones, OnABoundaryPrescribeItsAngle) {
  const Triangulation fan = Fan(6, 0.5).triangulation;
  const auto targets = ConeTargetsOf(fan, {{3, 0.5 * kPi, 0.5 * kPi}});
  ASSERT_TRUE(targets.ok());
  EXPECT_EQ(targets->upper[3], 0.5 * kPi);
  EXPECT_EQ(targets->lower[2], 0);  // the others stay free
}

void ExpectRefused(const Triangulation& t, const std::vector<Cone>& cones,
                   const std::string& words) {
  const Status status = ConeTargetsOf(t, cones).status();
  EXPECT_EQ(status.code(), StatusCode::kInvalidInput);
  EXPECT_THAT(status.message(), HasSubstr(words));
}

TEST(Cones, ThatCannotBeAreRefusedWithTheirVertex) {
  const Triangulation& t = Icosahedron();
  ExpectRefused(t, ConesAt({12}, kPi),
                "vertex 12 (0-based): the surface has vertices 0 to 11 only");
  ExpectRefused(t, ConesAt({-1}, kPi), "vertex -1 (0-based)");
  ExpectRefused(t, ConesAt({3, 5, 3}, kPi), "vertex 3 (0-based): it is named twice");
  ExpectRefused(t, {{2, 3, 1}}, "give 0 <= lower <= upper");
  ExpectRefused(t, {{2, -1, 1}}, "give 0 <= lower <= upper");
  ExpectRefused(t, {{2, 0, 0}}, "upper > 0");
  ExpectRefused(t, {{2, std::numeric_limits<double>::quiet_NaN(), 1}}, "give 0 <= lower <= upper");
  ExpectRefused(t, ConesAt({2}, -3 * kPi), "its 5 corners, each less than pi");
}

TEST(Cones, MustAddUpOnClosedSurfaces) {
  const Triangulation& t = Icosahedron();
  ExpectRefused(t, {}, "closed surface needs cones of curvature 4 pi in all");
  ExpectRefused(t, ConesAt({0, 1, 2}, kPi), "1 pi above");
  ExpectRefused(t, ConesAt({0, 1, 2, 3, 4}, kPi), "1 pi below");
  EXPECT_TRUE(ConeTargetsOf(t, ConesAt({0, 1, 2, 3}, kPi)).ok());
  // A range that holds what is missing is enough, one that ends before is not.
  std::vector<Cone> ranged = ConesAt({0, 1, 2}, kPi);
  ranged.push_back({3, 0.9 * kPi, 1.1 * kPi});
  EXPECT_TRUE(ConeTargetsOf(t, ranged).ok());
  ranged.back().lower = 1.05 * kPi;
  ExpectRefused(t, ranged, "above");
  // 12 thirds of pi round, within what is allowed.
  std::vector<Cone> thirds;
  for (Index v = 0; v < 12; ++v) thirds.push_back(ConeOfCurvature(v, kPi / 3));
  EXPECT_TRUE(ConeTargetsOf(t, thirds).ok());
}

}  // namespace
}  // namespace cirque
