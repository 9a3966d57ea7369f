#include "cirque/cones/cone_sweeps.h"

#include <cmath>

#include <gtest/gtest.h>

#include "cirque/cones/cone_heuristic.h"
#include "cirque/cones/moving_cones.h"
#include "cirque/cones/registry.h"

#include "tests/common/surfaces.h"

namespace cirque {
namespace {

/// Many equal cones at every k-th vertex, wherever that is.
std::vector<Cone> EvenCones(const ConeProblem& problem, int count) {
  std::vector<Cone> cones;
  const auto most = static_cast<Index>(problem.candidates().size());
  for (int i = 0; i < count; ++i) {
    cones.push_back(
        ConeOfCurvature(problem.candidates()[most / count * i], problem.TotalCurvature() / count));
  }
  return cones;
}

class ConeSweepsOf : public testing::TestWithParam<ConeMeasureKind> {
 protected:
  ConeSweepsOf()
      : surface_(GeneratedSurface("blob", 3000)),
        lengths_(MeasureEdgeLengths(surface_)),
        problem_(surface_.triangulation, lengths_) {}

  double MeasureOf(const std::vector<Cone>& cones) const {
    return MakeConeMeasure(GetParam(), problem_)->Value(PredictedLogScale(problem_, cones));
  }

  Surface surface_;
  EdgeLengths lengths_;
  ConeProblem problem_;
};

TEST_P(ConeSweepsOf, LowerTheMeasureByMuchAndNeverRaiseIt) {
  const std::vector<Cone> start = EvenCones(problem_, 120);
  ConeSweeps sweeps(problem_, start, GetParam());
  EXPECT_NEAR(sweeps.Measure(), MeasureOf(start), 1e-9);
  double before = sweeps.Measure();
  for (int sweep = 0; sweep < 10 && sweeps.Sweep(); ++sweep) {
    EXPECT_LE(sweeps.Measure(), before * (1 + 1e-12));
    before = sweeps.Measure();
  }
  sweeps.Run(30);
  EXPECT_LE(sweeps.Measure(), before * (1 + 1e-12));
  EXPECT_LT(sweeps.Measure(), 0.6 * MeasureOf(start));
  EXPECT_NEAR(sweeps.Measure(), MeasureOf(sweeps.Cones()), 1e-9);
}

TEST_P(ConeSweepsOf, KeepNumberTotalAndBounds) {
  ConeSweeps sweeps(problem_, EvenCones(problem_, 150), GetParam());
  sweeps.Run(10);
  const std::vector<Cone> cones = sweeps.Cones();
  EXPECT_EQ(cones.size(), 150u);
  EXPECT_TRUE(ConeTargetsOf(surface_.triangulation, cones).ok());  // none twice, Gauss-Bonnet
  for (const Cone& c : cones) {
    EXPECT_GE(2 * kPi - c.lower, problem_.LeastCurvature(c.vertex) - 1e-12);
    EXPECT_LE(2 * kPi - c.lower, problem_.GreatestCurvature() + 1e-12);
  }
}

INSTANTIATE_TEST_SUITE_P(Measures, ConeSweepsOf,
                         testing::Values(ConeMeasureKind::kArea, ConeMeasureKind::kAngle),
                         [](const auto& test) { return ToWord(test.param); });

TEST(ConeMeasure, SharesAddUpToTheMeasure) {
  const Surface surface = GeneratedSurface("blob", 500);
  const EdgeLengths lengths = MeasureEdgeLengths(surface);
  const ConeProblem problem(surface.triangulation, lengths);
  const Eigen::VectorXd u = problem.LogScaleWithoutCones();
  const auto area = MakeConeMeasure(ConeMeasureKind::kArea, problem);
  EXPECT_NEAR(std::sqrt(area->Shares(u).sum()), area->Value(u), 1e-12);
  const auto angle = MakeConeMeasure(ConeMeasureKind::kAngle, problem);
  EXPECT_NEAR(angle->Shares(u).sum(), angle->Value(u), 1e-12);
  EXPECT_GE(angle->Shares(u).minCoeff(), 0);
}

TEST(MovingCones, MovesMoreThanOneByOneAllAtOnce) {
  const Surface surface = GeneratedSurface("double_torus", 4000);
  const EdgeLengths lengths = MeasureEdgeLengths(surface);
  const ConeProblem problem(surface.triangulation, lengths);
  const auto choose = [&](const std::string& name, const OptionMap& options) {
    return *(*MakeConeHeuristic(name, options))->Choose(problem);
  };
  const auto norm = [&](const std::vector<Cone>& cones) {
    return AreaNorm(problem, PredictedLogScale(problem, cones));
  };
  const auto vertices = [](const std::vector<Cone>& cones) {
    std::vector<Index> of_cones;
    for (const Cone& cone : cones) of_cones.push_back(cone.vertex);
    return of_cones;
  };
  const auto expect_all_at_once = [&](std::size_t more_than, OptionMap budget,
                                      const OptionMap& own) {
    const std::vector<Cone> peaks = choose("curvature_peaks", budget);
    budget.insert(own.begin(), own.end());
    budget["start"] = "curvature_peaks";
    const std::vector<Cone> moved = choose("moving", budget);
    EXPECT_EQ(moved.size(), peaks.size());
    EXPECT_GT(peaks.size(), more_than);
    EXPECT_LT(norm(moved), norm(peaks));
    ConeSweeps sweeps(problem, peaks, ConeMeasureKind::kArea);
    sweeps.Run(MovingOptions().max_sweeps);
    EXPECT_EQ(vertices(moved), vertices(sweeps.Cones()));
    EXPECT_NE(vertices(moved), vertices(peaks));
  };
  expect_all_at_once(96, {{"cones", "110"}}, {});
  expect_all_at_once(12, {{"cones", "20"}}, {{"one_by_one", "12"}});
}

}  // namespace
}  // namespace cirque
