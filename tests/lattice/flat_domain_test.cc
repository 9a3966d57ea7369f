#include "cirque/lattice/flat_domain.h"

#include <cmath>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "cirque/mesh/surface.h"

#include "tests/common/surfaces.h"

namespace cirque {
namespace {

FlatDomain DomainOf(const Surface& surface) {
  return {surface.triangulation, MeasureEdgeLengths(surface)};
}

/// Where a point of a flat strip's domain is on the strip.
Eigen::Vector2d OnStrip(const FlatDomain& domain, const Surface& strip, const FlatPoint& point) {
  const Eigen::Vector3d weight = domain.Barycentric(point);
  Eigen::Vector2d at(0, 0);
  for (Index k = 0; k < 3; ++k) {
    at += weight[k] * strip.position[strip.triangulation.vertex[3 * point.face + k]].head<2>();
  }
  return at;
}

TEST(FlatDomain, StraightWaysAreThoseOfThePlane) {
  const Surface strip = FlatStrip(6, 4);
  const FlatDomain domain = DomainOf(strip);
  EXPECT_NEAR(domain.area(), 24, 1e-12);
  const FlatPoint centre = {0, (domain.Corner(0) + domain.Corner(1) + domain.Corner(2)) / 3};
  const Eigen::Vector2d from = OnStrip(domain, strip, centre);
  // The frame of face 0 is turned against the plane by what takes its first side there.
  const Eigen::Vector2d side = strip.position[strip.triangulation.vertex[1]].head<2>() -
                               strip.position[strip.triangulation.vertex[0]].head<2>();
  const double turn = std::atan2(side.y(), side.x());
  for (int i = 0; i < 40; ++i) {
    const Eigen::Vector2d target(0.1 + 5.8 * std::fmod(0.37 * i, 1),
                                 0.1 + 3.8 * std::fmod(0.61 * i, 1));
    const Eigen::Vector2d step = Eigen::Rotation2Dd(-turn) * (target - from);
    const auto arrival = domain.Trace(centre, centre.at + step);
    ASSERT_TRUE(arrival) << i;
    EXPECT_LT((OnStrip(domain, strip, arrival->point) - target).norm(), 1e-12) << i;
    EXPECT_LT((arrival->back(arrival->point.at) - centre.at - step).norm(), 1e-12) << i;
    EXPECT_GE(domain.Barycentric(arrival->point).minCoeff(), -1e-10);
  }
  EXPECT_FALSE(domain.Trace(centre, centre.at + Eigen::Vector2d(30, 1)));
}

TEST(FlatDomain, WaysBeginAtVertices) {
  const Surface strip = FlatStrip(6, 4);
  const FlatDomain domain = DomainOf(strip);
  const Triangulation& t = strip.triangulation;
  for (Index c = 0; c < t.num_halfedges(); ++c) {
    if (domain.IsOnBoundary(t.vertex[c])) continue;
    const FlatPoint start = {Triangulation::Face(c), domain.Corner(c)};
    for (int i = 0; i < 16; ++i) {  // also along edges
      const double angle = i * kPi / 8;
      const Eigen::Vector2d step = 0.9 * Eigen::Vector2d(std::cos(angle), std::sin(angle));
      const auto arrival = domain.Trace(start, start.at + step);
      ASSERT_TRUE(arrival) << c << " " << i;
      EXPECT_NEAR(
          (OnStrip(domain, strip, arrival->point) - strip.position[t.vertex[c]].head<2>()).norm(),
          0.9, 1e-12);
    }
  }
}

TEST(FlatDomain, KnowsConesAndLoops) {
  const FlatDomain cube = DomainOf(RegularPolyhedron(8));
  for (Index v = 0; v < 6; ++v) EXPECT_TRUE(cube.IsCone(v));
  EXPECT_TRUE(cube.loops().empty());
  const FlatDomain strip = DomainOf(FlatStrip(6, 4));
  for (Index v = 0; v < strip.triangulation().num_vertices; ++v) EXPECT_FALSE(strip.IsCone(v));
  ASSERT_EQ(strip.loops().size(), 1U);
  EXPECT_NEAR(strip.loops()[0].length(), 20, 1e-12);
}

TEST(FlatDomain, GoesAlongLoopsEitherWayAndRound) {
  const Surface strip = FlatStrip(6, 4);
  const FlatDomain domain = DomainOf(strip);
  for (const double from : {0., 0.5, 3., 19.75}) {
    for (const double to : {0.25, 7.5, 19., 21.5, -1.5}) {
      const FlatPoint start = domain.OnLoop(0, from);
      const FlatDomain::Arrival arrival = domain.AlongLoop(0, from, to);
      const Eigen::Vector2d a = OnStrip(domain, strip, start);
      const Eigen::Vector2d b = OnStrip(domain, strip, arrival.point);
      // In the plane nothing turns: the frame leads back to where the point is.
      EXPECT_NEAR((arrival.back(arrival.point.at) - start.at).norm(), (a - b).norm(), 1e-12);
      const FlatDomain::Arrival home = domain.AlongLoop(0, to, from);
      EXPECT_LT((arrival.back * home.back)(start.at).x() - start.at.x(), 1e-12);
    }
  }
}

}  // namespace
}  // namespace cirque
