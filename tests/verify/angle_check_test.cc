#include "cirque/verify/angle_check.h"

#include <cmath>
#include <cstdio>
#include <fstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/verify/fixtures.h"

namespace cirque::verify {
namespace {

using ::testing::HasSubstr;

TEST(AngleCheck, DelaunayMarginAndSmallestAngleOfARhombus) {
  const double h = std::sqrt(3.0) / 2;
  const PolygonSoup in =
      MakeSoup({{0, 0, 0}, {1, 0, 0}, {0.5, h, 0}, {0.5, -h, 0}}, {{0, 1, 2}, {1, 0, 3}});
  const AngleMeasures regular = *Judge(in, WithVertexUv(in, Flattened(in))).angles;
  EXPECT_NEAR(regular.delaunay_margin, kPi / 3, 1e-14);
  EXPECT_NEAR(regular.smallest_angle, kPi / 3, 1e-14);
  const AngleMeasures other_diagonal =
      *Judge(in, WithVertexUv(in, {{0, 0}, {1, 0}, {0.5, 0.5}, {0.5, -h}})).angles;
  EXPECT_NEAR(other_diagonal.delaunay_margin, kPi - kPi / 2 - kPi / 3, 1e-14);
  EXPECT_NEAR(other_diagonal.smallest_angle, kPi / 4, 1e-14);
}

TEST(AngleCheck, TargetsAreReadOrRefusedWithTheirLine) {
  const std::string path = testing::TempDir() + "verify_map_targets.txt";
  const auto read = [&](const std::string& content, Index num_vertices) {
    std::ofstream(path) << content;
    return ReadTargets(path, num_vertices);
  };
  const auto targets = read("6.25\r\nfree\n\n1e-1\n", 3);
  ASSERT_TRUE(targets.ok()) << targets.status().message();
  EXPECT_NEAR(targets->At(0, true)->lower_over_pi * kPi, 6.25, 1e-14);
  EXPECT_FALSE(targets->At(1, true).has_value());
  EXPECT_NEAR(targets->At(2, false)->upper_over_pi * kPi, 0.1, 1e-14);
  EXPECT_THAT(read("1\ntwo\n", 2).status().message(), HasSubstr(":2: 'two' is no angle sum"));
  EXPECT_THAT(read("1\nnan\n", 2).status().message(), HasSubstr(":2: 'nan' is no angle sum"));
  EXPECT_THAT(read("1\n2\n", 3).status().message(), HasSubstr("2 angle sums for 3 vertices"));
  std::remove(path.c_str());
  EXPECT_THAT(ReadTargets(path, 1).status().message(), HasSubstr("cannot be read"));
}

TEST(AngleCheck, ConesAreReadWithTwoPiElsewhere) {
  const std::string path = testing::TempDir() + "verify_map_cones.txt";
  const auto read = [&](const std::string& content) {
    std::ofstream(path) << content;
    return ReadTargets(path, 4);
  };
  const AngleTargets cones = *read("# cones\n2 1.5\n4 0.25 0.75 # a range\n");
  EXPECT_FALSE(cones.At(0, false).has_value());
  EXPECT_EQ(cones.At(0, true)->lower_over_pi, 2);
  EXPECT_EQ(cones.At(1, true)->lower_over_pi, 1.5);
  EXPECT_EQ(cones.At(1, true)->upper_over_pi, 1.5);
  EXPECT_EQ(cones.At(3, false)->lower_over_pi, 0.25);
  EXPECT_EQ(cones.At(3, false)->upper_over_pi, 0.75);
  EXPECT_THAT(read("2 1\n5 1\n").status().message(), HasSubstr(":2: no vertex '5'"));
  EXPECT_THAT(read("2 1\n1.5 1\n").status().message(), HasSubstr(":2: no vertex '1.5'"));
  EXPECT_THAT(read("2 1\n2 1\n").status().message(), HasSubstr(":2: vertex 2 is named twice"));
  EXPECT_THAT(read("2 3 1\n").status().message(), HasSubstr(":1: a cone is"));
  EXPECT_THAT(read("2 1 2 3\n").status().message(), HasSubstr(":1: a cone is"));
  std::remove(path.c_str());
}

}  // namespace
}  // namespace cirque::verify
