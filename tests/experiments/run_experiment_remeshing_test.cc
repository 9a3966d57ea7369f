#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cirque/mesh/surface.h"

#include "experiments/run_experiment/config/remeshing.h"
#include "tests/common/surfaces.h"

namespace cirque {
namespace {

using ::testing::HasSubstr;

/// How far the vertices are from the unit sphere at most.
double FarthestFromSphere(const PolygonSoup& soup) {
  double farthest = 0;
  for (const Eigen::Vector3d& x : soup.position) {
    farthest = std::max(farthest, std::abs(x.norm() - 1));
  }
  return farthest;
}

TEST(Remeshing, EverySchemeKeepsTopologyAndMakesMoreTriangles) {
  for (const char* generator : {"torus", "hemisphere"}) {
    const Surface surface = GeneratedSurface(generator, 300);
    const PolygonSoup coarse = TrianglesOf(surface);
    for (const std::string& scheme : SubdivisionSchemes()) {
      SCOPED_TRACE(std::string(generator) + " " + scheme);
      const auto fine = Subdivide(coarse, scheme, 2);
      ASSERT_TRUE(fine.ok()) << fine.status().message();
      EXPECT_EQ(fine->num_polygons(), coarse.num_polygons() * (scheme == "sqrt3" ? 9 : 16));
      const Surface finer = SurfaceOf(*fine);
      EXPECT_EQ(EulerCharacteristic(finer.triangulation),
                EulerCharacteristic(surface.triangulation));
      EXPECT_EQ(BoundaryLoops(finer.triangulation).size(),
                BoundaryLoops(surface.triangulation).size());
    }
  }
}

TEST(Remeshing, TheButterflyGoesToTheSmoothSurfaceAndMidpointsDoNot) {
  const PolygonSoup sphere = TrianglesOf(GeneratedSurface("sphere", 400));
  const double midpoint = FarthestFromSphere(*Subdivide(sphere, "midpoint", 2));
  const double butterfly = FarthestFromSphere(*Subdivide(sphere, "butterfly", 2));
  EXPECT_GT(midpoint, 0.01);
  EXPECT_LT(butterfly, midpoint / 4);
}

TEST(Remeshing, DecimationLeavesAboutAsManyTrianglesNearTheSurface) {
  const PolygonSoup sphere = TrianglesOf(GeneratedSurface("sphere", 4000));
  const auto coarse = Decimate(sphere, 500);
  ASSERT_TRUE(coarse.ok()) << coarse.status().message();
  EXPECT_LE(coarse->num_polygons(), 505);
  EXPECT_GE(coarse->num_polygons(), 480);
  EXPECT_EQ(EulerCharacteristic(SurfaceOf(*coarse).triangulation), 2);
  EXPECT_LT(FarthestFromSphere(*coarse), 0.02);
  EXPECT_EQ(Decimate(sphere, 1 << 20)->corner, sphere.corner);
}

TEST(Remeshing, WhatCollapsesCannotReachIsSaid) {
  const PolygonSoup torus = TrianglesOf(GeneratedSurface("torus", 300));
  const auto none = Decimate(torus, 2);
  ASSERT_FALSE(none.ok());
  EXPECT_THAT(none.status().message(), HasSubstr("no fewer than"));
}

TEST(Remeshing, TwoEdgesOfTheSameVerticesAreRefused) {
  PolygonSoup pillow;  // two triangles, back to back
  pillow.position = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  pillow.corner = {0, 1, 2, 0, 2, 1};
  pillow.first_corner = {0, 3, 6};
  PolygonSoup twice = pillow;
  twice.corner.insert(twice.corner.end(), {0, 1, 2});
  twice.first_corner.push_back(9);
  EXPECT_THAT(Subdivide(twice, "loop", 1).status().message(), HasSubstr("triangle 3"));
}

}  // namespace
}  // namespace cirque
