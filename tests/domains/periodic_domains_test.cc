// Annuli, strips and tori of known modulus.
#include <algorithm>
#include <cmath>
#include <complex>
#include <set>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cirque/domains/domain.h"
#include "cirque/io/polygon_soup.h"
#include "cirque/math/lattice.h"
#include "cirque/metrics/injectivity.h"

#include "tests/common/domain_maps.h"
#include "tests/common/grid_surface.h"
#include "tests/common/surfaces.h"

namespace cirque {
namespace {

using Complex = std::complex<double>;
using ::testing::HasSubstr;

/// The ring between two circles of radii 1 and r, the inner one about (shift, 0): the image of a
/// concentric one under z -> (z + c) / (1 + c z), so that the grid is fine where the ring is thin.
Surface EccentricRing(double r, double shift, int around, int across) {
  // c with (c + q) / (1 + c q) = shift + r and (c - q) / (1 - c q) = shift - r.
  const double a = shift + r, b = shift - r;
  const double s = 1 + a * b, d = a + b, c = (s - std::sqrt(s * s - d * d)) / d;
  const double q = (a - c) / (1 - a * c);
  return Grid(around, across, false, [=](double angle, double t) {
    const Complex z = std::polar(std::pow(q, 1 - t), -angle), w = (z + c) / (1.0 + c * z);
    return Eigen::Vector3d(w.real(), -w.imag(), 0);
  });
}

/// log(R / r) / (2 pi) of the round annulus that a ring between the unit circle and one of radius r
/// about (shift, 0) is conformal to: arcosh((1 + r^2 - shift^2) / (2 r)) (any text on bipolar coordinates).
double EccentricModulus(double r, double shift) {
  return std::acosh((1 + r * r - shift * shift) / (2 * r)) / (2 * kPi);
}

SurfaceMap MustMapTo(const char* domain, const Surface& surface) {
  return MustMap(surface, RequestFor(domain));
}

TEST(MapToAnnulus, HasTheModulusOfAConcentricRing) {
  double before = 1;
  for (const Index triangles : {500, 2000, 8000}) {
    const SurfaceMap map = MustMapTo("annulus", GeneratedSurface("annulus", triangles));
    const double error =
        std::abs(*map.certificate.periodic->annulus_modulus / (std::log(1 / 0.4) / (2 * kPi)) - 1);
    EXPECT_LT(error, 0.6 * before) << triangles;
    before = error;
  }
  EXPECT_LT(before, 2e-3);
}

TEST(MapToAnnulus, HasTheModulusOfAnEccentricRing) {
  double before = 1;
  for (const int n : {1, 2, 4}) {
    const SurfaceMap map = MustMapTo("annulus", EccentricRing(0.3, 0.4, 24 * n, 6 * n));
    const double error =
        std::abs(*map.certificate.periodic->annulus_modulus / EccentricModulus(0.3, 0.4) - 1);
    EXPECT_LT(error, 0.6 * before) << n;
    before = error;
  }
  EXPECT_LT(before, 2e-4);
}

TEST(MapToAnnulus, PutsTheBoundaryOnTheCirclesAndCoversTheRingOnce) {
  const Surface catenoid = GeneratedSurface("catenoid", 2000);
  const Triangulation& t = catenoid.triangulation;
  const SurfaceMap map = MustMapTo("annulus", catenoid);
  const PeriodicSummary& periodic = *map.certificate.periodic;
  EXPECT_NEAR(-std::log(*periodic.inner_radius), 2.4, 0.02);
  EXPECT_LT(*periodic.circle_error, 1e-15);
  EXPECT_TRUE(map.cut.IsEmpty());
  EXPECT_EQ(map.certificate.seams->seams, 0);
  EXPECT_TRUE(FlippedFaces(t, map.uv).empty());
  EXPECT_FALSE(OverlapsItself(t, map.uv));
  const std::vector<std::vector<Index>> loops = BoundaryLoops(t);
  std::set<int> circles;
  for (const std::vector<Index>& loop : loops) {
    const double radius = map.uv.value[Triangulation::Next(loop[0])].norm();
    circles.insert(radius > 0.99);
    const double wanted = radius > 0.99 ? 1 : *periodic.inner_radius;
    for (const Index h : loop) {
      EXPECT_NEAR(map.uv.value[Triangulation::Next(h)].norm(), wanted, 1e-15);
    }
  }
  EXPECT_EQ(circles.size(), 2u);
  // One place a vertex.
  std::vector<Eigen::Vector2d> place(t.num_vertices, {9, 9});
  for (Index h = 0; h < t.num_halfedges(); ++h) {
    Eigen::Vector2d& at = place[t.vertex[h]];
    if (at.x() == 9) at = map.uv.value[h];
    EXPECT_EQ(at, map.uv.value[h]);
  }
}

/// The differences between the places of single vertices.
std::vector<Eigen::Vector2d> Jumps(const Triangulation& t, const CornerUv& uv) {
  std::vector<Index> first(t.num_vertices, kNone);
  std::vector<Eigen::Vector2d> jumps;
  for (Index h = 0; h < t.num_halfedges(); ++h) {
    if (first[t.vertex[h]] == kNone) first[t.vertex[h]] = h;
    const Eigen::Vector2d jump = uv.value[h] - uv.value[first[t.vertex[h]]];
    if (jump != Eigen::Vector2d::Zero()) jumps.push_back(jump);
  }
  return jumps;
}

TEST(MapToStrip, IsStraightAndPeriodicToTheLastBit) {
  const Surface ring = GeneratedSurface("annulus", 1000);
  const Triangulation& t = ring.triangulation;
  const SurfaceMap map = MustMapTo("strip", ring);
  const double period = *map.certificate.periodic->strip_period;
  EXPECT_NEAR(1 / period, std::log(1 / 0.4) / (2 * kPi), 1e-3);
  EXPECT_EQ(*map.certificate.periodic->annulus_modulus, 1 / period);
  EXPECT_LT(map.certificate.periodic->period_mismatch, 1e-8);
  const std::vector<Eigen::Vector2d> jumps = Jumps(t, map.uv);
  EXPECT_FALSE(jumps.empty());
  for (const Eigen::Vector2d& jump : jumps) {
    EXPECT_EQ(std::abs(jump.x()), period);
    EXPECT_EQ(jump.y(), 0);
  }
  // The outer circle, which is longer, lies at y = 0.
  for (const std::vector<Index>& loop : BoundaryLoops(t)) {
    for (const Index h : loop) {
      const bool outer = ring.position[t.Tail(h)].head<2>().norm() > 0.7;
      EXPECT_EQ(map.uv.value[Triangulation::Next(h)].y(), outer ? 0 : 1);
    }
  }
  EXPECT_EQ(map.certificate.overlap, "injective");
}

TEST(MapToTorus, HasTheModulusOfATorusOfRevolution) {
  double before = 1;
  for (const int n : {1, 2, 4}) {
    const Surface torus = Grid(20 * n, 12 * n, true, [](double p, double s) {
      const double q = 2 * kPi * s, out = 1 + 0.4 * std::cos(q);
      return Eigen::Vector3d(out * std::cos(p), out * std::sin(p), 0.4 * std::sin(q));
    });
    const SurfaceMap map = MustMapTo("torus", torus);
    const PeriodicSummary& periodic = *map.certificate.periodic;
    const Complex tau(*periodic.modulus_real, *periodic.modulus_imaginary);
    const double error = std::abs(tau / Complex(0, std::sqrt(1 / 0.16 - 1)) - 1.0);
    EXPECT_LT(error, 0.4 * before) << n;
    before = error;
  }
  EXPECT_LT(before, 5e-3);
}

TEST(MapToTorus, DiffersAtSeamsByWholePeriodsToTheLastBit) {
  const Surface torus = GeneratedSurface("torus", 1500);
  const SurfaceMap map = MustMapTo("torus", torus);
  const PeriodicSummary& periodic = *map.certificate.periodic;
  const Complex tau(*periodic.modulus_real, *periodic.modulus_imaginary);
  EXPECT_LE(std::abs(tau.real()), 0.5);
  EXPECT_GE(std::abs(tau), 1);
  const Lattice lattice{1, tau};
  bool along[2] = {false, false};
  for (const Eigen::Vector2d& jump : Jumps(torus.triangulation, map.uv)) {
    const auto [a, b] = lattice.Coordinates({jump.x(), jump.y()});
    EXPECT_EQ(jump.x(), std::round(a) + std::round(b) * tau.real());
    EXPECT_EQ(jump.y(), std::round(b) * tau.imag());
    along[0] = along[0] || std::round(a) != 0;
    along[1] = along[1] || std::round(b) != 0;
  }
  EXPECT_TRUE(along[0] && along[1]);
  EXPECT_EQ(map.certificate.overlap, "injective");
  // Its cell is 1 x Im tau, and all of the image.
  double twice = 0;
  for (std::size_t h = 0; h < map.uv.value.size(); h += 3) {
    const Eigen::Vector2d a = map.uv.value[h + 1] - map.uv.value[h];
    const Eigen::Vector2d b = map.uv.value[h + 2] - map.uv.value[h];
    twice += a.x() * b.y() - a.y() * b.x();
  }
  EXPECT_NEAR(twice / 2, tau.imag(), 1e-9);
}

TEST(PeriodicDomains, RefuseOtherTopology) {
  for (const auto& [domain, surface] : {std::pair("annulus", GeneratedSurface("hemisphere", 100)),
                                        {"strip", GeneratedSurface("torus", 400)},
                                        {"torus", GeneratedSurface("blob", 100)},
                                        {"torus", GeneratedSurface("annulus", 100)}}) {
    const Certificate failed = MustFail(surface, RequestFor(domain), StatusCode::kInvalidInput);
    EXPECT_THAT(failed.message, HasSubstr("boundary loops")) << domain;
  }
}

// Three corners on the inner circle just inside the middles of three straight sides.
TEST(MapToAnnulus, SaysWhereTrianglesAreTooLargeToBeWound) {
  const Surface coarse = Grid(3, 1, false, [](double angle, double t) {
    const double turned = angle - kPi / 3 * t;
    return Eigen::Vector3d(std::cos(turned), std::sin(turned), 0.1 * t);
  });
  const Certificate failed = MustFail(coarse, RequestFor("annulus"), StatusCode::kUnrepresentable);
  EXPECT_THAT(failed.message, HasSubstr("map to a strip"));
  EXPECT_GT(failed.layout->flipped_triangles, 0);
}

}  // namespace
}  // namespace cirque
