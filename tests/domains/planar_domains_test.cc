#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "cirque/domains/domain.h"
#include "cirque/metrics/injectivity.h"

#include "tests/common/domain_maps.h"
#include "tests/common/surfaces.h"

namespace cirque {
namespace {

/// Vertex (i, j) of FlatStrip(columns, rows).
Index At(int columns, int i, int j) { return j * (columns + 1) + i; }

std::vector<Index> StripCorners(int columns, int rows) {
  return {At(columns, 0, 0), At(columns, columns, 0), At(columns, columns, rows),
          At(columns, 0, rows)};
}

std::vector<double> AngleSums(const Surface& surface, const CornerUv& uv) {
  std::vector<double> sums(surface.triangulation.num_vertices, 0);
  for (Index h = 0; h < surface.triangulation.num_halfedges(); ++h) {
    const Eigen::Vector2d a = uv.value[Triangulation::Next(h)] - uv.value[h];
    const Eigen::Vector2d b = uv.value[Triangulation::Prev(h)] - uv.value[h];
    sums[surface.triangulation.vertex[h]] += std::atan2(a.x() * b.y() - a.y() * b.x(), a.dot(b));
  }
  return sums;
}

TEST(RectangleDomain, RectangularGridHasItsOwnModulus) {
  const Surface strip = FlatStrip(12, 4);  // whose diagonals are on the verge of Delaunay
  DomainOptions domain;
  domain.corners = StripCorners(12, 4);
  const SurfaceMap map = MustMap(strip, RequestFor("rectangle", domain));
  EXPECT_NEAR(*map.certificate.polygon->conformal_modulus, 3, 1e-14);
  for (Index h = 0; h < strip.triangulation.num_halfedges(); ++h) {
    const Eigen::Vector3d& p = strip.position[strip.triangulation.vertex[h]];
    EXPECT_NEAR(map.uv.value[h].x(), p.x() / 4, 1e-14);
    EXPECT_NEAR(map.uv.value[h].y(), p.y() / 4, 1e-14);
  }
}

TEST(RectangleDomain, OppositeCornersTurnTheModulusOver) {
  const Surface surface = GeneratedSurface("hemisphere", 800);
  const std::vector<Index> loop = BoundaryLoops(surface.triangulation).front();
  DomainOptions domain;
  for (const std::size_t k : {0, 9, 20, 31}) {
    domain.corners.push_back(surface.triangulation.Tail(loop[k % loop.size()]));
  }
  const SurfaceMap map = MustMap(surface, RequestFor("rectangle", domain));
  std::rotate(domain.corners.begin(), domain.corners.begin() + 1, domain.corners.end());
  const SurfaceMap turned = MustMap(surface, RequestFor("rectangle", domain));
  const double modulus = *map.certificate.polygon->conformal_modulus;
  EXPECT_NEAR(modulus * *turned.certificate.polygon->conformal_modulus, 1, 1e-9);
  EXPECT_TRUE(FlippedFaces(surface.triangulation, map.uv).empty());
  // On the sides exactly, in the given order.
  const std::vector<bool> boundary = BoundaryVertices(surface.triangulation);
  for (Index h = 0; h < surface.triangulation.num_halfedges(); ++h) {
    if (!boundary[surface.triangulation.vertex[h]]) continue;
    const Eigen::Vector2d& p = map.uv.value[h];
    EXPECT_TRUE(p.x() == 0 || p.x() == modulus || p.y() == 0 || p.y() == 1);
  }
}

TEST(PolygonDomain, CornersHaveEqualAnglesAndSidesAreStraight) {
  const Surface surface = GeneratedSurface("hemisphere", 700);
  for (const int sides : {3, 5, 6}) {
    DomainOptions domain;
    domain.sides = sides;
    const SurfaceMap map = MustMap(surface, RequestFor("polygon", domain));
    const std::vector<double> sums = AngleSums(surface, map.uv);
    const std::vector<bool> boundary = BoundaryVertices(surface.triangulation);
    int corners = 0;
    for (Index v = 0; v < surface.triangulation.num_vertices; ++v) {
      const bool corner = boundary[v] && std::abs(sums[v] - kPi) > 0.1;
      corners += corner ? 1 : 0;
      const double wanted = !boundary[v] ? 2 * kPi : (corner ? kPi * (1 - 2.0 / sides) : kPi);
      EXPECT_NEAR(sums[v], wanted, 1e-8);
    }
    EXPECT_EQ(corners, sides);
    const Certificate& certificate = map.certificate;
    EXPECT_LT(certificate.polygon->longest_side / certificate.polygon->shortest_side, 1.5);
    if (sides == 3) {
      EXPECT_NEAR(certificate.polygon->longest_side, certificate.polygon->shortest_side, 1e-9);
    }
  }
}

TEST(PolygonDomain, ExteriorAnglesAreFollowed) {
  const Surface surface = GeneratedSurface("hemisphere", 500);
  const std::vector<Index> loop = BoundaryLoops(surface.triangulation).front();
  ConeTargets targets = FreeBoundaryTargets(surface.triangulation);
  const double exterior[] = {0.9, 0.7, -0.3, 0.7};  // in pi: they add up to 2
  for (int k = 0; k < 4; ++k) {
    const Index v = surface.triangulation.Tail(loop[loop.size() * k / 4]);
    targets.lower[v] = targets.upper[v] = kPi * (1 - exterior[k]);
  }
  MapRequest request = RequestFor("polygon");
  request.targets = targets;
  const SurfaceMap map = MustMap(surface, request);
  const std::vector<double> sums = AngleSums(surface, map.uv);
  for (int k = 0; k < 4; ++k) {
    const Index v = surface.triangulation.Tail(loop[loop.size() * k / 4]);
    EXPECT_NEAR(sums[v], kPi * (1 - exterior[k]), 1e-8);
  }
  request.targets->lower[surface.triangulation.Tail(loop[0])] = 0.5;  // no more 2 pi in all
  request.targets->upper[surface.triangulation.Tail(loop[0])] = 0.5;
  MustFail(surface, request, StatusCode::kInfeasible);
}

TEST(PolygonDomain, BadCornersAreRefused) {
  const Surface surface = GeneratedSurface("hemisphere", 200);
  const std::vector<bool> boundary = BoundaryVertices(surface.triangulation);
  std::vector<Index> on, inside;
  for (Index v = 0; v < surface.triangulation.num_vertices; ++v) {
    (boundary[v] ? on : inside).push_back(v);
  }
  const auto code = [&](std::vector<Index> corners) {
    DomainOptions domain;
    domain.corners = std::move(corners);
    return MapSurface(surface, RequestFor("rectangle", domain)).status().code();
  };
  EXPECT_EQ(code({on[0], on[3], on[6], on[9]}), StatusCode::kOk);
  EXPECT_EQ(code({on[0], on[3], on[6]}), StatusCode::kInvalidInput);
  EXPECT_EQ(code({on[0], on[3], on[6], on[6]}), StatusCode::kInvalidInput);
  EXPECT_EQ(code({on[0], on[3], on[6], inside[0]}), StatusCode::kInvalidInput);
  DomainOptions domain;
  domain.sides = 2;
  MustFail(surface, RequestFor("polygon", domain), StatusCode::kInvalidInput);
  MustFail(GeneratedSurface("annulus", 100), RequestFor("rectangle"), StatusCode::kInvalidInput);
}

}  // namespace
}  // namespace cirque
