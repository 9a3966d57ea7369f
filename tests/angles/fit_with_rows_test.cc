#include "cirque/angles/fit_with_rows.h"

#include <atomic>
#include <cmath>

#include <Eigen/Dense>
#include <gtest/gtest.h>

#include "cirque/angles/registry.h"

#include "tests/common/surfaces.h"

namespace cirque {
namespace {

/// The fit of a terrain's angles, and two rows of all corners.
struct Case {
  explicit Case(const std::string& name)
      : surface(GeneratedSurface("bumpy_terrain", 120)),
        reference(AnglesOf(surface).value),
        targets(FreeBoundaryTargets(surface.triangulation)),
        constraints(surface.triangulation, targets),
        objective(*AngleObjectives().Find(name)) {
    const Status status = FitAngles(Problem(), objective, **MakeAngleSolver("newton"), {}, &fit);
    EXPECT_TRUE(status.ok()) << status.message();
    rows.resize(reference.size(), 2);
    for (Index h = 0; h < rows.rows(); ++h) {
      rows(h, 0) = std::sin(0.9 * h);
      rows(h, 1) = std::cos(2.3 * h) + 0.5;  // with a part in the row space of A
    }
  }

  AngleFitProblem Problem() const { return {constraints, reference, 1e-3}; }

  Status FitRows(const Eigen::Vector2d& change, AngleFitResult* result) const {
    AngleFitProblem problem = Problem();
    problem.start = &fit.multipliers;
    RowFitMemory memory;
    return FitWithRows(problem, objective, {rows, fit.angles.value, change}, {}, &memory, result);
  }

  /// A, dense.
  Eigen::MatrixXd Equations() const {
    Eigen::MatrixXd a = Eigen::MatrixXd::Zero(constraints.num_rows(), reference.size());
    for (Index h = 0; h < reference.size(); ++h) {
      a(Triangulation::Face(h), h) = 1;
      if (constraints.VertexRow(h) != kNone) a(constraints.VertexRow(h), h) = 1;
    }
    return a;
  }

  Surface surface;
  Eigen::VectorXd reference;
  ConeTargets targets;
  AngleConstraints constraints;
  std::shared_ptr<const AngleObjective> objective;
  AngleFitResult fit;
  Eigen::MatrixXd rows;
};

TEST(FitWithRows, MeetsAllEquations) {
  for (const char* name : {"quadratic", "entropy"}) {
    SCOPED_TRACE(name);
    const Case c(name);
    const Eigen::Vector2d change(0.04, -0.03);
    AngleFitResult result;
    const Status status = c.FitRows(change, &result);
    ASSERT_TRUE(status.ok()) << status.message();
    const Eigen::Vector2d found = c.rows.transpose() * (result.angles.value - c.fit.angles.value);
    EXPECT_LT((found - change).lpNorm<Eigen::Infinity>(), 1e-11);
    const KktReport kkt = CheckFeasibility(c.constraints, result.angles.value);
    EXPECT_LT(kkt.triangle_sum_residual, 1e-14);
    EXPECT_LT(kkt.vertex_sum_residual, 1e-11);
    EXPECT_GE(kkt.smallest_angle, 1e-3 - 1e-12);
    EXPECT_GE(kkt.smallest_theta, 1e-3 - 1e-12);
  }
}

// Without an active inequality the quadratic fit is a linear system, solved densely here.
TEST(FitWithRows, IsTheProjectionThatAnotherSolverFinds) {
  const Case c("quadratic");
  const Eigen::Vector2d change(0.02, 0.01);
  AngleFitResult result;
  ASSERT_TRUE(c.FitRows(change, &result).ok());
  ASSERT_GT(result.kkt.smallest_angle, 2e-3);
  ASSERT_GT(result.kkt.smallest_theta, 2e-3);
  Eigen::MatrixXd all(c.constraints.num_rows() + 2, c.reference.size());
  all << c.Equations(), c.rows.transpose();
  Eigen::VectorXd sums = all * c.fit.angles.value;
  sums.tail(2) += change;
  const Eigen::VectorXd expected =
      c.reference + all.completeOrthogonalDecomposition().solve(sums - all * c.reference);
  EXPECT_LT((result.angles.value - expected).lpNorm<Eigen::Infinity>(), 1e-10);
  EXPECT_GT((result.angles.value - c.fit.angles.value).lpNorm<Eigen::Infinity>(), 1e-4);
}

// Any other angles that meet the same equations are farther from the references.
TEST(FitWithRows, IsNearestToTheReferences) {
  const Case c("entropy");
  AngleFitResult result;
  ASSERT_TRUE(c.FitRows({0.03, 0.02}, &result).ok());
  Eigen::MatrixXd all(c.constraints.num_rows() + 2, c.reference.size());
  all << c.Equations(), c.rows.transpose();
  const Eigen::MatrixXd kernel = all.fullPivLu().kernel();
  const auto objective = [&](const Eigen::VectorXd& alpha) {
    double sum = 0;
    for (Index h = 0; h < alpha.size(); ++h) {
      sum += c.objective->Distance(c.reference[h], alpha[h]).value;
    }
    return sum;
  };
  const double least = objective(result.angles.value);
  for (int k = 0; k < kernel.cols(); k += 7) {
    const Eigen::VectorXd direction = kernel.col(k).normalized();
    for (const double step : {1e-3, -1e-3}) {
      EXPECT_GT(objective(result.angles.value + step * direction), least);
    }
  }
}

TEST(FitWithRows, SaysWhereThereAreNoSuchAngles) {
  const Case c("entropy");
  AngleFitResult result;
  EXPECT_EQ(c.FitRows({1e3, 0}, &result).code(), StatusCode::kNotConverged);
}

// Rows enough for conjugate gradients with the Schur complement of other rows to be tried.
TEST(FitWithRows, WhatAnEarlierFitLeftChangesNothing) {
  Case c("entropy");
  c.rows.resize(c.reference.size(), 16);
  for (Index h = 0; h < c.rows.rows(); ++h) {
    for (int q = 0; q < 16; ++q) c.rows(h, q) = std::sin((0.3 + 0.17 * q) * h);
  }
  AngleFitProblem problem = c.Problem();
  problem.start = &c.fit.multipliers;
  const Eigen::VectorXd change = Eigen::VectorXd::LinSpaced(16, -0.02, 0.03);
  RowFitMemory memory;
  AngleFitResult result, fresh;
  const ExtraRows extra = {c.rows, c.fit.angles.value, change};
  ASSERT_TRUE(FitWithRows(problem, c.objective, extra, {}, &memory, &result).ok());
  for (Index h = 0; h < c.rows.rows(); ++h) c.rows.row(h) *= 1 + 0.05 * std::cos(1.3 * h);
  memory.z.resize(0);
  RowFitMemory none;
  ASSERT_TRUE(FitWithRows(problem, c.objective, extra, {}, &memory, &result).ok());
  ASSERT_TRUE(FitWithRows(problem, c.objective, extra, {}, &none, &fresh).ok());
  EXPECT_LT((result.angles.value - fresh.angles.value).lpNorm<Eigen::Infinity>(), 1e-10);
  const Eigen::VectorXd found = c.rows.transpose() * (result.angles.value - c.fit.angles.value);
  EXPECT_LT((found - change).lpNorm<Eigen::Infinity>(), 1e-11);
}

TEST(FitWithRows, TakesNoRangesAndCanBeCancelled) {
  Case c("entropy");
  AngleFitResult result;
  RowFitMemory memory;
  const std::atomic<bool> cancelled = true;
  SolveControl control;
  control.cancelled = &cancelled;
  const ExtraRows extra = {c.rows, c.fit.angles.value, Eigen::Vector2d(0.01, 0)};
  EXPECT_EQ(FitWithRows(c.Problem(), c.objective, extra, control, &memory, &result).code(),
            StatusCode::kCancelled);
  const std::vector<bool> boundary = BoundaryVertices(c.surface.triangulation);
  for (std::size_t v = 0; v < boundary.size(); ++v) {
    if (!boundary[v]) c.targets.upper[v] += 0.1;
  }
  const AngleConstraints ranged(c.surface.triangulation, c.targets);
  EXPECT_EQ(
      FitWithRows({ranged, c.reference, 1e-3}, c.objective, extra, {}, &memory, &result).code(),
      StatusCode::kInvalidInput);
}

}  // namespace
}  // namespace cirque
