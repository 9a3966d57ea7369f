#include <algorithm>
#include <cmath>
#include <optional>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cirque/domains/domain.h"
#include "cirque/generators/known_maps.h"
#include "cirque/math/moebius.h"
#include "cirque/mesh/preflight.h"
#include "cirque/metrics/injectivity.h"
#include "cirque/pipeline/certificate.h"

#include "tests/common/domain_maps.h"
#include "tests/common/surfaces.h"

namespace cirque {
namespace {

SurfaceMap MapTo(const Surface& surface, const DomainOptions& shape = {}) {
  return MustMap(surface, RequestFor("disk", shape));
}

Index SomeVertex(const Surface& surface, bool boundary, int which = 0) {
  const std::vector<bool> on = BoundaryVertices(surface.triangulation);
  for (Index v = 0; v < surface.triangulation.num_vertices; ++v) {
    if (on[v] == boundary && which-- == 0) return v;
  }
  return kNone;
}

/// On the circle, counter-clockwise once round, nothing flipped.
void ExpectDisk(const Surface& surface, const SurfaceMap& map) {
  const Triangulation& t = surface.triangulation;
  ASSERT_EQ(map.uv.value.size(), t.vertex.size());
  EXPECT_TRUE(FlippedFaces(t, map.uv).empty());
  EXPECT_EQ(map.certificate.overlap, "injective");
  const std::vector<Complex> place = PlacesOf(surface, map);
  double turned = 0;
  const std::vector<Index> loop = BoundaryLoops(t).front();
  for (const Index h : loop) {
    EXPECT_NEAR(std::abs(place[t.Tail(h)]), 1, 1e-15);
    const double step = std::arg(place[t.Tip(h)] / place[t.Tail(h)]);
    EXPECT_NE(step, 0);
    turned += step < 0 ? step + 2 * kPi : step;
  }
  EXPECT_NEAR(turned, 2 * kPi, 1e-9);
}

TEST(DiskDomain, GeneratedDisksOfManyShapes) {
  for (const char* name : {"bumpy_terrain", "spherical_cap", "enneper_patch", "hemisphere",
                           "capped_tube", "hexagonal_fan", "flat_delaunay_patch"}) {
    SCOPED_TRACE(name);
    const Surface surface = GeneratedSurface(name, 600);
    const SurfaceMap map = MapTo(surface);
    ExpectDisk(surface, map);
    EXPECT_EQ(map.certificate.disk->boundary_spread, 0);
    EXPECT_LT(map.certificate.disk->core_quasi_conformal_mean, 1.35);
    EXPECT_LT(map.certificate.disk->boundary_straightness, 1e-10);
  }
}

TEST(DiskDomain, ChosenCentreAndAngleZeroAreExact) {
  const Surface surface = GeneratedSurface("bumpy_terrain", 500);
  DomainOptions domain;
  domain.centre = SomeVertex(surface, false, 40);
  domain.angle_zero = SomeVertex(surface, true, 9);
  const SurfaceMap map = MapTo(surface, domain);
  ExpectDisk(surface, map);
  const std::vector<Complex> place = PlacesOf(surface, map);
  EXPECT_EQ(place[domain.centre], Complex(0));
  EXPECT_EQ(place[domain.angle_zero], Complex(1));
  EXPECT_EQ(map.certificate.disk->centre_vertex, domain.centre);
}

TEST(DiskDomain, PolesGiveTheSameMapUpToTurningAndDiscretization) {
  const Surface surface = GeneratedSurface("hemisphere", 1500);
  DomainOptions domain;
  domain.centre = SomeVertex(surface, false, 100);
  std::vector<std::vector<Complex>> places;
  for (const int which : {0, 10, 25}) {
    domain.pole = SomeVertex(surface, true, which);
    places.push_back(PlacesOf(surface, MapTo(surface, domain)));
  }
  for (const std::size_t other : {1, 2}) {
    Complex turn = 0;
    for (std::size_t v = 0; v < places[0].size(); ++v) {
      turn += places[0][v] * std::conj(places[other][v]);
    }
    turn /= std::abs(turn);
    double sum = 0;
    for (std::size_t v = 0; v < places[0].size(); ++v) {
      sum += std::norm(places[0][v] - turn * places[other][v]);
    }
    // Boundary edges are 0.08 long; the poles were taken as they came, well shaped or not.
    EXPECT_LT(std::sqrt(sum / static_cast<double>(places[0].size())), 0.03);
  }
}

TEST(DiskDomain, HemisphereComesNearItsStereographicImage) {
  const Surface surface = GeneratedSurface("hemisphere", 4000);
  const SurfaceMap map = MapTo(surface);
  const auto centre = static_cast<Index>(map.certificate.disk->centre_vertex);
  const auto zero = static_cast<Index>(map.certificate.disk->angle_zero_vertex);
  const auto known = [&](Index v) {
    const Eigen::Vector2d w = StereographicMap().to_plane(surface.position[v]);
    return Complex(w.x(), w.y());
  };
  const Moebius centring = Moebius::DiskAutomorphism(known(centre));
  const Complex turn = std::conj(centring(known(zero)).value);
  const std::vector<Complex> place = PlacesOf(surface, map);
  double sum = 0;
  for (Index v = 0; v < surface.triangulation.num_vertices; ++v) {
    sum += std::norm(place[v] - turn * centring(known(v)).value);
  }
  EXPECT_LT(std::sqrt(sum / static_cast<double>(place.size())), 5e-3);
}

TEST(DiskDomain, NormalizationsCentreTheirMasses) {
  const Surface surface = GeneratedSurface("enneper_patch", 600);
  DomainOptions domain;
  for (const char* name : {"boundary", "area"}) {
    domain.normalization = name;
    const SurfaceMap map = MapTo(surface, domain);
    ExpectDisk(surface, map);
    const Certificate& certificate = map.certificate;
    EXPECT_LT(NumbersOf(certificate).at(std::string(name) + "_centre_of_mass"), 1e-14) << name;
  }
  // The boundary's centre of mass without the program's own sum, weighted by half of either edge.
  domain.normalization = "boundary";
  const std::vector<Complex> place = PlacesOf(surface, MapTo(surface, domain));
  Complex sum = 0;
  double total = 0;
  const Triangulation& t = surface.triangulation;
  const std::vector<Index> loop = BoundaryLoops(t).front();
  for (const Index h : loop) {
    const double length = (surface.position[t.Tail(h)] - surface.position[t.Tip(h)]).norm();
    sum += length * (place[t.Tail(h)] + place[t.Tip(h)]);
    total += 2 * length;
  }
  EXPECT_LT(std::abs(sum) / total, 1e-14);
}

TEST(DiskDomain, MirroredSurfaceGivesTheMirroredMap) {
  // Orientation is kept: a mesh seen from the other side has the complex conjugate as its map.
  Surface surface = GeneratedSurface("bumpy_terrain", 300);
  DomainOptions domain;
  domain.centre = SomeVertex(surface, false, 30);
  domain.angle_zero = SomeVertex(surface, true, 2);
  domain.pole = SomeVertex(surface, true, 7);
  const std::vector<Complex> before = PlacesOf(surface, MapTo(surface, domain));
  Triangulation& t = surface.triangulation;
  std::vector<Index> vertex(t.vertex), twin(t.twin);
  const auto mirrored = [](Index h) { return h % 3 == 0 ? h : (h % 3 == 1 ? h + 1 : h - 1); };
  for (Index h = 0; h < t.num_halfedges(); ++h) {
    vertex[mirrored(h)] = t.vertex[h];
    twin[mirrored(h)] = t.twin[h] == kNone ? kNone : mirrored(t.twin[h]);
  }
  t = NumberEdges(t.num_vertices, vertex, twin);
  const std::vector<Complex> after = PlacesOf(surface, MapTo(surface, domain));
  for (std::size_t v = 0; v < before.size(); ++v) {
    EXPECT_LT(std::abs(after[v] - std::conj(before[v])), 1e-8);
  }
}

TEST(DiskDomain, SmallestDisksAreMapped) {
  const Surface fan = Fan(3, 0.4);
  ExpectDisk(fan, MapTo(fan));
  const Surface larger = Fan(7, 0.4);
  ExpectDisk(larger, MapTo(larger));
}

TEST(DiskDomain, WhatIsNoDiskOrNoSuchVertexIsRefused) {
  MustFail(GeneratedSurface("annulus", 100), RequestFor("disk"), StatusCode::kInvalidInput);
  MustFail(GeneratedSurface("sphere", 100), RequestFor("disk"), StatusCode::kInvalidInput);
  const Surface surface = GeneratedSurface("hexagonal_fan", 50);
  DomainOptions domain;
  domain.centre = SomeVertex(surface, true);
  MustFail(surface, RequestFor("disk", domain), StatusCode::kInvalidInput);
  domain = {};
  domain.angle_zero = domain.pole = SomeVertex(surface, false);
  MustFail(surface, RequestFor("disk", domain), StatusCode::kInvalidInput);
  domain = {};
  domain.pole = SomeVertex(surface, false);
  MustFail(surface, RequestFor("disk", domain), StatusCode::kInvalidInput);
  domain = {};
  domain.normalization = "are";
  MustFail(surface, RequestFor("disk", domain), StatusCode::kInvalidInput);
}

TEST(DiskDomain, LongLimbIsSpreadAndStillNotFlipped) {
  // A strip 60 times as long as wide: the ends' images differ by e^-90 of the middle's.
  const Surface strip = FlatStrip(240, 4);
  const SurfaceMap map = MapTo(strip);
  ExpectDisk(strip, map);
  EXPECT_GT(map.certificate.disk->boundary_spread, 0);
}

TEST(DiskDomain, RefinementSlidesAlongTheCircleAndKeepsTheCentre) {
  const Surface terrain = GeneratedSurface("bumpy_terrain", 600);
  ParameterizeOptions options;
  options.refine_map = "none";
  const SurfaceMap plain = MustMap(terrain, RequestFor("disk", {}, options));
  options.refine_map = "mips";
  const SurfaceMap refined = MustMap(terrain, RequestFor("disk", {}, options));
  EXPECT_LT(refined.certificate.distortion->quasi_conformal_mean,
            0.999 * plain.certificate.distortion->quasi_conformal_mean);
  EXPECT_TRUE(FlippedFaces(terrain.triangulation, refined.uv).empty());
  EXPECT_EQ(refined.certificate.disk->centre_vertex, plain.certificate.disk->centre_vertex);
  EXPECT_EQ(*refined.certificate.disk->centre_error, 0);
  ExpectDisk(terrain, refined);
  const std::vector<Complex> before = PlacesOf(terrain, plain), after = PlacesOf(terrain, refined);
  const auto zero = static_cast<Index>(refined.certificate.disk->angle_zero_vertex);
  EXPECT_EQ(after[zero], 1.0);
  const std::vector<bool> boundary = BoundaryVertices(terrain.triangulation);
  for (Index v = 0; v < terrain.triangulation.num_vertices; ++v) {
    if (boundary[v] && v != zero) {
      EXPECT_NE(after[v], before[v]);
    }
  }
}

TEST(DiskDomain, RefinementKeepsABoundaryWhoseMeanIsPrescribed) {
  const Surface terrain = GeneratedSurface("bumpy_terrain", 600);
  DomainOptions shape;
  shape.normalization = "boundary";
  const SurfaceMap map = MapTo(terrain, shape);
  EXPECT_LT(map.certificate.map_refinement->map_refinement_after,
            map.certificate.map_refinement->map_refinement_before);
  EXPECT_LT(map.certificate.disk->boundary_centre_of_mass, 1e-12);
}

TEST(HalfPlaneDomain, RefinementKeepsTheBoundaryRealAndInOrder) {
  const Surface terrain = GeneratedSurface("bumpy_terrain", 600);
  ParameterizeOptions options;
  options.refine_map = "none";
  const SurfaceMap plain = MustMap(terrain, RequestFor("half_plane", {}, options));
  options.refine_map = "mips";
  const SurfaceMap refined = MustMap(terrain, RequestFor("half_plane", {}, options));
  const std::optional<MapRefinementSummary>& summary = refined.certificate.map_refinement;
  ASSERT_TRUE(summary.has_value());
  EXPECT_LT(summary->map_refinement_after, 0.99 * summary->map_refinement_before);
  EXPECT_TRUE(FlippedFaces(terrain.triangulation, refined.uv).empty());
  const auto pole = static_cast<Index>(refined.certificate.half_plane->pole_vertex);
  const std::vector<Complex> before = PlacesOf(terrain, plain), after = PlacesOf(terrain, refined);
  EXPECT_EQ(after[pole], before[pole]);
  const Triangulation& t = terrain.triangulation;
  int slid = 0;
  const std::vector<Index> loop = BoundaryLoops(t).front();
  for (const Index h : loop) {
    const Index tail = t.Tail(h), tip = t.Tip(h);
    if (tail == pole || tip == pole) continue;
    EXPECT_EQ(after[tip].imag(), 0);
    EXPECT_LT(after[tail].real(), after[tip].real());
    slid += after[tip] != before[tip] ? 1 : 0;
  }
  EXPECT_GT(slid, 10);
}

TEST(HalfPlaneDomain, BoundaryIsRealAndTheRestAbove) {
  const Surface surface = GeneratedSurface("hemisphere", 500);
  const SurfaceMap map = MustMap(surface, RequestFor("half_plane"));
  EXPECT_TRUE(FlippedFaces(surface.triangulation, map.uv).empty());
  const std::vector<Complex> place = PlacesOf(surface, map);
  const std::vector<bool> boundary = BoundaryVertices(surface.triangulation);
  const auto pole = static_cast<Index>(map.certificate.half_plane->pole_vertex);
  for (Index v = 0; v < surface.triangulation.num_vertices; ++v) {
    if (boundary[v] && v != pole) {
      EXPECT_EQ(place[v].imag(), 0);
    } else {
      EXPECT_GT(place[v].imag(), 0);
    }
  }
}

Surface ATriangle() {
  return *SurfaceFromTriangles({{0, 0, 0}, {3, 0, 0}, {0, 4, 0}}, {{0, 1, 2}});
}

TEST(MapToHalfPlane, ATriangleIsMappedAsItIs) {
  // Sides 3, 4 and 5: with the right angle at infinity, or the vertex that is named.
  for (const Index pole : {kNone, Index{1}, Index{2}}) {
    DomainOptions shape;
    shape.pole = pole;
    const SurfaceMap map = MustMap(ATriangle(), RequestFor("half_plane", shape));
    const Index at = pole == kNone ? 0 : pole;
    const auto& uv = map.uv.value;
    EXPECT_EQ(map.certificate.half_plane->pole_vertex, at);
    EXPECT_GT(uv[at].y(), 1);
    EXPECT_EQ(uv[(at + 1) % 3].y(), 0);
    EXPECT_EQ(uv[(at + 2) % 3].y(), 0);
    EXPECT_NEAR((uv[1] - uv[0]).norm(), 3, 1e-12);
    EXPECT_NEAR((uv[2] - uv[0]).norm(), 4, 1e-12);
    EXPECT_NEAR((uv[2] - uv[1]).norm(), 5, 1e-12);
  }
}

TEST(MapToHalfPlane, TrianglesThatHaveNoRoomAreNamedByTheirFace) {
  const Surface quad =
      *SurfaceFromTriangles({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {{0, 1, 2}, {0, 2, 3}});
  EXPECT_THAT(MapSurface(quad, RequestFor("half_plane")).status().message(),
              testing::HasSubstr("1 triangle lies beyond edges that join two boundary vertices"));
}

TEST(EveryDomain, TakesATriangleOrSaysWhyNot) {
  for (const char* domain : {"plane", "disk", "triangle"}) {
    EXPECT_TRUE(MapSurface(ATriangle(), RequestFor(domain)).ok()) << domain;
  }
  DomainOptions three;
  three.sides = 3;
  EXPECT_TRUE(MapSurface(ATriangle(), RequestFor("polygon", three)).ok());
  EXPECT_THAT(MapSurface(ATriangle(), RequestFor("rectangle")).status().message(),
              testing::HasSubstr("a polygon of 4 corners"));
  EXPECT_THAT(MapSurface(ATriangle(), RequestFor("sphere")).status().message(),
              testing::HasSubstr("needs a closed surface"));
}

}  // namespace
}  // namespace cirque
