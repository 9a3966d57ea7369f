// Disks with round holes, by what is the same of all of them: one conformal map to the other.
#include <array>
#include <cmath>
#include <complex>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cirque/domains/domain.h"
#include "cirque/generators/generators.h"
#include "cirque/generators/known_maps.h"
#include "cirque/metrics/injectivity.h"

#include "tests/common/domain_maps.h"
#include "tests/common/surfaces.h"

namespace cirque {
namespace {

using Complex = std::complex<double>;
using ::testing::HasSubstr;

SurfaceMap MustRound(const Surface& surface) { return MustMap(surface, RequestFor("round_holes")); }

struct Circle {
  Complex centre;
  double radius;
};

/// The circle through three vertices of a loop of the image.
Circle CircleOf(const Surface& surface, const SurfaceMap& map, const std::vector<Index>& loop) {
  const auto at = [&](std::size_t k) {
    const Eigen::Vector2d& p = map.uv.value[Triangulation::Next(loop[k % loop.size()])];
    return Complex(p.x(), p.y());
  };
  EXPECT_EQ(surface.triangulation.Tail(loop[0]),
            surface.triangulation.vertex[Triangulation::Next(loop[0])]);
  const Complex a = at(0), b = at(loop.size() / 3), c = at(2 * loop.size() / 3);
  const Complex x = (c - a) / (b - a);
  const Complex centre = (b - a) * (x - std::norm(x)) / (x - std::conj(x)) + a;
  return {centre, std::abs(a - centre)};
}

std::vector<Circle> CirclesOf(const Surface& surface, const SurfaceMap& map) {
  std::vector<Circle> circles;
  for (const std::vector<Index>& loop : BoundaryLoops(surface.triangulation)) {
    circles.push_back(CircleOf(surface, map, loop));
    for (const Index h : loop) {
      const Eigen::Vector2d& p = map.uv.value[Triangulation::Next(h)];
      const double distance = std::abs(Complex(p.x(), p.y()) - circles.back().centre);
      EXPECT_NEAR(distance, circles.back().radius, 1e-13);
    }
  }
  return circles;
}

/// |r^2 + s^2 - d^2| / (2 r s), which Moebius maps keep.
double InversiveDistance(const Circle& a, const Circle& b) {
  const double d = std::abs(a.centre - b.centre);
  return std::abs(a.radius * a.radius + b.radius * b.radius - d * d) / (2 * a.radius * b.radius);
}

TEST(MapToRoundHoles, MakesFiveHolesRound) {
  const Surface plate = GeneratedSurface("plate_with_holes", 3000);
  const SurfaceMap map = MustRound(plate);
  const RoundHolesSummary& summary = *map.certificate.round_holes;
  EXPECT_EQ(summary.holes, 5);
  EXPECT_LT(summary.roundness, 1e-8);
  EXPECT_LT(summary.circle_error, 1e-14);
  EXPECT_LT(summary.rounds, 40);
  EXPECT_EQ(map.certificate.overlap, "injective");
  EXPECT_TRUE(FlippedFaces(plate.triangulation, map.uv).empty());
  EXPECT_TRUE(map.cut.IsEmpty());
  EXPECT_LT(map.certificate.distortion->quasi_conformal_mean, 1.03);
  const std::vector<Circle> circles = CirclesOf(plate, map);
  ASSERT_EQ(circles.size(), 6u);
  int outer = 0;
  for (const Circle& circle : circles) {
    if (std::abs(circle.radius - 1) < 1e-12 && std::abs(circle.centre) < 1e-12) {
      ++outer;
      continue;
    }
    EXPECT_LE(circle.radius, summary.largest_radius + 1e-12);
    EXPECT_GE(circle.radius, summary.smallest_radius - 1e-12);
  }
  EXPECT_EQ(outer, 1);
}

/// A conformal image of a plane surface, its circles bent.
Surface BentByExponential(const Surface& plane) {
  return Moved(plane, [](const Eigen::Vector3d& x) -> Eigen::Vector3d {
    const Complex z = std::exp(0.5 * Complex(x.x(), x.y()));
    return {z.real(), z.imag(), 0};
  });
}

// The inversive distance of the two circles is cosh log(R / r) of the concentric ring.
TEST(MapToRoundHoles, OfARingHasItsModulus) {
  const double wanted = std::log(1 / kEccentricConformalRadius);
  double before = 1;
  for (const Index triangles : {250, 1000, 4000}) {
    const Surface ring = BentByExponential(GeneratedSurface("eccentric_annulus", triangles));
    const std::vector<Circle> circles = CirclesOf(ring, MustRound(ring));
    const double error =
        std::abs(std::acosh(InversiveDistance(circles[0], circles[1])) / wanted - 1);
    EXPECT_LT(error, 0.7 * before) << triangles;
    before = error;
  }
  EXPECT_LT(before, 3e-3);
}

// What has round holes stays as it is.
TEST(MapToRoundHoles, KeepsARingThatIsRound) {
  const Surface ring = GeneratedSurface("eccentric_annulus", 1000);
  const SurfaceMap map = MustRound(ring);
  EXPECT_EQ(map.certificate.round_holes->rounds, 1);
  for (Index h = 0; h < ring.triangulation.num_halfedges(); h += 3) {
    for (const Index k : {1, 2}) {
      EXPECT_NEAR((map.uv.value[h + k] - map.uv.value[h]).norm(),
                  (ring.position[ring.triangulation.vertex[h + k]] -
                   ring.position[ring.triangulation.vertex[h]])
                      .norm(),
                  1e-9);
    }
  }
}

// By Koebe's theorem round holes are unique up to Moebius maps: a map of the plate and one of the plate
// after a conformal map of the plane see the same inversive distances.
TEST(MapToRoundHoles, AreTheSameOfAConformalImage) {
  const Surface plate = GeneratedSurface("plate_with_holes", 2000);
  const Surface bent = BentByExponential(plate);
  const std::vector<Circle> here = CirclesOf(plate, MustRound(plate));
  const std::vector<Circle> there = CirclesOf(bent, MustRound(bent));
  for (std::size_t i = 0; i < here.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      const double distance = InversiveDistance(here[i], here[j]);
      EXPECT_NEAR(InversiveDistance(there[i], there[j]) / distance, 1, 0.01) << i << " " << j;
    }
  }
}

/// Unit squares, each cut in two, without those that `hole` is true of.
template <class Hole>
Surface Squares(int columns, int rows, const Hole& hole) {
  PolygonSoup soup;
  for (int j = 0; j <= rows; ++j) {
    for (int i = 0; i <= columns; ++i) soup.position.emplace_back(i, j, 0.1 * i * j / columns);
  }
  const auto number = [&](int i, int j) { return j * (columns + 1) + i; };
  for (int j = 0; j < rows; ++j) {
    for (int i = 0; i < columns; ++i) {
      const int a = number(i, j), b = number(i + 1, j), c = number(i + 1, j + 1),
                d = number(i, j + 1);
      for (int k = 0; k < 2; ++k) {
        if (hole(i, j, k)) continue;
        for (const int v : k == 0 ? std::array{a, b, c} : std::array{a, c, d}) {
          soup.corner.push_back(v);
        }
        soup.first_corner.push_back(static_cast<Index>(soup.corner.size()));
      }
    }
  }
  return SurfaceOf(soup);
}

// Corners of the outer boundary with one triangle, whose three corners all go to one circle.
TEST(MapToRoundHoles, SplitsTheOuterBoundarysChords) {
  const Surface frame = Squares(8, 6, [](int i, int j, int) { return i / 2 == 1 && j / 2 == 1; });
  const SurfaceMap map = MustRound(frame);
  EXPECT_EQ(map.certificate.round_holes->chords, 2);
  EXPECT_EQ(CirclesOf(frame, map).size(), 2u);
  EXPECT_EQ(map.certificate.overlap, "injective");
}

TEST(MapToRoundHoles, RefusesEdgesAcrossAHole) {
  // A triangle stands into the hole: its third side is an inner edge between two vertices of it.
  const Surface frame = Squares(8, 6, [](int i, int j, int k) {
    return i / 2 == 1 && j / 2 == 1 && !(i == 2 && j == 2 && k == 0);
  });
  const Certificate failed = MustFail(frame, RequestFor("round_holes"), StatusCode::kInvalidInput);
  EXPECT_THAT(failed.message, HasSubstr("joins two vertices of one hole"));
  EXPECT_FALSE(failed.round_holes.has_value());
}

TEST(MapToRoundHoles, RefusesADisk) {
  const Certificate failed = MustFail(GeneratedSurface("hemisphere", 100),
                                      RequestFor("round_holes"), StatusCode::kInvalidInput);
  EXPECT_THAT(failed.message, HasSubstr("genus 0 with 1 boundary loops"));
}

}  // namespace
}  // namespace cirque
