// Exact maps to the strip, the annulus and the torus: judged by the independent judge, held against
// surfaces of known maps, their seams to the last bit.
#include <algorithm>
#include <cmath>
#include <complex>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cirque/domains/domain.h"
#include "cirque/math/lattice.h"
#include "cirque/metrics/injectivity.h"

#include "tests/common/domain_maps.h"
#include "tests/common/exact_maps.h"
#include "tests/common/grid_surface.h"
#include "tests/common/surfaces.h"

namespace cirque {
namespace {

MapRequest ExactRequest(const std::string& domain, PatternKind pattern = PatternKind::kCircle) {
  MapRequest request = RequestFor(domain);
  request.options.exact = true;
  request.options.pattern = pattern;
  return request;
}

/// The wall of a prism of n sides and height 3, of quads that are cut in two: flat.
Surface Prism(int n) {
  return Grid(n, 4, false, [](double angle, double part) {
    return Eigen::Vector3d(std::cos(angle), std::sin(angle), 3 * part);
  });
}

/// Twisted, so that diagonals are long.
Surface Twisted(const Surface& surface, double turn) {
  return Moved(surface, [&](const Eigen::Vector3d& x) {
    const double angle = turn * x.z();
    const std::complex<double> z = std::complex<double>(x.x(), x.y()) * std::polar(1.0, angle);
    return Eigen::Vector3d(z.real(), z.imag(), x.z());
  });
}

Surface LongTriangles(const std::string& domain) {
  const std::string generator = domain == "torus" ? "torus" : "catenoid";
  return Moved(GeneratedSurface(generator, 900), [](const Eigen::Vector3d& x) {
    return Eigen::Vector3d(x.x(), 2 * x.y() + 0.5 * x.x(), 1.5 * x.z());
  });
}

/// By which every point's places differ from its first one; of crossings, too.
std::vector<Eigen::Vector2d> Jumps(const ExactMap& map) {
  std::vector<Index> first(map.point.size(), kNone);
  std::vector<Eigen::Vector2d> jumps;
  for (std::size_t c = 0; c < map.corner.size(); ++c) {
    Index& known = first[map.corner[c]];
    if (known == kNone) known = map.corner_uv[c];
    if (map.corner_uv[c] == known) continue;
    jumps.push_back(map.uv[map.corner_uv[c]] - map.uv[known]);
  }
  return jumps;
}

/// Whether a crossing lies on a seam.
bool HasCrossingOnSeam(const Surface& surface, const ExactMap& map) {
  std::vector<Index> first(map.point.size(), kNone);
  for (std::size_t c = 0; c < map.corner.size(); ++c) {
    Index& known = first[map.corner[c]];
    if (known == kNone) known = map.corner_uv[c];
    if (map.corner[c] >= surface.triangulation.num_vertices && map.corner_uv[c] != known)
      return true;
  }
  return false;
}

/// Where the points are that the surface has as vertices; on the cut, one of their places.
std::vector<Eigen::Vector2d> PlacesOfVertices(const Surface& surface, const ExactMap& map) {
  std::vector<Eigen::Vector2d> place(surface.triangulation.num_vertices);
  for (std::size_t c = 0; c < map.corner.size(); ++c) {
    const Index v = map.corner[c];
    if (v < surface.triangulation.num_vertices) place[v] = map.uv[map.corner_uv[c]];
  }
  return place;
}

class ExactPeriodic : public ::testing::TestWithParam<PatternKind> {};

TEST_P(ExactPeriodic, StripsHaveTheirPeriodAndSidesToTheLastBit) {
  const Surface surface = LongTriangles("strip");
  const SurfaceMap map = MustMap(surface, ExactRequest("strip", GetParam()));
  ASSERT_TRUE(map.exact_map);
  ExpectExactMapIsAccepted(surface, map);
  EXPECT_GT(map.certificate.exact_map->exact_crossings, 50);
  const double period = *map.certificate.exact_map->exact_strip_period;
  EXPECT_NEAR(period, *map.certificate.periodic->strip_period, 0.02 * period);
  const std::vector<Eigen::Vector2d> jumps = Jumps(*map.exact_map);
  EXPECT_FALSE(jumps.empty());
  EXPECT_TRUE(HasCrossingOnSeam(surface, *map.exact_map));
  for (const Eigen::Vector2d& jump : jumps) {
    EXPECT_EQ(std::abs(jump.x()), period);
    EXPECT_EQ(jump.y(), 0);
  }
  const auto place = PlacesOfVertices(surface, *map.exact_map);
  for (const std::vector<Index>& loop : BoundaryLoops(surface.triangulation)) {
    for (const Index h : loop) {
      // On the side where the map at the vertices has them.
      EXPECT_EQ(place[surface.triangulation.Tail(h)].y(), map.uv.value[Triangulation::Next(h)].y());
    }
  }
}

TEST_P(ExactPeriodic, AnnuliHaveTheirBoundaryOnTheCirclesAndCoverTheRingOnce) {
  const Surface surface = LongTriangles("annulus");
  const SurfaceMap map = MustMap(surface, ExactRequest("annulus", GetParam()));
  ASSERT_TRUE(map.exact_map);
  ExpectExactMapIsAccepted(surface, map);
  EXPECT_GT(map.certificate.exact_map->exact_crossings, 50);
  EXPECT_EQ(map.exact_map->uv.size(), map.exact_map->point.size());  // no seam
  const double inner = *map.certificate.exact_map->exact_inner_radius;
  EXPECT_NEAR(std::log(inner), std::log(*map.certificate.periodic->inner_radius), 0.1);
  const auto place = PlacesOfVertices(surface, *map.exact_map);
  for (const std::vector<Index>& loop : BoundaryLoops(surface.triangulation)) {
    const bool is_inner = place[surface.triangulation.Tail(loop[0])].norm() < 0.5 * (1 + inner);
    for (const Index h : loop) {
      const double radius = place[surface.triangulation.Tail(h)].norm();
      EXPECT_NEAR(radius, is_inner ? inner : 1, 1e-15);
    }
  }
}

TEST_P(ExactPeriodic, ToriDifferAtSeamsByWholePeriodsToTheLastBit) {
  const Surface surface = LongTriangles("torus");
  const SurfaceMap map = MustMap(surface, ExactRequest("torus", GetParam()));
  ASSERT_TRUE(map.exact_map);
  ExpectExactMapIsAccepted(surface, map);
  EXPECT_GT(map.certificate.exact_map->exact_crossings, 50);
  const std::complex<double> tau(*map.certificate.exact_map->exact_modulus_real,
                                 *map.certificate.exact_map->exact_modulus_imaginary);
  EXPECT_NEAR(tau.imag(), *map.certificate.periodic->modulus_imaginary, 0.05 * tau.imag());
  const Lattice lattice{1, tau};
  const std::vector<Eigen::Vector2d> jumps = Jumps(*map.exact_map);
  EXPECT_FALSE(jumps.empty());
  EXPECT_TRUE(HasCrossingOnSeam(surface, *map.exact_map));
  for (const Eigen::Vector2d& jump : jumps) {
    const auto [a, b] = lattice.Coordinates({jump.x(), jump.y()});
    EXPECT_EQ(jump.x(), std::round(a) + std::round(b) * tau.real());
    EXPECT_EQ(jump.y(), std::round(b) * tau.imag());
  }
  double twice = 0;
  for (std::size_t c = 0; c < map.exact_map->corner_uv.size(); c += 3) {
    const auto at = [&](std::size_t k) {
      return map.exact_map->uv[map.exact_map->corner_uv[c + k]];
    };
    const Eigen::Vector2d a = at(1) - at(0), b = at(2) - at(0);
    twice += a.x() * b.y() - a.y() * b.x();
  }
  EXPECT_NEAR(twice / 2, tau.imag(), 1e-9);
}

INSTANTIATE_TEST_SUITE_P(Patterns, ExactPeriodic,
                         testing::Values(PatternKind::kCircle, PatternKind::kEquivalence),
                         [](const auto& pattern) {
                           return pattern.param == PatternKind::kCircle ? "circle" : "equivalence";
                         });

// A prism's wall unrolls to a rectangle: the exact map is that, a similarity on every piece.
TEST(ExactStrip, OfAPrismIsItsWallUnrolled) {
  constexpr int kSides = 24;
  const Surface prism = Prism(kSides);
  MapRequest request = ExactRequest("strip");
  request.options.refine_map = "none";
  const SurfaceMap map = MustMap(prism, request);
  ASSERT_TRUE(map.exact_map);
  ExpectExactMapIsAccepted(prism, map);
  const double perimeter = 2 * kSides * std::sin(kPi / kSides);
  EXPECT_NEAR(*map.certificate.exact_map->exact_strip_period, perimeter / 3, 1e-9);
  EXPECT_NEAR(map.certificate.exact_map->exact_quasi_conformal_max, 1, 1e-8);
}

// What is drawn straight between the wound corners is the finer the nearer to conformal.
TEST(ExactAnnulus, OfWhatNeedsNoFlipIsTheMapAtTheVertices) {
  const Surface ring = GeneratedSurface("annulus", 800);
  MapRequest request = ExactRequest("annulus");
  request.options.refine_map = "none";
  request.options.triangulation = SolvedTriangulation::kInput;
  const SurfaceMap map = MustMap(ring, request);
  ASSERT_TRUE(map.exact_map);
  ExpectExactMapIsAccepted(ring, map);
  EXPECT_EQ(map.certificate.exact_map->exact_crossings, 0);
  const auto place = PlacesOfVertices(ring, *map.exact_map);
  // The same but for where the strip was cut open: a turn about the centre.
  const auto at = [&](Index h) {
    const Eigen::Vector2d &a = place[ring.triangulation.vertex[h]], &b = map.uv.value[h];
    return std::complex<double>(a.x(), a.y()) / std::complex<double>(b.x(), b.y());
  };
  for (Index h = 1; h < ring.triangulation.num_halfedges(); ++h) {
    EXPECT_LT(std::abs(at(h) - at(0)), 1e-9);
  }
}

TEST(ExactStrip, OfTwistedMeshesIsAccepted) {
  for (const char* domain : {"strip", "annulus"}) {
    const Surface twisted = Twisted(Prism(16), 0.9);
    const SurfaceMap map = MustMap(twisted, ExactRequest(domain));
    ASSERT_TRUE(map.exact_map) << domain;
    EXPECT_GT(map.certificate.triangulation->flips, 10);
    ExpectExactMapIsAccepted(twisted, map);
  }
}

}  // namespace
}  // namespace cirque
