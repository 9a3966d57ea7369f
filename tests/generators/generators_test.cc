#include "cirque/generators/generators.h"

#include <cmath>
#include <map>

#include <Eigen/Geometry>
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cirque/generators/known_maps.h"
#include "cirque/math/predicates.h"

#include "tests/io/soup_topology.h"

namespace cirque {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

struct Topology {
  Index euler_characteristic, loops;
};

/// What every generator promises; one without an entry fails.
const std::map<std::string, Topology>& PromisedTopology() {
  static const std::map<std::string, Topology> promised = {
      {"flat_delaunay_patch", {1, 1}},
      {"bumpy_terrain", {1, 1}},
      {"spherical_cap", {1, 1}},
      {"hemisphere", {1, 1}},
      {"enneper_patch", {1, 1}},
      {"capped_tube", {1, 1}},
      {"long_capped_tube", {1, 1}},
      {"hexagonal_fan", {1, 1}},
      {"annulus", {0, 2}},
      {"eccentric_annulus", {0, 2}},
      {"plate_with_holes", {-4, 6}},
      {"catenoid", {0, 2}},
      {"sphere", {2, 0}},
      {"blob", {2, 0}},
      {"torus", {0, 0}},
      {"double_torus", {-2, 0}},
  };
  return promised;
}

PolygonSoup Generate(const std::string& name, Index triangles, unsigned seed) {
  auto mesh = GenerateMesh(name, {triangles, seed});
  EXPECT_TRUE(mesh.ok()) << mesh.status().message();
  return *mesh;
}

Vector3d Corner(const PolygonSoup& mesh, Index c) { return mesh.position[mesh.corner[c]]; }

class EveryGenerator : public testing::TestWithParam<std::string> {};

TEST_P(EveryGenerator, HasThePromisedTopologyAndSize) {
  ASSERT_TRUE(PromisedTopology().contains(GetParam()));
  const auto [euler_characteristic, loops] = PromisedTopology().at(GetParam());
  const bool handles = euler_characteristic < 0 || (euler_characteristic == 0 && loops == 0);
  for (const Index asked : {handles ? kMinTrianglesWithHandles : kMinTriangles, 731, 2500}) {
    for (const unsigned seed : {1u, 2u}) {
      SCOPED_TRACE(fmt::format("{} triangles, seed {}", asked, seed));
      const SoupTopology t = MeasureTopology(Generate(GetParam(), asked, seed));
      EXPECT_EQ(t.defect, "");
      EXPECT_EQ(t.components, 1);
      EXPECT_EQ(t.EulerCharacteristic(), euler_characteristic);
      EXPECT_EQ(t.loops, loops);
      const bool exact_rings = GetParam() == "hexagonal_fan";
      EXPECT_NEAR(t.faces, asked, (exact_rings ? 0.25 : 0.1) * asked);
    }
  }
}

TEST_P(EveryGenerator, RepeatsItselfBitForBitAndHeedsTheSeed) {
  const PolygonSoup first = Generate(GetParam(), 500, 7), again = Generate(GetParam(), 500, 7);
  EXPECT_EQ(first.position, again.position);
  EXPECT_EQ(first.corner, again.corner);
  EXPECT_EQ(first.first_corner, again.first_corner);
  if (GetParam() == "hexagonal_fan") return;
  EXPECT_NE(first.position, Generate(GetParam(), 500, 8).position);
}

TEST_P(EveryGenerator, GivesTheMinimumForLess) {
  const PolygonSoup least = Generate(GetParam(), 1, 1);
  EXPECT_GE(least.num_polygons(), 6);
  EXPECT_LE(least.num_polygons(), kMinTrianglesWithHandles);
}

TEST_P(EveryGenerator, HasRoundTrianglesOfIrregularValence) {
  if (GetParam() == "hexagonal_fan") return;
  for (const unsigned seed : {1u, 2u, 3u}) {
    const PolygonSoup mesh = Generate(GetParam(), 3000, seed);
    EXPECT_GT(SmallestAngle(mesh) * 180 / kPi, 12);
    const SoupTopology t = MeasureTopology(mesh);
    std::map<Index, Index> of_valence;
    Index interior = 0;
    for (Index v = 0; v < t.vertices; ++v) {
      if (t.on_boundary[v]) continue;
      ++interior;
      ++of_valence[t.valence[v]];
    }
    EXPECT_LT(of_valence[6], 0.7 * interior);
    EXPECT_GT(of_valence[5], 0.1 * interior);
    EXPECT_GT(of_valence[7], 0.1 * interior);
    EXPECT_LE(of_valence.rbegin()->first, 12);
  }
}

/// By how much a point misses the generator's surface.
double DistanceFromSurface(const std::string& name, const Vector3d& p) {
  const double x = p.x(), y = p.y(), z = p.z(), rim = std::hypot(x, y);
  if (name == "flat_delaunay_patch")
    return std::max({std::abs(z), std::abs(x) - 1, std::abs(y) - 1});
  if (name == "hexagonal_fan") return std::abs(z);
  if (name == "annulus") return std::max({std::abs(z), rim - 1, 0.4 - rim});
  if (name == "eccentric_annulus") {
    const double from_hole = std::hypot(x - kEccentricShift, y);
    return std::max({std::abs(z), rim - 1, kEccentricRadius - from_hole});
  }
  if (name == "plate_with_holes") {
    double outside = std::max(std::abs(z), std::pow(x, 4) + std::pow(y, 4) - 1);
    for (const EllipticHole& hole : PlateHoles()) {
      outside = std::max(outside, 1 - hole.Norm({x, y}));
    }
    return outside;
  }
  if (name == "spherical_cap") return std::max(std::abs(p.norm() - 1), 0.5 - z);
  if (name == "hemisphere") return std::max(std::abs(p.norm() - 1), -z);
  if (name == "sphere") return std::abs(p.norm() - 1);
  if (name == "capped_tube") return std::max(std::abs(z > 0 ? p.norm() - 1 : rim - 1), -8 - z);
  if (name == "long_capped_tube")
    return std::max(std::abs(z > 0 ? p.norm() - 1 : rim - 1), -50 - z);
  if (name == "catenoid") return std::max(std::abs(rim - std::cosh(z)), std::abs(z) - 1.2);
  if (name == "torus") return std::abs(std::hypot(rim - 1, z) - 0.4);
  if (name == "double_torus") {
    return std::abs(std::hypot(std::hypot(1.15 - std::abs(x), y) - 1, z) - 0.4);
  }
  if (name == "enneper_patch") {
    const Vector2d w = EnneperMap().to_plane(p);
    return std::max((EnneperMap().to_surface(w) - p).norm(), w.norm() - 1);
  }
  // Seeded bumps: a graph over the square; a star-shaped surface of moderate radius.
  if (name == "bumpy_terrain") return std::max(std::abs(x), std::abs(y)) - 1;
  if (name == "blob") return std::max(p.norm() - 3, 0.3 - p.norm());
  return 1;
}

TEST_P(EveryGenerator, PointsLieOnTheSurface) {
  for (const Vector3d& p : Generate(GetParam(), 2000, 3).position) {
    ASSERT_LT(DistanceFromSurface(GetParam(), p), 1e-12) << p.transpose();
  }
}

double SignedVolume(const PolygonSoup& mesh) {
  double volume = 0;
  for (Index c = 0; c < 3 * mesh.num_polygons(); c += 3) {
    volume += Corner(mesh, c).dot(Corner(mesh, c + 1).cross(Corner(mesh, c + 2))) / 6;
  }
  return volume;
}

TEST_P(EveryGenerator, IsOrientedOutwardsOrUpwards) {
  const PolygonSoup mesh = Generate(GetParam(), 2000, 4);
  if (PromisedTopology().at(GetParam()).loops == 0) {
    EXPECT_GT(SignedVolume(mesh), 1);
    return;
  }
  const auto map = KnownConformalMaps().Find(GetParam());
  const auto to_plane = map.ok() ? map->to_plane : IdentityMap().to_plane;  // terrain: a graph
  for (Index c = 0; c < 3 * mesh.num_polygons(); c += 3) {
    ASSERT_GT(OrientationSign(to_plane(Corner(mesh, c)), to_plane(Corner(mesh, c + 1)),
                              to_plane(Corner(mesh, c + 2))),
              0)
        << "face " << c / 3;
  }
}

INSTANTIATE_TEST_SUITE_P(Registry, EveryGenerator, testing::ValuesIn(MeshGenerators().Names()),
                         [](const auto& name) { return name.param; });

TEST(Generators, FlatMeshesAreExactlyDelaunay) {
  for (const std::string name : {"flat_delaunay_patch", "annulus"}) {
    const PolygonSoup mesh = Generate(name, 4000, 5);
    const auto plane = [&](Index v) -> Vector2d { return mesh.position[v].head<2>(); };
    Index interior_edges = 0;
    const SoupTopology t = MeasureTopology(mesh);
    for (const auto& [edge, corner] : t.opposite) {
      const auto twin = t.opposite.find({edge.second, edge.first});
      if (twin == t.opposite.end()) continue;
      ++interior_edges;
      EXPECT_LE(
          InCircleSign(plane(edge.first), plane(edge.second), plane(corner), plane(twin->second)),
          0);
    }
    EXPECT_EQ(interior_edges, 2 * (t.edges - t.boundary_edges));
  }
}

TEST(Generators, FlatPatchIsGraded) {
  const PolygonSoup mesh = Generate("flat_delaunay_patch", 8000, 1);
  double near = 0, far = 0;  // longest edges within 0.15 of the focus, and at distance 1.2 to 1.4
  for (Index c = 0; c < 3 * mesh.num_polygons(); ++c) {
    const Vector3d p = Corner(mesh, c), q = Corner(mesh, c % 3 == 2 ? c - 2 : c + 1);
    const double distance = (p - Vector3d(0.4, 0.3, 0)).norm();
    if (distance < 0.15) near = std::max(near, (p - q).norm());
    if (distance > 1.2 && distance < 1.4) far = std::max(far, (p - q).norm());
  }
  EXPECT_GT(near, 0);
  EXPECT_GT(far, 1.5 * near);
}

TEST(Generators, SphereIsTheConvexHullOfItsVertices) {
  const PolygonSoup mesh = Generate("sphere", 1000, 6);
  for (Index c = 0; c < 3 * mesh.num_polygons(); c += 3) {
    const Vector3d a = Corner(mesh, c);
    const Vector3d normal = (Corner(mesh, c + 1) - a).cross(Corner(mesh, c + 2) - a).normalized();
    EXPECT_GT(normal.dot(a), 0);
    for (const Vector3d& p : mesh.position) ASSERT_LT(normal.dot(p - a), 1e-13);
  }
  EXPECT_NEAR(SignedVolume(mesh), 4 * kPi / 3, 0.05);
}

TEST(Generators, BumpsFollowTheSeed) {
  double lowest = 0, highest = 0;
  for (const Vector3d& p : Generate("bumpy_terrain", 2000, 1).position) {
    lowest = std::min(lowest, p.z());
    highest = std::max(highest, p.z());
  }
  EXPECT_GT(highest - lowest, 0.1);
  EXPECT_GT(
      std::abs(SignedVolume(Generate("blob", 2000, 1)) - SignedVolume(Generate("blob", 2000, 2))),
      0.05);
}

TEST(Generators, HexagonalFanHasRings) {
  const PolygonSoup mesh = Generate("hexagonal_fan", 150, 1);
  EXPECT_EQ(mesh.num_polygons(), 6 * 5 * 5);
  for (Index c = 0; c < 3 * mesh.num_polygons(); ++c) {
    EXPECT_NEAR((Corner(mesh, c) - Corner(mesh, c % 3 == 2 ? c - 2 : c + 1)).norm(), 1, 1e-14);
  }
  const SoupTopology t = MeasureTopology(mesh);
  for (Index v = 0; v < t.vertices; ++v) EXPECT_TRUE(t.on_boundary[v] || t.valence[v] == 6);
}

TEST(Generators, RefusesUnknownNamesAndEmptyMeshes) {
  EXPECT_THAT(GenerateMesh("hemisfere", {}).status().message(),
              testing::HasSubstr("did you mean 'hemisphere'"));
  EXPECT_THAT(GenerateMesh("sphere", {-5, 1}).status().message(),
              testing::HasSubstr("'sphere': -5 triangles"));
  EXPECT_FALSE(GenerateMesh("sphere", {2'000'000'000, 1}).ok());
}

}  // namespace
}  // namespace cirque
