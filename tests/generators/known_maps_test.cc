#include "cirque/generators/known_maps.h"

#include <cmath>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "cirque/generators/generators.h"

namespace cirque {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

class EveryKnownMap : public testing::TestWithParam<std::string> {
 protected:
  ConformalMap map() const { return *KnownConformalMaps().Find(GetParam()); }
  PolygonSoup mesh() const { return *GenerateMesh(GetParam(), {600, 1}); }
};

TEST_P(EveryKnownMap, GoesThereAndBack) {
  for (const Vector3d& p : mesh().position) {
    if (p == Vector3d(0, 0, -1)) continue;  // the sphere's pole
    const Vector2d w = map().to_plane(p);
    ASSERT_LT((map().to_surface(w) - p).norm(), 1e-12) << p.transpose();
    ASSERT_LT((map().to_plane(map().to_surface(w)) - w).norm(), 1e-12 * std::max(1., w.norm()));
  }
}

TEST_P(EveryKnownMap, KeepsAngles) {
  for (const Vector3d& p : mesh().position) {
    if (p == Vector3d(0, 0, -1)) continue;
    const Vector2d w = map().to_plane(p);
    const double step = 1e-6 * std::max(1e-3, w.norm());
    const auto difference = [&](const Vector2d& d) -> Vector3d {
      return (map().to_surface(w + step * d) - map().to_surface(w - step * d)) / (2 * step);
    };
    const Vector3d du = difference({1, 0}), dv = difference({0, 1});
    const double stretch = du.norm();
    ASSERT_GT(stretch, 0);
    ASSERT_NEAR(dv.norm() / stretch, 1, 1e-5) << p.transpose();
    ASSERT_NEAR(du.dot(dv) / (stretch * stretch), 0, 1e-5) << p.transpose();
  }
}

INSTANTIATE_TEST_SUITE_P(Registry, EveryKnownMap, testing::ValuesIn(KnownConformalMaps().Names()),
                         [](const auto& name) { return name.param; });

TEST(KnownMaps, TakeKnownValues) {
  EXPECT_LT((StereographicMap().to_plane({1, 0, 0}) - Vector2d(1, 0)).norm(), 1e-15);
  EXPECT_LT((StereographicMap().to_surface({0, 1}) - Vector3d(0, 1, 0)).norm(), 1e-15);
  EXPECT_LT((EnneperMap().to_surface({1, 0}) - Vector3d(2. / 3, 0, 1)).norm(), 1e-15);
  EXPECT_LT((EnneperMap().to_plane({0, 2. / 3, -1}) - Vector2d(0, 1)).norm(), 1e-14);
  EXPECT_LT((CappedTubeMap().to_plane({0, 1, -2}) - Vector2d(0, std::exp(2))).norm(), 1e-14);
  EXPECT_LT((CatenoidMap().to_surface({1, 0}) - Vector3d(1, 0, 0)).norm(), 1e-15);
  EXPECT_LT((TorusMap().to_plane({0, 1.4, 0}) - Vector2d(kPi / 2, 0)).norm(), 1e-15);
  // Half way around the tube lies half a period away; the ratio of the periods is known.
  EXPECT_NEAR(std::abs(TorusMap().to_plane({0.6, 0, 0}).y()), TorusPeriods().y() / 2, 1e-14);
  EXPECT_NEAR(TorusPeriods().x() / TorusPeriods().y(), std::sqrt(1 / 0.16 - 1), 1e-14);
}

TEST(KnownMaps, TakePointsNearTheSurface) {
  // A chord's midpoint lies 1/2 h^2/4 inside the sphere, and goes where its radial image goes.
  const Vector3d a = StereographicMap().to_surface({0.2, 0.1});
  const Vector3d b = StereographicMap().to_surface({0.21, 0.1});
  const Vector3d middle = (a + b) / 2;
  EXPECT_LT((StereographicMap().to_plane(middle) - StereographicMap().to_plane(middle.normalized()))
                .norm(),
            1e-15);
  const Vector2d near_enneper =
      EnneperMap().to_plane(EnneperMap().to_surface({0.5, 0.4}) + Vector3d(0, 0, 1e-3));
  EXPECT_LT((near_enneper - Vector2d(0.5, 0.4)).norm(), 1e-3);
}

}  // namespace
}  // namespace cirque
