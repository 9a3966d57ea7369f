// The linear model of cones, and what the heuristics' choices do not depend on.
#include "cirque/cones/cone_problem.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <map>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cirque/cones/cone_choice.h"
#include "cirque/cones/cone_fit.h"
#include "cirque/cones/registry.h"

#include "tests/common/renumbering.h"
#include "tests/common/surfaces.h"

namespace cirque {
namespace {

class ConeProblemOf : public testing::TestWithParam<const char*> {
 protected:
  const Surface surface_ = GeneratedSurface(GetParam(), 700);
  const Triangulation& t_ = surface_.triangulation;
  const EdgeLengths lengths_ = MeasureEdgeLengths(surface_);
  const ConeProblem problem_{t_, lengths_};
};

TEST_P(ConeProblemOf, CurvatureObeysGaussBonnet) {
  if (problem_.IsClosed()) {
    EXPECT_NEAR(problem_.curvature().sum(), problem_.TotalCurvature(), 1e-10);
  }
  EXPECT_NEAR(problem_.TotalCurvature(), 2 * kPi * EulerCharacteristic(t_), 1e-15);
  EXPECT_NEAR(problem_.area().sum(), 1, 1e-12);
  EXPECT_GT(problem_.area().minCoeff(), 0);
  EXPECT_GT(problem_.curvature().lpNorm<Eigen::Infinity>(), 0.01);
}

TEST_P(ConeProblemOf, SolveInvertsTheLaplacian) {
  std::srand(4);
  Eigen::VectorXd b = Eigen::VectorXd::Random(t_.num_vertices);
  const Eigen::VectorXd u = problem_.Solve(b);
  const auto& inside = problem_.candidates();
  if (problem_.IsClosed()) {
    EXPECT_NEAR(problem_.area().dot(u), 0, 1e-12);
    b -= b.sum() * problem_.area();
  } else {
    for (Index v = 0; v < t_.num_vertices; ++v) {
      if (problem_.IsCandidate(v)) continue;
      EXPECT_EQ(u[v], 0);
    }
  }
  const Eigen::VectorXd residual = problem_.Laplacian() * u(inside) - b(inside);
  EXPECT_GT(u.norm(), 1e-3);
  EXPECT_LT(residual.lpNorm<Eigen::Infinity>(), 1e-10 * (1 + u.lpNorm<Eigen::Infinity>()));
}

TEST_P(ConeProblemOf, RespondsToUnitsAsSolveDoes) {
  const auto& inside = problem_.candidates();
  const std::vector<Index> vertices = {inside.front(), inside[inside.size() / 2], inside.back()};
  for (int time = 0; time < 2; ++time) {  // solved for, then known
    const auto responses = problem_.Responses(vertices);
    ASSERT_EQ(responses.size(), vertices.size());
    for (std::size_t i = 0; i < vertices.size(); ++i) {
      const Eigen::VectorXd u = problem_.Solve(Eigen::VectorXd::Unit(t_.num_vertices, vertices[i]));
      EXPECT_GT(u.norm(), 1e-3);
      EXPECT_LT((*responses[i] - u).lpNorm<Eigen::Infinity>(), 1e-12 * u.lpNorm<Eigen::Infinity>());
    }
  }
}

// Solved for together, cones have the curvatures that they have one by one, and moves come back.
TEST_P(ConeProblemOf, PreparedConesAreThoseOneByOne) {
  const auto& inside = problem_.candidates();
  const auto fitted = [&](bool prepared) {
    const ConeProblem problem(t_, lengths_);
    ConeFit fit(problem);
    if (prepared) fit.Prepare({inside[10], inside[20], inside[30], inside[40], inside[60]});
    for (const int i : {10, 20, 30, 40, 50}) fit.Add(inside[i]);
    fit.Move(2, inside[60]);
    fit.FitZeroAtCones();
    const Eigen::VectorXd moved = fit.curvature();
    fit.Move(0, inside[70]);
    fit.UndoMove();
    EXPECT_EQ(fit.curvature(), moved);
    return moved;
  };
  const Eigen::VectorXd prepared = fitted(true), one_by_one = fitted(false);
  EXPECT_GT(one_by_one.norm(), 0.1);
  EXPECT_LT((prepared - one_by_one).norm(), 1e-9 * one_by_one.norm());
}

TEST_P(ConeProblemOf, DoesNotDependOnScaleOrNumbering) {
  const Eigen::VectorXd u = problem_.LogScaleWithoutCones();
  const EdgeLengths larger{std::ldexp(1, 20) * lengths_.value};
  EXPECT_EQ(ConeProblem(t_, larger).LogScaleWithoutCones(), u);
  const Renumbering r = Renumber(t_, 6);
  const EdgeLengths renumbered = r.Lengths(t_, lengths_);
  const ConeProblem other(r.triangulation, renumbered);
  const Eigen::VectorXd there = other.LogScaleWithoutCones();
  for (Index v = 0; v < t_.num_vertices; ++v) {
    EXPECT_NEAR(there[r.vertex[v]], u[v], 1e-9);
    EXPECT_NEAR(other.curvature()[r.vertex[v]], problem_.curvature()[v], 1e-12);
    EXPECT_EQ(other.LeastCurvature(r.vertex[v]), problem_.LeastCurvature(v));
  }
}

std::map<Index, double> Curvatures(const std::vector<Cone>& cones) {
  std::map<Index, double> curvature;
  for (const Cone& c : cones) curvature[c.vertex] = 2 * kPi - c.lower;
  return curvature;
}

TEST_P(ConeProblemOf, HeuristicsChooseTheSameConesOnAnyScale) {
  const EdgeLengths larger{std::ldexp(1, -9) * lengths_.value};
  const ConeProblem scaled(t_, larger);
  for (const std::string& name : ConeHeuristics().Names()) {
    if (name == "none" || name == "given") continue;
    const auto heuristic = *MakeConeHeuristic(name, {{"cones", "9"}});
    const auto cones = Curvatures(*heuristic->Choose(problem_));
    EXPECT_EQ(Curvatures(*heuristic->Choose(scaled)), cones) << name;
    // A nearly flat surface with a boundary needs no quarter of a turn.
    EXPECT_GE(cones.size(), name == "seamless" ? 0u : 3u) << name;
  }
}

TEST_P(ConeProblemOf, HeuristicsChooseTheSameConesHoweverVerticesAreNumbered) {
  const Renumbering r = Renumber(t_, 12);
  const EdgeLengths renumbered = r.Lengths(t_, lengths_);
  const ConeProblem other(r.triangulation, renumbered);
  for (const std::string name : {"curvature_peaks", "greedy", "l1", "reweighted", "moving"}) {
    // The double torus is symmetric: between equal moves the numbers decide.
    if (name == "moving" && GetParam() == std::string("double_torus")) continue;
    SCOPED_TRACE(name);
    const auto heuristic = *MakeConeHeuristic(name, {{"cones", "6"}});
    const auto cones = Curvatures(*heuristic->Choose(problem_));
    const auto there = Curvatures(*heuristic->Choose(other));
    ASSERT_EQ(there.size(), cones.size());
    for (const auto& [v, curvature] : cones) {
      ASSERT_TRUE(there.contains(r.vertex[v])) << v;
      EXPECT_NEAR(there.at(r.vertex[v]), curvature, 1e-6);
    }
  }
}

TEST_P(ConeProblemOf, DistortionFallsWithTheBudget) {
  for (const OptionMap& pick : {OptionMap{{"pick", "extreme"}}, OptionMap{{"pick", "descent"}}}) {
    double first = 0, before = HUGE_VAL;
    for (const char* budget : {"4", "6", "9", "14", "20"}) {
      OptionMap options = pick;
      options["cones"] = budget;
      const auto cones = (*MakeConeHeuristic("greedy", options))->Choose(problem_);
      ASSERT_TRUE(cones.ok()) << cones.status().message();
      const double norm = AreaNorm(problem_, PredictedLogScale(problem_, *cones));
      EXPECT_LE(norm, before * (1 + 1e-9)) << budget;
      if (first == 0) first = norm;
      before = norm;
    }
    EXPECT_LT(before, 0.7 * first);
  }
}

INSTANTIATE_TEST_SUITE_P(Surfaces, ConeProblemOf,
                         testing::Values("blob", "double_torus", "bumpy_terrain"),
                         [](const auto& of_case) { return std::string(of_case.param); });

TEST(ConeProblem, LeastCurvatureLeavesHalfACorner) {
  // 5 corners: 0.6 pi each; 20 corners: 12 pi in all; of 2 pi in all 1.2 pi at two.
  const Triangulation icosahedron = RegularPolyhedron(20).triangulation;
  const EdgeLengths ones{Eigen::VectorXd::Ones(icosahedron.num_edges())};
  const ConeProblem problem(icosahedron, ones);
  EXPECT_NEAR(problem.LeastCurvature(3), -kPi, 1e-15);
  EXPECT_NEAR(problem.curvature()[3], kPi / 3, 1e-12);
  // Regular: no curvature is missing anywhere, u is constant and so 0.
  Eigen::VectorXd even = Eigen::VectorXd::Constant(12, kPi / 3);
  EXPECT_LT(problem.Solve(even - problem.curvature()).lpNorm<Eigen::Infinity>(), 1e-12);
  EXPECT_LT(problem.LogScaleWithoutCones().lpNorm<Eigen::Infinity>(), 1e-12);
}

TEST(ConeProblem, ACornerLostInTheSourceDoesNotCount) {
  const Surface surface = GeneratedSurface("blob", 300);
  const EdgeLengths lengths = MeasureEdgeLengths(surface);
  // A source in which one vertex has fewer corners: numbered otherwise.
  const Renumbering r = Renumber(surface.triangulation, 1);
  const EdgeLengths renumbered = r.Lengths(surface.triangulation, lengths);
  const IntrinsicSurface source = MeasureSurface(r.triangulation, renumbered);
  const ConeProblem problem(MeasureSurface(surface.triangulation, lengths), {&source, {}});
  const std::vector<Index> own = CornersPerVertex(surface.triangulation);
  const std::vector<Index> there = CornersPerVertex(r.triangulation);
  int fewer = 0;
  for (Index v = 0; v < surface.triangulation.num_vertices; ++v) {
    const double corners = std::min(own[v], there[v]);
    fewer += there[v] < own[v];
    EXPECT_NEAR(problem.LeastCurvature(v), 2 * kPi - kPi * std::min(corners - 0.5, 0.6 * corners),
                1e-12);
  }
  EXPECT_GT(fewer, 10);
}

TEST(ConeChoice, KeepsTheTotalWithinReach) {
  const Surface surface = GeneratedSurface("double_torus", 400);
  const EdgeLengths lengths = MeasureEdgeLengths(surface);
  const ConeProblem problem(surface.triangulation, lengths);
  StatusOr<ConeChoice> choice = ConeChoice::Make(problem, 3);
  ASSERT_TRUE(choice.ok()) << choice.status().message();
  // All scores alike: the first vertices are taken, but only such that the rest can carry -4 pi.
  const Eigen::VectorXd score = Eigen::VectorXd::Zero(surface.triangulation.num_vertices);
  double least = 0;
  std::vector<Index> chosen;
  while (const auto v = choice->TakeBest(score)) {
    least += problem.LeastCurvature(*v);
    EXPECT_FALSE(std::count(chosen.begin(), chosen.end(), *v));
    chosen.push_back(*v);
  }
  EXPECT_EQ(chosen.size(), 3u);
  EXPECT_EQ(choice->left(), 0);
  EXPECT_LE(least, problem.TotalCurvature() + 1e-9);
}

TEST(ConeChoice, TakesTheBestAndNeverTooFew) {
  const Surface surface = GeneratedSurface("sphere", 300);
  const EdgeLengths lengths = MeasureEdgeLengths(surface);
  const ConeProblem problem(surface.triangulation, lengths);
  StatusOr<ConeChoice> choice = ConeChoice::Make(problem, 4);
  ASSERT_TRUE(choice.ok());
  Eigen::VectorXd score = Eigen::VectorXd::Zero(surface.triangulation.num_vertices);
  score[17] = 3;
  score[5] = 2;
  EXPECT_EQ(choice->TakeBest(score), 17);
  EXPECT_EQ(choice->TakeBest(score), 5);
  score.setConstant(-HUGE_VAL);
  EXPECT_FALSE(choice->TakeBest(score));
  // At most 1.75 pi each: three are the least that carry 4 pi.
  for (const int count : {0, 1, 2}) EXPECT_EQ(ConeChoice::Make(problem, count)->left(), 3);
}

}  // namespace
}  // namespace cirque
