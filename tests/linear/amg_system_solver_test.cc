// Multigrid in the place of factorizations: where the build has PETSc, otherwise a clear refusal.
#include "cirque/linear/amg_system_solver.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cirque/energy/dual_angle_energy.h"

#include "tests/common/surfaces.h"
#include "tests/linear/grid_matrix.h"
#include "tests/solver/strategy_fixtures.h"

namespace cirque {
namespace {

using testing::Contains;
using testing::HasSubstr;

constexpr int kSide = 40;

TEST(NewtonAmg, IsKnownByNameInEveryBuild) {
  EXPECT_THAT(KnownStrategyNames(), Contains("newton_amg"));
  const auto strategy = MakeSolverStrategy("newton_amg");
  EXPECT_EQ(strategy.ok(), BuiltWithMultigrid());
  if (BuiltWithMultigrid()) {
    EXPECT_THAT(SolverStrategies().Names(), Contains("newton_amg"));
    return;
  }
  EXPECT_THAT(SolverStrategies().Names(), testing::Not(Contains("newton_amg")));
  EXPECT_EQ(strategy.status().code(), StatusCode::kInvalidInput);
  EXPECT_EQ(strategy.status().message(),
            "newton_amg: built without PETSc: install petsc-dev, libhypre-dev, libopenmpi-dev and "
            "pkg-config, and configure again");
  EXPECT_EQ(LoadMultigrid().status().message(), strategy.status().message());
}

TEST(NewtonAmg, IsChosenForTheLargestSystems) {
  const auto automatic = Strategy("auto");
  const auto uses_multigrid = [&](int num_unknowns) {
    const auto solver = automatic->MakeSystemSolver(num_unknowns);
    return dynamic_cast<const AmgSystemSolver*>(solver.get()) != nullptr;
  };
  EXPECT_FALSE(uses_multigrid(19'999'999));
  EXPECT_EQ(uses_multigrid(20'000'000), BuiltWithMultigrid());
}

class AmgSystemSolverTest : public ::testing::TestWithParam<std::string> {
 protected:
  void SetUp() override {
    if (!BuiltWithMultigrid()) GTEST_SKIP() << "built without PETSc";
  }

  /// |A x - b| / |b| of a solve.
  double Residual(AmgSystemSolver* solver, const SparseMatrix& lower, double tolerance) {
    const Eigen::VectorXd b = Eigen::VectorXd::LinSpaced(lower.cols(), 1, 3);
    Eigen::VectorXd x;
    EXPECT_TRUE(solver->Solve(lower, b, {tolerance}, &x, &summary_));
    return (lower.selfadjointView<Eigen::Lower>() * x - b).norm() / b.norm();
  }

  SolveSummary summary_;
};

TEST_P(AmgSystemSolverTest, SolvesToTheToleranceAndNotFarBeyond) {
  AmgSystemSolver solver({GetParam()});
  EXPECT_LE(Residual(&solver, GridMatrix(kSide, 1e-3), 1e-10), 1e-10);
  EXPECT_GT(Residual(&solver, GridMatrix(kSide, 1e-3), 1e-2), 1e-7);
  EXPECT_EQ(solver.Remark(), "");
}

TEST_P(AmgSystemSolverTest, AHierarchyServesWhatChangesLittle) {
  AmgSystemSolver solver({GetParam()});
  for (const double spread : {0.0, 0.1, 0.2}) {
    EXPECT_LE(Residual(&solver, GridMatrix(kSide, 1e-3, spread), 1e-8), 1e-8);
    EXPECT_EQ(summary_.factorizations, 1);
    EXPECT_EQ(summary_.symbolic_analyses, 1);
  }
  EXPECT_GT(summary_.cg_iterations, 3);
  EXPECT_GT(summary_.factorization_seconds, 0);
}

TEST_P(AmgSystemSolverTest, LargeChangesGetTheirOwn) {
  AmgSystemSolver solver({GetParam()});
  EXPECT_LE(Residual(&solver, GridMatrix(kSide, 1e-3), 1e-8), 1e-8);
  EXPECT_LE(Residual(&solver, GridMatrix(kSide, 1e-3, 1e3), 1e-8), 1e-8);
  EXPECT_EQ(summary_.factorizations, 2);
  EXPECT_EQ(solver.Remark(), "");
}

TEST_P(AmgSystemSolverTest, AnotherPatternIsAnotherSystem) {
  AmgSystemSolver solver({GetParam()});
  EXPECT_LE(Residual(&solver, GridMatrix(kSide, 1e-3), 1e-8), 1e-8);
  SparseMatrix band(50, 50);
  for (int i = 0; i < 50; ++i) {
    for (int j = i; j < std::min(i + 6, 50); ++j) band.insert(j, i) = i == j ? 11 : -1;
  }
  band.makeCompressed();
  EXPECT_LE(Residual(&solver, band, 1e-8), 1e-8);
}

TEST_P(AmgSystemSolverTest, WhatDoesNotConvergeIsFactoredAndSaidToBe) {
  AmgSystemSolver solver({GetParam(), 1});
  for (int i = 0; i < 3; ++i) EXPECT_LE(Residual(&solver, GridMatrix(kSide, 1e-3), 1e-10), 1e-10);
  EXPECT_EQ(solver.Remark(), "3 of 3 systems factored: multigrid did not converge");
}

TEST_P(AmgSystemSolverTest, AnIndefiniteMatrixIsRefused) {
  AmgSystemSolver solver({GetParam()});
  const SparseMatrix lower = GridMatrix(kSide, -0.5);
  Eigen::VectorXd x;
  EXPECT_FALSE(solver.Solve(lower, Eigen::VectorXd::Ones(lower.cols()), {1e-8}, &x, &summary_));
  EXPECT_EQ(solver.Remark(), "");
}

TEST_P(AmgSystemSolverTest, OneHierarchyServesWhatIsNearItsMatrix) {
  AmgSystemSolver solver({GetParam()});
  SparseMatrix lower = GridMatrix(kSide, 1e-3);
  solver.PrepareForSystemsNear(lower, &summary_);
  EXPECT_LE(Residual(&solver, lower, 1e-10), 1e-10);
  for (const int row : {100, 700, 1111}) lower.coeffRef(row, row) += 50;
  const int cycles_before = summary_.cg_iterations;
  EXPECT_LE(Residual(&solver, lower, 1e-10), 1e-10);
  EXPECT_GT(summary_.cg_iterations, cycles_before);
  EXPECT_EQ(summary_.factorizations, 1);
  EXPECT_EQ(solver.Remark(), "");
}

INSTANTIATE_TEST_SUITE_P(Methods, AmgSystemSolverTest, ::testing::Values("boomeramg", "gamg"));

TEST(NewtonAmg, FitsAnglesOnOneHierarchy) {
  if (!BuiltWithMultigrid()) GTEST_SKIP() << "built without PETSc";
  const Surface surface = GeneratedSurface("bumpy_terrain", 2000);
  const Triangulation& t = surface.triangulation;
  const CornerAngles reference = AnglesOf(surface);
  const DualAngleEnergy energy(AngleConstraints(t, FreeBoundaryTargets(t)), reference.value, 0.05,
                               *AngleObjectives().Find("quadratic"));
  const auto angles = [&](const std::string& strategy, SolveSummary* summary) {
    Eigen::VectorXd y = Eigen::VectorXd::Zero(energy.NumParameters());
    *summary = Strategy(strategy)->Minimize(energy, {}, &y);
    EXPECT_TRUE(summary->Converged()) << summary->message;
    return energy.Angles(y.data());
  };
  SolveSummary newton, newton_amg;
  const Eigen::VectorXd wanted = angles("newton", &newton), got = angles("newton_amg", &newton_amg);
  EXPECT_LT((wanted - got).lpNorm<Eigen::Infinity>(), 1e-10);
  EXPECT_GT((wanted - reference.value).lpNorm<Eigen::Infinity>(), 1e-2);
  EXPECT_EQ(newton_amg.strategy, "newton_amg");
  EXPECT_EQ(newton_amg.factorizations, 1);
}

TEST(NewtonAmg, TheSummaryTellsOfFactorizations) {
  if (!BuiltWithMultigrid()) GTEST_SKIP() << "built without PETSc";
  const QuadraticEnergy energy(Eigen::VectorXd::LinSpaced(300, -1, 1));
  // A chain: elimination leaves every other unknown, one iteration is too few for the rest.
  Eigen::VectorXd x = Eigen::VectorXd::Zero(300);
  const SolveSummary few =
      Strategy("newton_amg", {{"max_cg_iterations", "1"}, {"forcing", "1e-10"}})
          ->Minimize(energy, {}, &x);
  EXPECT_TRUE(few.Converged());
  EXPECT_THAT(few.message, HasSubstr("systems factored: multigrid did not converge"));
  EXPECT_THAT(few.strategy, HasSubstr("systems factored"));
  x.setZero();
  const SolveSummary enough = Strategy("newton_amg")->Minimize(energy, {}, &x);
  EXPECT_TRUE(enough.Converged());
  EXPECT_EQ(enough.strategy, "newton_amg");
  EXPECT_LT((x - energy.minimiser()).lpNorm<Eigen::Infinity>(), 1e-10);
}

}  // namespace
}  // namespace cirque
