#include "cirque/io/cone_file.h"

#include <cmath>
#include <numeric>
#include <random>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cirque/core/metric.h"

#include "tests/common/paths.h"
#include "tests/common/surfaces.h"
#include "tests/io/mutate.h"

namespace cirque {
namespace {

using ::testing::HasSubstr;

/// A hexagonal fan whose second point in the file is isolated: vertex v of the surface is line
/// v + 1 of the file for v = 0, v + 2 beyond.
struct Case {
  Surface fan = Fan(6, 0.5);
  FileVertices vertices = {8, {0, 2, 3, 4, 5, 6, 7}};

  StatusOr<ConeTargets> Cones(const std::string& text) const {
    return ParseConeFile("a.cones", text, fan.triangulation, vertices);
  }
  StatusOr<ConeTargets> Sums(const std::string& text) const {
    return ParseAngleSumFile("a.sums", text, fan.triangulation, vertices);
  }
};

TEST(ConeFile, SetsWhatItNamesAndLeavesTheRest) {
  const Case c;
  const StatusOr<ConeTargets> targets =
      c.Cones("# cones\n1 1.5 2.5 # ranged\n\n3 0.5\n+4 0.25 0.25\n8 0 1\n");
  ASSERT_TRUE(targets.ok()) << targets.status().message();
  const ConeTargets plain = FreeBoundaryTargets(c.fan.triangulation);
  const std::vector<double> lower = {1.5, 0.5, 0.25, 0, 0, 0, 0},
                            upper = {2.5, 0.5, 0.25, 2, 2, 2, 1};
  for (Index v = 0; v < 7; ++v) {
    EXPECT_DOUBLE_EQ(targets->lower[v], lower[v] * kPi);
    EXPECT_DOUBLE_EQ(targets->upper[v], upper[v] * kPi);
  }
  EXPECT_EQ(c.Cones("")->lower, plain.lower);
  EXPECT_EQ(c.Cones("# nothing\n")->upper, plain.upper);
}

TEST(ConeFile, MessagesSayWhatWhereAndWhatToDo) {
  const Case c;
  const std::pair<const char*, const char*> kTable[] = {
      {"x 1 1\n", "a.cones:1: expected a vertex (counted from 1), got 'x'"},
      {"1.5 1\n", "a.cones:1: expected a vertex (counted from 1), got '1.5'"},
      {"1\n", "a.cones:1: expected the least angle sum"},
      {"1 1 x\n", "a.cones:1: expected the greatest angle sum"},
      {"1 1 1 1\n", "and nothing else, got '1'"},
      {"\n0 1\n", "a.cones:2: the mesh has no vertex 0: they count from 1 to 8"},
      {"9 1\n", "a.cones:1: the mesh has no vertex 9"},
      {"-1 1\n", "a.cones:1: the mesh has no vertex -1"},
      {"2 1\n", "a.cones:1: vertex 2 belongs to no face"},
      {"1 1\n3 1\n1 2\n", "a.cones:3: vertex 1 has a target already, in line 1"},
      {"1 2 1\n", "a.cones:1: vertex 1: the least angle sum 2 pi is above the greatest, 1 pi"},
      {"1 -0.5 1\n", "a.cones:1: vertex 1: the angle sum -0.5 pi is negative"},
      {"1 0 0\n", "a.cones:1: vertex 1: the angle sum 0 is out of reach"},
      {"1 inf\n", "a.cones:1: vertex 1: an angle sum must be a finite number"},
      {"1 nan nan\n", "must be a finite number"},
      {"1 6\n", "a.cones:1: vertex 1: 6 corners of less than pi each cannot reach the angle sum 6"},
      {"3 0 2.5\n",
       "a.cones:1: vertex 3: 2 corners of less than pi each cannot reach the angle sum 2.5"},
  };
  for (const auto& [text, message] : kTable) {
    SCOPED_TRACE(text);
    const StatusOr<ConeTargets> targets = c.Cones(text);
    ASSERT_FALSE(targets.ok());
    EXPECT_THAT(targets.status().message(), HasSubstr(message));
  }
}

TEST(AngleSumFile, FixesEveryVertex) {
  const Case c;
  const StatusOr<ConeTargets> targets =
      c.Sums("6.2831853071795862\n-99\n1\n2\n1\n2\n1\n2\n# the end\n");
  ASSERT_TRUE(targets.ok()) << targets.status().message();
  EXPECT_EQ(targets->lower, (std::vector<double>{2 * kPi, 1, 2, 1, 2, 1, 2}));
  EXPECT_EQ(targets->upper, targets->lower);
}

TEST(AngleSumFile, MessagesSayWhatWhereAndWhatToDo) {
  const Case c;
  const std::pair<const char*, const char*> kTable[] = {
      {"1\n1\n", "the file ends after 2 angle sums; the mesh has 8 vertices"},
      {"1\n1\n1\n1\n1\n1\n1\n1\n1\n", "a.sums:9: more angle sums follow than the 8 vertices"},
      {"1\n1 1\n", "a.sums:2: expected one angle sum in radians, and nothing else"},
      {"20\n", "a.sums:1: the vertex of this line: 6 corners of less than pi each"},
      {"-1\n", "is negative"},
      {"0\n", "is out of reach"},
  };
  for (const auto& [text, message] : kTable) {
    SCOPED_TRACE(text);
    const StatusOr<ConeTargets> targets = c.Sums(text);
    ASSERT_FALSE(targets.ok());
    EXPECT_THAT(targets.status().message(), HasSubstr(message));
  }
}

TEST(AngleSumFile, PublishedTargetsObeyGaussBonnet) {
  for (const std::string name : {"cid-aircraft", "cid-elephant", "cid-fertility_tri"}) {
    SCOPED_TRACE(name);
    const auto mesh = ReadSharedSurface(name);
    if (!mesh) GTEST_SKIP() << name << " is not there";
    const Triangulation& t = mesh->surface.triangulation;
    const StatusOr<ConeTargets> targets = ReadAngleSumFile(
        ProjectPath("../shared/meshes/" + name + "_Th_hat"), t,
        {static_cast<Index>(mesh->soup.position.size()), mesh->surface.soup_vertex});
    ASSERT_TRUE(targets.ok()) << targets.status().message();
    const GaussBonnetDefect defect = MeasureGaussBonnetDefect(t, *targets);
    EXPECT_NEAR(defect.lower, 0, 1e-9);
    EXPECT_NEAR(defect.upper, 0, 1e-9);
    EXPECT_NE(targets->lower, FreeBoundaryTargets(t).lower);
  }
}

TEST(ConeFile, MutatedIsTargetsOrAMessage) {
  const Case c;
  std::mt19937 random(3);
  int good = 0, bad = 0;
  for (int round = 0; round < 4000; ++round) {
    const StatusOr<ConeTargets> cones =
        c.Cones(testing::Mutate("1 1.5 2.5\n3 0.5\n8 0 1\n", &random));
    const StatusOr<ConeTargets> sums = c.Sums(testing::Mutate("6\n0\n1\n2\n1\n2\n1\n2\n", &random));
    for (const auto* parsed : {&cones, &sums}) {
      ++(parsed->ok() ? good : bad);
      for (Index v = 0; parsed->ok() && v < 7; ++v) {
        ASSERT_LE((**parsed).lower[v], (**parsed).upper[v]);
        ASSERT_GE((**parsed).lower[v], 0);
      }
    }
  }
  EXPECT_GT(good, 500);
  EXPECT_GT(bad, 500);
}

/// An octahedron, whose 8 triangles have the angle sum 8 pi, by vertices numbered in order.
struct Octahedron {
  Surface surface = RegularPolyhedron(8);
  FileVertices vertices = VerticesInOrder(6);
  ConeFileRounding rounding;

  /// The angle sums in units of pi.
  std::vector<double> Lower(const std::string& text) {
    const auto targets = ParseConeFile("a.cones", text, surface.triangulation, vertices, &rounding);
    EXPECT_TRUE(targets.ok()) << targets.status().message();
    std::vector<double> lower = targets->lower;
    for (double& angle : lower) angle /= kPi;
    return lower;
  }
};

TEST(ConeFile, WhatMissesByItsDigitsIsMadeExact) {
  Octahedron c;
  // Three cones of 2/3 pi and three flat vertices: 8 pi, but for 3e-6 / 3 pi.
  const std::vector<double> lower = c.Lower("1 0.666667\n2 0.666667\n3 0.666667\n");
  for (int v = 0; v < 3; ++v) EXPECT_NEAR(lower[v], 2. / 3, 1e-15);
  for (int v = 3; v < 6; ++v) EXPECT_EQ(lower[v], 2);
  EXPECT_EQ(c.rounding.cones, 3);
  EXPECT_NEAR(c.rounding.missed, 1e-6 * kPi, 1e-12);
  EXPECT_NEAR(c.rounding.largest, 1e-6 / 3 * kPi, 1e-12);
}

TEST(ConeFile, AnglesWithFewerDigitsChangeMoreAndExactOnesNot) {
  Octahedron c;
  // 1/3 + 1/6 + 3/2 = 2, given with 3, 6 and 1 decimals; 3.33e-4 are missing.
  const std::vector<double> lower = c.Lower("1 0.333\n2 0.166667\n3 1.5\n");
  EXPECT_EQ(lower[2], 1.5);
  EXPECT_LE(std::abs(lower[1] - 0.166667), 0.5000001e-6);
  EXPECT_LE(std::abs(lower[0] - 0.333), 0.5000001e-3);
  EXPECT_NEAR(lower[0] + lower[1] + lower[2], 2, 1e-15);
  EXPECT_EQ(c.rounding.cones, 2);
}

TEST(ConeFile, AMissBeyondTheDigitsStays) {
  for (const char* text : {"1 0.66667\n2 0.66668\n3 0.66667\n",  // by 2e-5, digits allow 1.5e-5
                           "1 0.5\n2 0.5\n3 1.1\n", "1 0.67\n2 0.67\n3 0.67\n", "1 1\n"}) {
    Octahedron c;
    const std::vector<double> lower = c.Lower(text);
    EXPECT_EQ(c.rounding.cones, 0) << text;
    EXPECT_NE(std::accumulate(lower.begin(), lower.end(), 0.0), 8) << text;
  }
  Octahedron exact;
  EXPECT_EQ(exact.Lower("1 0.5\n2 0.5\n3 1\n")[0], 0.5);
  EXPECT_EQ(exact.rounding.cones, 0);
}

}  // namespace
}  // namespace cirque
