#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "cirque/layout/sphere_chart.h"

#include "tests/common/surfaces.h"

namespace cirque {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

Vector3d PointAt(const Vector2d& uv) {
  const double longitude = 2 * kPi * (uv.x() - 0.5), latitude = kPi * (uv.y() - 0.5);
  return {std::cos(latitude) * std::cos(longitude), std::cos(latitude) * std::sin(longitude),
          std::sin(latitude)};
}

TEST(LatLongTest, EveryCornerIsThePointOfItsVertex) {
  const Surface sphere = GeneratedSurface("sphere", 2000);
  const LatLong latlong = LatLongUv(sphere.triangulation, sphere.position);
  for (Index h = 0; h < sphere.triangulation.num_halfedges(); ++h) {
    const Vector3d& x = sphere.position[sphere.triangulation.vertex[h]];
    EXPECT_LT((PointAt(latlong.uv.value[h]) - x).norm(), 1e-12);
  }
}

TEST(LatLongTest, NoTriangleIsSmearedAcrossTheSeam) {
  const Surface sphere = GeneratedSurface("sphere", 2000);
  const LatLong latlong = LatLongUv(sphere.triangulation, sphere.position);
  EXPECT_LE(latlong.at_poles.size(), 1u);  // (0, 0, -1) is a vertex, (0, 0, 1) hardly
  double area = 0;
  for (Index f = 0; f < sphere.triangulation.num_faces(); ++f) {
    const auto* uv = &latlong.uv.value[3 * f];
    const Vector2d a = uv[1] - uv[0], b = uv[2] - uv[0];
    area += 0.5 * (a.x() * b.y() - a.y() * b.x());
    const auto& at_poles = latlong.at_poles;
    if (std::find(at_poles.begin(), at_poles.end(), f) != at_poles.end()) continue;
    const auto [least, most] = std::minmax({uv[0].x(), uv[1].x(), uv[2].x()});
    EXPECT_LE(most - least, 0.5 + 1e-12) << f;
  }
  // All triangles together cover the unit square once, but for gaps at the poles of about a
  // triangle's height, 0.03; smeared ones would take away their widths.
  EXPECT_NEAR(area, 1, 0.06);
}

TEST(LatLongTest, TheTextureOpensAlongTheDateLineAlone) {
  const Surface sphere = GeneratedSurface("sphere", 2000);
  const Triangulation& t = sphere.triangulation;
  const LatLong latlong = LatLongUv(t, sphere.position);
  int opened = 0;
  for (Index h = 0; h < t.num_halfedges(); ++h) {
    const auto& uv = latlong.uv.value;
    const Index g = t.twin[h];
    const Vector2d at_tail = uv[Triangulation::Next(h)] - uv[Triangulation::Prev(g)];
    const Vector2d at_tip = uv[Triangulation::Prev(h)] - uv[Triangulation::Next(g)];
    if (std::max(sphere.position[t.Tail(h)].z(), sphere.position[t.Tip(h)].z()) > 0.99) continue;
    if (std::min(sphere.position[t.Tail(h)].z(), sphere.position[t.Tip(h)].z()) < -0.99) continue;
    const bool is_open = at_tail != Vector2d(0, 0);
    opened += is_open;
    EXPECT_LT((at_tail - at_tip).norm(), 1e-15);
    EXPECT_NEAR(std::abs(at_tail.x()), is_open ? 1 : 0, 1e-15);
  }
  // About one edge for every triangle's height from pole to pole, both of its halfedges.
  EXPECT_GT(opened, 40);
  EXPECT_LT(opened, 160);
}

TEST(LatLongTest, ACornerAtAPoleTakesTheMeanLongitude) {
  const Surface octahedron = RegularPolyhedron(8);
  const LatLong latlong = LatLongUv(octahedron.triangulation, octahedron.position);
  EXPECT_TRUE(latlong.at_poles.empty());
  for (Index f = 0; f < 8; ++f) {
    const auto* uv = &latlong.uv.value[3 * f];
    double sum = 0, of_pole = 0;
    for (int k = 0; k < 3; ++k) {
      const bool at_pole =
          std::abs(octahedron.position[octahedron.triangulation.vertex[3 * f + k]].z()) == 1;
      (at_pole ? of_pole : sum) += uv[k].x();
    }
    EXPECT_NEAR(of_pole, sum / 2, 1e-15);
  }
}

}  // namespace
}  // namespace cirque
