// verify_map on maps to the unit disk, good ones and ones with a planted error.
#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/verify/fixtures.h"

namespace cirque::verify {
namespace {

using ::testing::HasSubstr;

/// A wheel of n triangles whose rim has these angles.
PolygonSoup Wheel(const std::vector<double>& angles) {
  std::vector<Eigen::Vector3d> position = {{0, 0, 0.3}};
  std::vector<Eigen::Vector2d> uv = {{0, 0}};
  std::vector<Triangle> triangles;
  const auto n = static_cast<Index>(angles.size());
  for (Index i = 0; i < n; ++i) {
    position.emplace_back(std::cos(2 * kPi * i / n), std::sin(2 * kPi * i / n), 0);
    uv.emplace_back(std::cos(angles[i]), std::sin(angles[i]));
    triangles.push_back({0, 1 + i, 1 + (i + 1) % n});
  }
  return WithVertexUv(MakeSoup(std::move(position), triangles), std::move(uv));
}

MapReport JudgeDisk(const PolygonSoup& mesh) {
  VerifyOptions options;
  options.unit_disk = true;
  return Judge(mesh, mesh, options);
}

const std::vector<double> kRim = {0, 1, 2, 3, 4, 5};

TEST(VerifyDisk, AWheelOnTheCircleIsValid) {
  const MapReport report = JudgeDisk(Wheel(kRim));
  EXPECT_TRUE(report.valid()) << report.Verdict();
  EXPECT_LT(report.disk->largest_error, 1e-15);
  EXPECT_EQ(report.disk->turns, 1);
  EXPECT_EQ(report.disk->num_vertices, 6);
}

TEST(VerifyDisk, AVertexOffTheCircleIsFound) {
  PolygonSoup mesh = Wheel(kRim);
  mesh.texture[3] *= 1 - 3e-14;
  const MapReport report = JudgeDisk(mesh);
  EXPECT_FALSE(report.valid());
  EXPECT_EQ(report.disk->off_circle, std::vector<Index>{3});
  EXPECT_NEAR(report.disk->largest_error, 3e-14, 1e-15);
  EXPECT_THAT(report.Verdict(), HasSubstr("off the unit circle (3)"));
  EXPECT_TRUE(Judge(mesh, mesh).valid());  // as a map to the plane
}

TEST(VerifyDisk, VerticesOutOfOrderAreFound) {
  const MapReport report = JudgeDisk(Wheel({0, 1, 3, 2, 4, 5}));
  EXPECT_FALSE(report.valid());
  EXPECT_EQ(report.disk->turns, 2);
  EXPECT_EQ(report.disk->out_of_order, std::vector<Index>{4});
}

TEST(VerifyDisk, VerticesAtOneAngleAreFound) {
  const MapReport report = JudgeDisk(Wheel({0, 1, 2, 2, 4, 5}));
  EXPECT_FALSE(report.valid());
  EXPECT_NE(report.disk->turns, 1);
}

TEST(VerifyDisk, TwiceRoundIsFound) {
  const MapReport report = JudgeDisk(Wheel({0, 2.1, 4.2, 6.3, 8.4, 10.5}));
  EXPECT_FALSE(report.valid());
  EXPECT_EQ(report.disk->turns, 2);
}

TEST(VerifyDisk, AnEdgeOverMoreThanHalfOfTheCircleIsNoErrorOfOrder) {
  PolygonSoup mesh = Wheel({0, 0.5, 1, 1.5, 2, 2.5});
  mesh.texture[0] = {0.4, 0.8};
  EXPECT_EQ(JudgeDisk(mesh).disk->turns, 1);
}

/// The ring between the unit circle and that of radius 0.3 about (0.4, 0), n triangles a row.
PolygonSoup Ring(Index n) {
  std::vector<Eigen::Vector3d> position;
  std::vector<Eigen::Vector2d> uv;
  std::vector<Triangle> triangles;
  for (const bool inner : {false, true}) {
    for (Index i = 0; i < n; ++i) {
      const double angle = 2 * kPi * i / n, radius = inner ? 0.3 : 1;
      uv.emplace_back(radius * std::cos(angle) + (inner ? 0.4 : 0), radius * std::sin(angle));
      position.emplace_back(uv.back().x(), uv.back().y(), 0.1 * i / n);
    }
  }
  for (Index i = 0; i < n; ++i) {
    const Index next = (i + 1) % n;
    triangles.push_back({i, next, n + i});
    triangles.push_back({next, n + next, n + i});
  }
  return WithVertexUv(MakeSoup(std::move(position), triangles), std::move(uv));
}

MapReport JudgeHoles(const PolygonSoup& mesh) {
  VerifyOptions options;
  options.unit_disk = options.round_holes = true;
  return Judge(mesh, mesh, options);
}

TEST(VerifyRoundHoles, ARingBetweenCirclesIsValid) {
  const MapReport report = JudgeHoles(Ring(12));
  EXPECT_TRUE(report.valid()) << report.Verdict();
  EXPECT_EQ(report.holes->holes, 1);
  EXPECT_LT(report.holes->largest_error, 1e-15);
}

TEST(VerifyRoundHoles, AVertexOfAHoleOffItsCircleIsFound) {
  PolygonSoup mesh = Ring(12);
  mesh.texture[12 + 5] += Eigen::Vector2d(1e-9, 1e-9);
  const MapReport report = JudgeHoles(mesh);
  EXPECT_FALSE(report.valid());
  EXPECT_EQ(report.holes->off_circle, std::vector<Index>{12 + 5});
}

TEST(VerifyRoundHoles, ADiskHasNone) {
  const MapReport report = JudgeHoles(Wheel(kRim));
  EXPECT_FALSE(report.valid());
  EXPECT_THAT(report.Verdict(), HasSubstr("no holes"));
}

}  // namespace
}  // namespace cirque::verify
