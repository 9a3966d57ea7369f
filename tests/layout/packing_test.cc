#include "cirque/layout/packing.h"

#include <random>

#include <gtest/gtest.h>

namespace cirque {
namespace {

/// One triangle a patch, of any shape, size and place.
CornerUv RandomTriangles(int count) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> coordinate(-1, 1), size(0.05, 3);
  CornerUv uv;
  for (int i = 0; i < count; ++i) {
    const Eigen::Vector2d centre = 10 * Eigen::Vector2d(coordinate(random), coordinate(random));
    const double s = size(random);
    for (int k = 0; k < 3; ++k) {
      uv.value.push_back(centre + s * Eigen::Vector2d(coordinate(random), coordinate(random)));
    }
  }
  return uv;
}

Patches EachItsOwn(int count) {
  Patches patches = {count, {}};
  for (int i = 0; i < count; ++i) patches.of_face.push_back(i);
  return patches;
}

double SignedArea(const CornerUv& uv, int face) {
  const Eigen::Vector2d a = uv.value[3 * face + 1] - uv.value[3 * face];
  const Eigen::Vector2d b = uv.value[3 * face + 2] - uv.value[3 * face];
  return 0.5 * (a.x() * b.y() - a.y() * b.x());
}

TEST(PackPatches, BoxesLieApartInTheUnitSquareAndAreasKeepTheirRatios) {
  for (const int count : {1, 2, 7, 200}) {
    for (const bool rotate : {false, true}) {
      const CornerUv uv = RandomTriangles(count);
      const Packing packing = PackPatches(uv, EachItsOwn(count), {rotate, 1. / 256, true});
      ASSERT_EQ(packing.boxes.size(), static_cast<std::size_t>(count));
      double filled = 0;
      for (int i = 0; i < count; ++i) {
        const Eigen::AlignedBox2d& box = packing.boxes[i];
        filled += box.volume();
        EXPECT_GE(box.min().minCoeff(), 0);
        EXPECT_LE(box.max().maxCoeff(), 1);
        for (int k = 0; k < 3; ++k) EXPECT_TRUE(box.contains(packing.uv.value[3 * i + k]));
        for (int j = 0; j < i; ++j) EXPECT_FALSE(box.intersects(packing.boxes[j]));
        EXPECT_NEAR(SignedArea(packing.uv, i), packing.scale * packing.scale * SignedArea(uv, i),
                    1e-12);
      }
      EXPECT_GT(filled, count == 200 ? 0.75 : 0.1);
    }
  }
}

TEST(PackPatches, PatchesKeepTheirSizeWhereAsked) {
  const CornerUv uv = RandomTriangles(7);
  const Packing packing = PackPatches(uv, EachItsOwn(7), {.rotate = true, .to_unit_square = false});
  EXPECT_EQ(packing.scale, 1);
  for (int i = 0; i < 7; ++i) {
    EXPECT_NEAR(SignedArea(packing.uv, i), SignedArea(uv, i), 1e-12);
    EXPECT_GE(packing.boxes[i].min().minCoeff(), 0);
  }
}

/// Strips of four squares, half of them standing, fill a square again: nothing is lost but the gaps.
TEST(PackPatches, TurnsRectanglesToWhereTheyFit) {
  CornerUv uv;
  for (const auto& [w, h] : {std::pair(4., 1.), {1., 4.}, {4., 1.}, {1., 4.}}) {
    uv.value.insert(uv.value.end(), {{0, 0}, {w, 0}, {w, h}, {0, 0}, {w, h}, {0, h}});
  }
  const Packing packing = PackPatches(uv, {4, {0, 0, 1, 1, 2, 2, 3, 3}}, {true, 1e-6, false});
  Eigen::AlignedBox2d all;
  for (const Eigen::AlignedBox2d& box : packing.boxes) all.extend(box);
  EXPECT_LT(all.sizes().maxCoeff(), 4.001);
}

TEST(PackPatches, ASinglePatchFillsTheSquare) {
  CornerUv uv;
  uv.value = {{2, 2}, {5, 2}, {5, 5}, {2, 2}, {5, 5}, {2, 5}};
  const Packing packing = PackPatches(uv, {1, {0, 0}}, {});
  EXPECT_NEAR(packing.boxes[0].volume(), 1, 1e-9);
  EXPECT_NEAR(packing.scale, 1. / 3, 1e-9);
}

TEST(LeastRectangle, FindsTheSidesOfATurnedRectangle) {
  const Eigen::Rotation2Dd turn(0.3);
  std::vector<Eigen::Vector2d> points;
  std::mt19937 random(2);
  std::uniform_real_distribution<double> x(0, 5), y(0, 2);
  for (int i = 0; i < 50; ++i) points.push_back(turn * Eigen::Vector2d(x(random), y(random)));
  for (const auto& corner : {Eigen::Vector2d(0, 0), {5, 0}, {5, 2}, {0, 2}}) {
    points.push_back(turn * corner);
  }
  EXPECT_NEAR(std::remainder(LeastRectangleDirection(points) - 0.3, kPi / 2), 0, 1e-12);
}

TEST(LeastRectangle, IsNoLargerThanAtAnyOtherDirection) {
  std::mt19937 random(11);
  std::normal_distribution<double> normal;
  for (int trial = 0; trial < 20; ++trial) {
    std::vector<Eigen::Vector2d> points;
    for (int i = 0; i < 30; ++i) points.emplace_back(3 * normal(random), normal(random));
    const auto area_at = [&](double direction) {
      Eigen::AlignedBox2d box;
      for (const auto& p : points) box.extend(Eigen::Vector2d(Eigen::Rotation2Dd(-direction) * p));
      return box.volume();
    };
    const double least = area_at(LeastRectangleDirection(points));
    for (int i = 0; i < 720; ++i) EXPECT_LE(least, area_at(kPi * i / 720) + 1e-9);
  }
}

TEST(LeastRectangle, DegeneratePointsAreNoTrouble) {
  EXPECT_EQ(LeastRectangleDirection({}), 0);
  EXPECT_EQ(LeastRectangleDirection({{1, 1}, {1, 1}}), 0);
  EXPECT_NEAR(std::remainder(LeastRectangleDirection({{0, 0}, {1, 1}, {2, 2}}) - kPi / 4, kPi / 2),
              0, 1e-12);
}

}  // namespace
}  // namespace cirque
