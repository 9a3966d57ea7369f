// Surfaces whose best cones are known.
#include <algorithm>
#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cirque/cones/cone_fit.h"
#include "cirque/cones/cone_moves.h"
#include "cirque/cones/registry.h"
#include "cirque/cones/sparse_cones.h"
#include "cirque/mesh/preflight.h"

#include "tests/common/surfaces.h"

namespace cirque {
namespace {

/// A polyhedron whose faces are flat: every triangle of `soup` subdivided into n^2 equal ones.
Surface Subdivided(const PolygonSoup& soup, int n) {
  PolygonSoup fine;
  std::map<std::array<long, 3>, Index> at;
  const auto vertex = [&](const Eigen::Vector3d& p) {
    const std::array<long, 3> key = {std::lround(p.x() * 1e6), std::lround(p.y() * 1e6),
                                     std::lround(p.z() * 1e6)};
    const auto [found, is_new] = at.emplace(key, static_cast<Index>(fine.position.size()));
    if (is_new) fine.position.push_back(p);
    return found->second;
  };
  for (std::size_t f = 0; f + 3 <= soup.corner.size(); f += 3) {
    const Eigen::Vector3d a = soup.position[soup.corner[f]], b = soup.position[soup.corner[f + 1]],
                          c = soup.position[soup.corner[f + 2]];
    const auto point = [&](int i, int j) { return vertex(a + (b - a) * i / n + (c - a) * j / n); };
    const auto add = [&](Index u, Index v, Index w) {
      fine.corner.insert(fine.corner.end(), {u, v, w});
      fine.first_corner.push_back(static_cast<Index>(fine.corner.size()));
    };
    for (int i = 0; i < n; ++i) {
      for (int j = 0; i + j < n; ++j) {
        add(point(i, j), point(i + 1, j), point(i, j + 1));
        if (i + j + 1 < n) add(point(i + 1, j), point(i + 1, j + 1), point(i, j + 1));
      }
    }
  }
  PreflightReport report;
  return *Preflight(fine, &report);
}

PolygonSoup Soup(std::vector<Eigen::Vector3d> position, std::vector<Index> corner) {
  PolygonSoup soup;
  soup.position = std::move(position);
  soup.corner = std::move(corner);
  return soup;
}

PolygonSoup Tetrahedron() {
  return Soup({{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}},
              {0, 1, 2, 0, 2, 3, 0, 3, 1, 1, 3, 2});
}

PolygonSoup Octahedron() {
  return Soup({{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}},
              {0, 2, 4, 2, 1, 4, 1, 3, 4, 3, 0, 4, 2, 0, 5, 1, 2, 5, 3, 1, 5, 0, 3, 5});
}

PolygonSoup Cube() {
  PolygonSoup soup;
  for (int i = 0; i < 8; ++i) soup.position.emplace_back(i & 1, i >> 1 & 1, i >> 2);
  soup.corner = {0, 2, 3, 0, 3, 1, 4, 5, 7, 4, 7, 6, 0, 1, 5, 0, 5, 4,
                 2, 6, 7, 2, 7, 3, 0, 4, 6, 0, 6, 2, 1, 3, 7, 1, 7, 5};
  return soup;
}

/// The vertices where the surface is curved: its corners.
std::vector<Index> CornersOf(const ConeProblem& problem) {
  std::vector<Index> corners;
  for (const Index v : problem.candidates()) {
    if (std::abs(problem.curvature()[v]) > 1e-6) corners.push_back(v);
  }
  return corners;
}

/// Heuristics that see the distortion, and so must find cones that leave none.
std::vector<std::string> Seeing() {
  return {"curvature_peaks", "greedy", "l1", "reweighted", "moving"};
}

void ExpectCornersAreFound(const PolygonSoup& soup, std::size_t num_corners) {
  const Surface surface = Subdivided(soup, 8);
  const EdgeLengths lengths = MeasureEdgeLengths(surface);
  const ConeProblem problem(surface.triangulation, lengths);
  const std::vector<Index> corners = CornersOf(problem);
  ASSERT_EQ(corners.size(), num_corners);
  for (const std::string& name : Seeing()) {
    SCOPED_TRACE(name);
    const auto heuristic = MakeConeHeuristic(name, {{"cones", std::to_string(num_corners)}});
    const auto cones = (*heuristic)->Choose(problem);
    ASSERT_TRUE(cones.ok()) << cones.status().message();
    std::vector<Index> found;
    for (const Cone& c : *cones) {
      found.push_back(c.vertex);
      EXPECT_NEAR(2 * kPi - c.lower, problem.curvature()[c.vertex], 1e-6);
    }
    EXPECT_THAT(found, testing::UnorderedElementsAreArray(corners));
    EXPECT_LT(PredictedLogScale(problem, *cones).lpNorm<Eigen::Infinity>(), 1e-6);
  }
}

TEST(KnownCones, CornersOfATetrahedron) { ExpectCornersAreFound(Tetrahedron(), 4); }
TEST(KnownCones, CornersOfAnOctahedron) { ExpectCornersAreFound(Octahedron(), 6); }
TEST(KnownCones, CornersOfACube) { ExpectCornersAreFound(Cube(), 8); }

TEST(KnownCones, AMisplacedConeIsPutWhereItIsMissing) {
  const Surface surface = Subdivided(Cube(), 8);
  const EdgeLengths lengths = MeasureEdgeLengths(surface);
  const ConeProblem problem(surface.triangulation, lengths);
  const std::vector<Index> corners = CornersOf(problem);
  ASSERT_EQ(corners.size(), 8u);
  for (const ConeMeasureKind measure : {ConeMeasureKind::kArea, ConeMeasureKind::kAngle}) {
    SCOPED_TRACE(ToWord(measure));
    std::vector<Cone> start;
    for (int i = 1; i < 8; ++i) start.push_back(ConeOfCurvature(corners[i], kPi / 2));
    // Two edges from the second corner, which already has its own.
    Index near = kNone;
    for (const Index v : problem.candidates()) {
      const double distance = (surface.position[v] - surface.position[corners[1]]).norm();
      if (distance > 0.2 && distance < 0.3) near = v;
    }
    start.push_back(ConeOfCurvature(near, kPi / 2));
    ConeMoves moves(problem, start, measure, 30);
    ASSERT_TRUE(moves.FitStart());
    ASSERT_TRUE(moves.Relocate());
    while (moves.Sweep()) {
    }
    moves.FitEnd();
    std::vector<Index> found;
    for (const Cone& cone : moves.Cones()) found.push_back(cone.vertex);
    EXPECT_THAT(found, testing::UnorderedElementsAreArray(corners));
    EXPECT_FALSE(moves.Relocate());
  }
}

TEST(KnownCones, TheApexOfACone) {
  // A circular cone, flat but for its apex; its boundary is not flat, which is nobody's business.
  PolygonSoup base;
  base.position.emplace_back(0, 0, 0.8);
  for (int i = 0; i < 8; ++i) {
    base.position.emplace_back(std::cos(kPi * i / 4), std::sin(kPi * i / 4), 0);
    base.corner.insert(base.corner.end(), {0, 1 + i, 1 + (i + 1) % 8});
  }
  const Surface surface = Subdivided(base, 6);
  const EdgeLengths lengths = MeasureEdgeLengths(surface);
  const ConeProblem problem(surface.triangulation, lengths);
  for (const std::string& name : Seeing()) {
    SCOPED_TRACE(name);
    const auto cones = *(*MakeConeHeuristic(name, {{"cones", "1"}}))->Choose(problem);
    ASSERT_EQ(cones.size(), 1u);
    EXPECT_NEAR(surface.position[cones[0].vertex].z(), 0.8, 1e-12);
    EXPECT_NEAR(2 * kPi - cones[0].lower, problem.curvature()[cones[0].vertex], 1e-9);
  }
}

TEST(KnownCones, AFlatTorusNeedsNone) {
  // A square grid with opposite sides identified: no points in space, only lengths.
  constexpr Index n = 8;
  std::vector<Index> vertex, twin;
  const auto at = [](Index i, Index j) { return (i % n) * n + j % n; };
  std::map<std::pair<Index, Index>, Index> halfedge;
  for (Index i = 0; i < n; ++i) {
    for (Index j = 0; j < n; ++j) {
      for (const Index v :
           {at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j), at(i + 1, j + 1), at(i, j + 1)}) {
        vertex.push_back(v);
      }
    }
  }
  const auto next = [](Index h) { return Triangulation::Next(h); };
  for (Index h = 0; h < static_cast<Index>(vertex.size()); ++h) {
    halfedge[{vertex[next(h)], vertex[next(next(h))]}] = h;
  }
  for (Index h = 0; h < static_cast<Index>(vertex.size()); ++h) {
    twin.push_back(halfedge.at({vertex[next(next(h))], vertex[next(h)]}));
  }
  const Triangulation t = NumberEdges(n * n, vertex, twin);
  EdgeLengths lengths = {Eigen::VectorXd::Ones(t.num_edges())};
  for (const Index h : t.edge_halfedge) {
    if (h % 3 == 1 && h % 6 < 3) lengths.value[t.edge[h]] = std::sqrt(2.);
  }
  const ConeProblem problem(t, lengths);
  ASSERT_LT(problem.curvature().lpNorm<Eigen::Infinity>(), 1e-12);
  EXPECT_LT(problem.LogScaleWithoutCones().lpNorm<Eigen::Infinity>(), 1e-12);
  EXPECT_TRUE((*(*MakeConeHeuristic("greedy", {{"target", "1e-9"}}))->Choose(problem)).empty());
}

TEST(L1Cones, SolutionIsOptimal) {
  for (const char* name : {"blob", "bumpy_terrain"}) {
    SCOPED_TRACE(name);
    const Surface surface = GeneratedSurface(name, 600);
    const EdgeLengths lengths = MeasureEdgeLengths(surface);
    const ConeProblem problem(surface.triangulation, lengths);
    const double lambda = 1e-3;
    const BoxProgram dual = L1Dual(problem, lambda);
    const BoxSolution solution = SolveBoxProgram(dual, 1e-10);
    ASSERT_TRUE(solution.converged);
    EXPECT_LE(solution.x.lpNorm<Eigen::Infinity>(), lambda);
    EXPECT_GE(std::min(solution.lower.minCoeff(), solution.upper.minCoeff()), 0);
    // The primal from its definition: L u = mu - K, u of least distortion, mu of one sign with phi.
    const Eigen::VectorXd mu = L1Curvature(problem, solution);
    if (problem.IsClosed()) {
      EXPECT_NEAR(mu.sum(), problem.TotalCurvature(), 1e-6);
    }
    const Eigen::VectorXd u = problem.Solve(mu - problem.curvature());
    const Eigen::VectorXd phi = -problem.Solve(problem.area().cwiseProduct(u));
    Eigen::VectorXd dual_phi = Eigen::VectorXd::Zero(phi.size());
    dual_phi(problem.candidates()) = solution.x;
    if (problem.IsClosed()) dual_phi.array() -= problem.area().dot(dual_phi);
    EXPECT_LT((phi - dual_phi).lpNorm<Eigen::Infinity>(), 1e-6 * lambda);
    // Equal objectives: strong duality.
    const double primal = 0.5 * std::pow(AreaNorm(problem, u), 2) + lambda * mu.lpNorm<1>();
    const SparseMatrix hessian = dual.hessian.selfadjointView<Eigen::Lower>();
    const double value = dual.linear.dot(solution.x) - 0.5 * solution.x.dot(hessian * solution.x);
    EXPECT_GT(primal, 1e-4);
    EXPECT_NEAR(primal, value, 1e-6 * primal);
  }
}

/// sqrt(u' M u) for what the fit holds.
void ExpectFormAgrees(const ConeMeasure& measure, ConeFit* fit) {
  const Eigen::VectorXd u = fit->LogScale();
  EXPECT_NEAR(fit->Distortion(), std::sqrt(u.dot(measure.Apply(u))), 1e-9);
  EXPECT_NEAR(fit->Measure(), measure.Value(u), 1e-9);
}

void ExpectFitIsOptimal(ConeMeasureKind kind) {
  SCOPED_TRACE(ToWord(kind));
  const Surface surface = GeneratedSurface("blob", 800);
  const EdgeLengths lengths = MeasureEdgeLengths(surface);
  const ConeProblem problem(surface.triangulation, lengths);
  const auto measure = MakeConeMeasure(kind, problem);
  ConeFit fit(problem, MakeConeMeasure(kind, problem));
  for (const Index v : {3, 50, 120, 200, 310}) fit.Add(v);
  ASSERT_TRUE(fit.FitLeastSquares());
  measure->AdaptTo(fit.LogScale());
  EXPECT_EQ(fit.AdaptMeasure(), kind == ConeMeasureKind::kAngle);
  const double start = fit.Measure();
  ASSERT_TRUE(fit.FitLeastSquares());
  EXPECT_NEAR(fit.curvature().sum(), problem.TotalCurvature(), 1e-10);
  EXPECT_LE(fit.Measure(), start + 1e-12);
  ExpectFormAgrees(*measure, &fit);
  const Eigen::VectorXd slope = fit.Descent()(fit.vertices());
  for (int i = 0; i < fit.size(); ++i) {
    const bool free = fit.curvature()[i] < problem.GreatestCurvature() - 1e-9 &&
                      fit.curvature()[i] > problem.LeastCurvature(fit.vertices()[i]) + 1e-9;
    if (free) {
      EXPECT_NEAR(slope[i], slope[0], 1e-9);
    }
  }
  const double best = fit.Distortion();
  ASSERT_TRUE(fit.FitWithout(1));
  EXPECT_EQ(fit.curvature()[1], 0);
  EXPECT_GT(fit.Distortion(), best);
  fit.FitZeroAtCones();
  const Eigen::VectorXd u = fit.LogScale()(fit.vertices());
  EXPECT_LT((u.array() - u[0]).abs().maxCoeff(), 1e-10);
  EXPECT_GE(fit.Distortion(), best);
  fit.Move(2, 400);
  fit.UndoMove();
  EXPECT_EQ(fit.vertices()[2], 120);
  ExpectFormAgrees(*measure, &fit);
}

/// Products of many cones are made together, and their log scale by one solve.
TEST(ConeFit, ManyConesAddUpAsFewDo) {
  const Surface surface = GeneratedSurface("blob", 800);
  const EdgeLengths lengths = MeasureEdgeLengths(surface);
  const ConeProblem problem(surface.triangulation, lengths);
  const AreaMeasure measure(problem);
  ConeFit fit(problem);
  for (Index v = 0; v < 100; ++v) fit.Add(4 * v);
  fit.FitZeroAtCones();
  ExpectFormAgrees(measure, &fit);
  EXPECT_LT((fit.Gram() - fit.Gram().transpose()).norm(), 1e-15 * fit.Gram().norm());
  const double zero_at_cones = fit.Distortion();
  ASSERT_TRUE(fit.FitLeastSquares());
  ExpectFormAgrees(measure, &fit);
  EXPECT_LE(fit.Distortion(), zero_at_cones);
  fit.Move(80, 2);
  fit.UndoMove();
  ExpectFormAgrees(measure, &fit);
}

TEST(ConeFit, LeastSquaresIsOptimalAndZeroAtConesIsZero) {
  ExpectFitIsOptimal(ConeMeasureKind::kArea);
  ExpectFitIsOptimal(ConeMeasureKind::kAngle);
}

}  // namespace
}  // namespace cirque
