#include "cirque/verify/judge_map.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace cirque {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;

/// Two triangles of the unit square, mapped to themselves.
PolygonSoup Square() {
  PolygonSoup soup;
  soup.position = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  soup.corner = {0, 1, 2, 0, 2, 3};
  soup.first_corner = {0, 3, 6};
  soup.texture = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  soup.corner_texture = soup.corner;
  return soup;
}

TEST(JudgeMap, TheIdentityIsValid) {
  const auto verdict = JudgeMap(Square(), Square());
  ASSERT_TRUE(verdict.ok());
  EXPECT_TRUE(verdict->valid);
  EXPECT_THAT(verdict->verdict, HasSubstr("valid (injective"));
  EXPECT_THAT(verdict->errors, IsEmpty());
  EXPECT_THAT(verdict->json, HasSubstr("{"));
}

TEST(JudgeMap, AFlipIsFound) {
  PolygonSoup flipped = Square();
  flipped.texture[3] = {1, 0.5};
  const auto verdict = JudgeMap(Square(), flipped);
  ASSERT_TRUE(verdict.ok());
  EXPECT_FALSE(verdict->valid);
  EXPECT_THAT(verdict->verdict, HasSubstr("INVALID"));
}

TEST(JudgeMap, OptionsCount) {
  JudgeOptions on_circle;
  on_circle.domain = "disk";
  EXPECT_FALSE(JudgeMap(Square(), Square(), on_circle)->valid);
  on_circle.domain = "dusk";
  EXPECT_FALSE(JudgeMap(Square(), Square(), on_circle).ok());
}

TEST(JudgeMap, OfASphere) {
  PolygonSoup octahedron;
  octahedron.position = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
  octahedron.corner = {0, 2, 4, 2, 1, 4, 1, 3, 4, 3, 0, 4, 2, 0, 5, 1, 2, 5, 3, 1, 5, 0, 3, 5};
  for (Index p = 1; p <= 8; ++p) octahedron.first_corner.push_back(3 * p);
  std::vector<Eigen::Vector3d> position = octahedron.position;
  EXPECT_TRUE(JudgeSphereMap(octahedron, position)->valid);
  std::swap(position[4], position[5]);
  EXPECT_FALSE(JudgeSphereMap(octahedron, position)->valid);
  position.pop_back();
  EXPECT_FALSE(JudgeSphereMap(octahedron, position).ok());
}

}  // namespace
}  // namespace cirque
