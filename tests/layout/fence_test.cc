#include "cirque/layout/fence.h"

#include <cmath>
#include <complex>
#include <limits>
#include <vector>

#include <gtest/gtest.h>

#include "cirque/intrinsic/intrinsic_surface.h"
#include "cirque/layout/refine_map.h"
#include "cirque/metrics/injectivity.h"

#include "tests/layout/coiled_strip.h"

namespace cirque {
namespace {

using Complex = std::complex<double>;

/// A closed polygon through the points in their order.
Fence Around(Index count) {
  Fence fence;
  for (Index v = 0; v < count; ++v) fence.sides.push_back({v, (v + 1) % count});
  return fence;
}

Eigen::VectorXcd Points(const std::vector<Complex>& points) {
  return Eigen::Map<const Eigen::VectorXcd>(points.data(),
                                            static_cast<Eigen::Index>(points.size()));
}

/// A square of side 4 with a notch from above whose tip is 1/2 from its lower side.
const std::vector<Complex> kNotched = {{0, 0},   {4, 0},   {4, 4}, {2.5, 4},
                                       {2, 0.5}, {1.5, 4}, {0, 4}};

TEST(Fence, FindsTheNearestPointsWithinReach) {
  const Eigen::VectorXcd z = Points(kNotched);
  Fence fence = Around(7);
  fence.SetReach(z, 0.2);
  const std::vector<Contact> contacts = fence.Contacts(z);
  ASSERT_EQ(contacts.size(), 1u);  // the ends of the notch are farther from each other's sides
  EXPECT_EQ(contacts[0].vertex, 4);
  EXPECT_EQ(contacts[0].tail, 0);
  EXPECT_EQ(contacts[0].tip, 1);
  EXPECT_DOUBLE_EQ(contacts[0].along, 0.5);
  EXPECT_DOUBLE_EQ(contacts[0].distance, 0.5);
  EXPECT_NEAR(std::abs(contacts[0].away - Complex(0, 1)), 0, 1e-15);
  EXPECT_DOUBLE_EQ(contacts[0].reach, 0.2 * std::hypot(0.5, 3.5));
  fence.weight = 3;
  EXPECT_NEAR(fence.Value(z), 3 * std::pow(contacts[0].reach / 0.5 - 1, 2), 1e-14);
  fence.SetReach(z, 0.1);
  EXPECT_TRUE(fence.Contacts(z).empty());
  EXPECT_EQ(fence.Value(z), 0);
}

TEST(Fence, IsInfinitelyHighWhereTheBoundaryTouchesItself) {
  std::vector<Complex> touching = kNotched;
  touching[4] = {2, 0};
  Fence fence = Around(7);
  fence.SetReach(Points(touching), 0.2);
  fence.weight = 1;
  EXPECT_EQ(fence.Value(Points(touching)), std::numeric_limits<double>::infinity());
  EXPECT_FALSE(fence.IsCrossed(Points(touching)));
}

TEST(Fence, IsCrossedExactlyWhereTheImageOverlaps) {
  const Fence fence = Around(7);
  EXPECT_FALSE(fence.IsCrossed(Points(kNotched)));
  std::vector<Complex> crossing = kNotched;
  crossing[4] = {2, -1e-300};
  EXPECT_TRUE(fence.IsCrossed(Points(crossing)));
}

MapRefinement Refine(const CoiledStrip& coil, bool injective, CornerUv* uv) {
  const IntrinsicSurface surface = MeasureSurface(coil.strip.triangulation, coil.lengths);
  SeamedSurface of = {surface, coil.none, {}};
  of.injective = injective;
  *uv = coil.start;
  const auto done =
      RefineStretch(of, *StretchEnergies().Find("symmetric_dirichlet"), {}, nullptr, uv);
  EXPECT_TRUE(done.ok());
  return *done;
}

TEST(RefineStretch, OfAnImageThatIsToStayInjectiveRefusesStepsThatOverlap) {
  const CoiledStrip coil;
  const Triangulation& t = coil.strip.triangulation;
  ASSERT_FALSE(OverlapsItself(t, coil.start));
  CornerUv free, fenced;
  const MapRefinement without = Refine(coil, false, &free), with = Refine(coil, true, &fenced);
  EXPECT_TRUE(OverlapsItself(t, free));
  EXPECT_LT(without.after, 1e-6);
  EXPECT_FALSE(OverlapsItself(t, fenced));
  EXPECT_TRUE(FlippedFaces(t, fenced).empty());
  // The ends meet, and the rest goes on towards the least energy beside that.
  EXPECT_LT(with.after, 0.5 * with.before);
  EXPECT_GT(with.after, without.after);
}

TEST(RefineMap, OfAnImageThatIsToStayInjectiveDoesToo) {
  const CoiledStrip coil;
  const IntrinsicSurface surface = MeasureSurface(coil.strip.triangulation, coil.lengths);
  for (const bool injective : {false, true}) {
    SeamedSurface of = {surface, coil.none, {}};
    of.injective = injective;
    CornerUv uv = coil.start;
    const auto done = RefineMap(of, *MapObjectives().Find("mips"), {.decrease = 0}, nullptr, &uv);
    ASSERT_TRUE(done.ok());
    EXPECT_EQ(OverlapsItself(coil.strip.triangulation, uv), !injective);
    EXPECT_LE(done->after, done->before);
  }
}

}  // namespace
}  // namespace cirque
