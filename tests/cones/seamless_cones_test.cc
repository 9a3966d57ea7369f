#include "cirque/cones/seamless_cones.h"

#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cirque/cones/registry.h"
#include "cirque/cones/rotation_model.h"
#include "cirque/cones/seamless_search.h"
#include "cirque/intrinsic/intrinsic_delaunay.h"

#include "tests/common/surfaces.h"

namespace cirque {
namespace {

using ::testing::HasSubstr;

struct Sought {
  explicit Sought(const char* generator, Index triangles = 2000)
      : surface(GeneratedSurface(generator, triangles)),
        lengths(MeasureEdgeLengths(surface)),
        metric(MakeIntrinsicDelaunay(surface.triangulation, lengths)),
        problem(metric.triangulation, metric.lengths),
        model(problem, Loops()) {}

  std::vector<SignedCorners> Loops() const {
    std::vector<SignedCorners> loops;
    for (const DualPath& loop : HandleLoops(metric.triangulation)) {
      loops.push_back(CornersAlong(metric.triangulation, loop));
    }
    return loops;
  }

  double Miss(const std::vector<Cone>& cones, double unit) const {
    double miss = 0;
    for (const double r : model.Predict(cones))
      miss = std::max(miss, std::abs(BeyondMultiple(r, unit)));
    return miss;
  }

  std::vector<Cone> By(const std::string& name, const OptionMap& options) const {
    return *(*MakeConeHeuristic(name, options))->Choose(problem);
  }

  Surface surface;
  EdgeLengths lengths;
  IntrinsicTriangulation metric;
  ConeProblem problem;
  RotationModel model;
};

TEST(SeamlessCones, MeetRotationsThatTheirStartMisses) {
  for (const auto& [word, unit] : {std::pair("pi/2", kPi / 2), std::pair("pi/3", kPi / 3)}) {
    const Sought sought("double_torus");
    const ConeAngleOptions angles = *ParseConeAngles(word);
    const std::vector<Cone> start =
        *ApplyConeAngles(sought.problem, sought.By("moving", {{"cones", "12"}}), angles);
    const std::vector<Cone> cones = sought.By("seamless", {{"angles", word}});
    EXPECT_GT(sought.Miss(start, unit), 0.05) << word;
    EXPECT_LT(sought.Miss(cones, unit), 0.02) << word;
    ASSERT_EQ(cones.size(), start.size());
    double curvature = 0;
    for (const Cone& cone : cones) {
      EXPECT_EQ(cone.lower, cone.upper);
      EXPECT_NEAR(BeyondMultiple(cone.lower, unit), 0, 1e-14);
      EXPECT_GE(2 * kPi - cone.lower, sought.problem.LeastCurvature(cone.vertex));
      curvature += 2 * kPi - cone.lower;
    }
    EXPECT_NEAR(curvature, -4 * kPi, 1e-12);
    const auto area = [&](const std::vector<Cone>& of) {
      return AreaNorm(sought.problem, PredictedLogScale(sought.problem, of));
    };
    EXPECT_LT(area(cones), 1.25 * area(start)) << word;
  }
}

// What the search keeps up to date from move to move is what the model says of its cones.
TEST(SeamlessSearch, KeepsRotationsAndAreaUpToDate) {
  const Sought sought("torus", 1200);
  const std::vector<Cone> start = *ApplyConeAngles(
      sought.problem, sought.By("moving", {{"cones", "8"}}), {ConeAngleRule::kHalves});
  SeamlessSearch search(sought.problem, sought.model, start, kPi / 2);
  EXPECT_NEAR(search.Miss(), sought.Miss(start, kPi / 2), 1e-12);
  const double area = search.AreaDistortion();
  search.DescendArea(nullptr);
  EXPECT_LE(search.AreaDistortion(), area);
  // As if the finished metric had turned by so much more.
  const Eigen::Vector2d offset(0.3, -0.2);
  search.Run(offset, nullptr);
  EXPECT_GT(search.moves(), 0);
  EXPECT_LT(search.Miss(), 5e-3);
  EXPECT_NEAR(search.AreaDistortion(),
              AreaNorm(sought.problem, PredictedLogScale(sought.problem, search.cones())), 1e-9);
  double miss = 0;
  const Eigen::VectorXd predicted = sought.model.Predict(search.cones()) + offset;
  for (const double r : predicted) miss = std::max(miss, std::abs(BeyondMultiple(r, kPi / 2)));
  EXPECT_NEAR(miss, search.Miss(), 1e-10);
}

TEST(SeamlessSearch, StopsWhenCancelled) {
  const Sought sought("double_torus");
  const std::vector<Cone> start = *ApplyConeAngles(
      sought.problem, sought.By("greedy", {{"cones", "12"}}), {ConeAngleRule::kHalves});
  SeamlessSearch search(sought.problem, sought.model, start, kPi / 2);
  const std::atomic<bool> cancelled = true;
  search.DescendArea(&cancelled);
  search.Run(Eigen::VectorXd::Zero(4), &cancelled);
  EXPECT_EQ(search.moves(), 0);
}

TEST(SeamlessCones, RefuseWhatTheyCannotBe) {
  EXPECT_THAT(MakeConeHeuristic("seamless", {{"start", "seamless"}}).status().message(),
              HasSubstr("never begin"));
  EXPECT_THAT(MakeConeHeuristic("seamless", {{"start", "gredy"}}).status().message(),
              HasSubstr("greedy"));
  EXPECT_THAT(MakeConeHeuristic("seamless", {{"angles", "ranges"}}).status().message(),
              HasSubstr("pi/2, pi/3 or free"));
}

TEST(SeamlessCones, OfFreeAnglesAreTheStartsOwn) {
  const Sought sought("double_torus");
  const std::vector<Cone> free = sought.By("seamless", {{"angles", "free"}});
  const std::vector<Cone> moving = sought.By("moving", {{"cones", "12"}});
  ASSERT_EQ(free.size(), moving.size());
  ASSERT_GT(free.size(), 4u);
  for (std::size_t i = 0; i < free.size(); ++i) {
    EXPECT_EQ(free[i].vertex, moving[i].vertex);
    EXPECT_EQ(free[i].lower, moving[i].lower);
  }
}

TEST(SeamlessCones, BudgetGrowsWithTheHandles) {
  EXPECT_EQ(SeamlessBudget(Sought("torus", 600).problem, ConeAngleRule::kHalves), 8);
  EXPECT_EQ(SeamlessBudget(Sought("double_torus", 600).problem, ConeAngleRule::kHalves), 12);
  EXPECT_EQ(SeamlessBudget(Sought("blob", 600).problem, ConeAngleRule::kHalves), 8);
  EXPECT_EQ(SeamlessBudget(Sought("blob", 600).problem, ConeAngleRule::kThirds), 12);
}

}  // namespace
}  // namespace cirque
