#include "cirque/angles/angle_fit_problem.h"

#include <gtest/gtest.h>

#include "cirque/angles/registry.h"

#include "tests/common/surfaces.h"

namespace cirque {
namespace {

/// A solved fit, active inequalities included, and its report with something changed.
class KktReportTest : public ::testing::Test {
 protected:
  KktReportTest() {
    const Status status = FitAngles(problem_, objective_, **MakeAngleSolver("newton"), {}, &fit_);
    EXPECT_TRUE(status.ok()) << status.message();
  }

  KktReport Report(const Eigen::VectorXd& alpha, const Eigen::VectorXd& y) const {
    return CheckKkt(problem_, *objective_, alpha, y);
  }
  const Eigen::VectorXd& alpha() const { return fit_.angles.value; }
  const Eigen::VectorXd& y() const { return fit_.multipliers; }

  const Surface surface_ = GeneratedSurface("bumpy_terrain", 300);
  const Triangulation& t_ = surface_.triangulation;
  const AngleConstraints constraints_{t_, FreeBoundaryTargets(t_)};
  const CornerAngles reference_ = AnglesOf(surface_);
  const AngleFitProblem problem_{constraints_, reference_.value, 0.2};
  const std::shared_ptr<const AngleObjective> objective_ = *AngleObjectives().Find("quadratic");
  AngleFitResult fit_;
};

TEST_F(KktReportTest, TheSolutionHasNothingToReport) {
  const KktReport kkt = Report(alpha(), y());
  EXPECT_NEAR(std::min(kkt.smallest_angle, kkt.smallest_theta), 0.2, 1e-9);  // some are active
  EXPECT_LT(kkt.stationarity, 1e-9);
  EXPECT_LT(kkt.dual_infeasibility, 1e-9);
  EXPECT_LT(kkt.complementarity, 1e-9);
  EXPECT_LT(kkt.inequality_violation, 1e-9);
  EXPECT_LT(kkt.RelativeGap(), 1e-9);
}

TEST_F(KktReportTest, AMovedAngleIsSeen) {
  Eigen::VectorXd moved = alpha();
  moved[4] += 1e-3;
  const KktReport kkt = Report(moved, y());
  EXPECT_NEAR(kkt.triangle_sum_residual, 1e-3, 1e-9);
  EXPECT_NEAR(kkt.stationarity, 1e-3, 1e-9);
}

TEST_F(KktReportTest, FeasibleAnglesThatAreNotOptimalHaveAGap) {
  AngleFitResult other;
  const Status status = FitAngles(problem_, *AngleObjectives().Find("entropy"),
                                  **MakeAngleSolver("newton"), {}, &other);
  ASSERT_TRUE(status.ok()) << status.message();
  const KktReport kkt = Report(other.angles.value, y());
  EXPECT_LT(kkt.vertex_sum_residual, 1e-9);
  EXPECT_LT(kkt.inequality_violation, 1e-9);
  EXPECT_GT(kkt.stationarity, 1e-3);
  EXPECT_GT(kkt.primal - kkt.dual, 1e-6);
  EXPECT_GT(kkt.primal, fit_.kkt.primal);
}

TEST_F(KktReportTest, AWrongMultiplierIsSeen) {
  for (const int row : {0, t_.num_faces() + 2}) {
    Eigen::VectorXd wrong = y();
    wrong[row] += 1e-2;
    const KktReport kkt = Report(alpha(), wrong);
    EXPECT_GT(kkt.stationarity, 1e-3) << row;
    EXPECT_GT(std::max(kkt.dual_infeasibility, kkt.complementarity), 1e-4) << row;
    EXPECT_GT(kkt.primal - kkt.dual, 1e-8) << row;  // any multipliers give a lower bound
  }
}

TEST_F(KktReportTest, TheWrongSignOfAllMultipliersIsSeen) {
  const KktReport kkt = Report(alpha(), -y());
  EXPECT_GT(kkt.stationarity, 1e-2);
  EXPECT_GT(kkt.RelativeGap(), 1e-2);
}

TEST_F(KktReportTest, AViolatedInequalityIsSeen) {
  Eigen::VectorXd low = alpha();
  low[0] = 0.15;
  EXPECT_NEAR(Report(low, y()).inequality_violation, 0.05, 1e-12);
}

TEST_F(KktReportTest, WhatIsUndefinedDoesNotLookFine) {
  Eigen::VectorXd broken = alpha();
  broken[1] = std::numeric_limits<double>::quiet_NaN();
  const KktReport kkt = Report(broken, y());
  EXPECT_FALSE(kkt.triangle_sum_residual < 1);
  EXPECT_FALSE(kkt.complementarity < 1);
}

}  // namespace
}  // namespace cirque
