#include "cirque/metrics/injectivity.h"

#include <gtest/gtest.h>

#include "tests/common/surfaces.h"

namespace cirque {
namespace {

CornerUv UvOf(const Surface& s) {
  CornerUv uv;
  for (const Index v : s.triangulation.vertex) uv.value.push_back(s.position[v].head<2>());
  return uv;
}

void MoveVertex(const Surface& s, Index v, const Eigen::Vector2d& to, CornerUv* uv) {
  for (Index h = 0; h < s.triangulation.num_halfedges(); ++h) {
    if (s.triangulation.vertex[h] == v) uv->value[h] = to;
  }
}

TEST(Injectivity, FlatFanIsInjective) {
  const Surface fan = Fan(7, 0);
  EXPECT_TRUE(FlippedFaces(fan.triangulation, UvOf(fan)).empty());
  EXPECT_EQ(FindBoundaryContact(fan.triangulation, UvOf(fan)), BoundaryContact::kApart);
}

TEST(Injectivity, CollapsedAndReflectedFacesAreFlipped) {
  const Surface fan = Fan(6, 0);
  CornerUv uv = UvOf(fan);
  MoveVertex(fan, 0, fan.position[1].head<2>(),
             &uv);  // the centre onto the rim: two faces collapse
  EXPECT_EQ(FlippedFaces(fan.triangulation, uv), (std::vector<Index>{0, 5}));
  for (Eigen::Vector2d& p : uv.value) p.x() = -p.x();
  EXPECT_EQ(FlippedFaces(fan.triangulation, uv).size(), 6u);
}

TEST(Injectivity, RimFoldedThroughItselfCrossesAndOneThatMeetsItselfTouches) {
  const Surface fan = Fan(8, 0);
  CornerUv uv = UvOf(fan);
  MoveVertex(fan, 1, Eigen::Vector2d(-2, 0.1), &uv);
  EXPECT_EQ(FindBoundaryContact(fan.triangulation, uv), BoundaryContact::kCrossing);
  MoveVertex(fan, 1, fan.position[5].head<2>(), &uv);
  EXPECT_EQ(FindBoundaryContact(fan.triangulation, uv), BoundaryContact::kTouch);
}

}  // namespace
}  // namespace cirque
