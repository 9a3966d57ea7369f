#include "cirque/energy/dual_angle_energy.h"

#include <algorithm>
#include <random>

#include <gtest/gtest.h>

#include "tests/common/surfaces.h"

namespace cirque {
namespace {

constexpr double kEps = 0.05;

class DualAngleEnergyTest : public ::testing::Test {
 protected:
  DualAngleEnergyTest() {
    std::mt19937 random(3);
    y_.resize(constraints_.num_rows());
    for (double& y : y_) y = std::ldexp(static_cast<double>(random()), -31) - 1;
  }

  const Surface surface_ = GeneratedSurface("bumpy_terrain", 120);
  const ConeTargets targets_ = FreeBoundaryTargets(surface_.triangulation);
  const AngleConstraints constraints_{surface_.triangulation, targets_};
  const CornerAngles reference_ = AnglesOf(surface_);
  const DualAngleEnergy energy_{constraints_, reference_.value, kEps,
                                *AngleObjectives().Find("quadratic")};
  Eigen::VectorXd y_;
};

TEST_F(DualAngleEnergyTest, GradientIsTheConstraintResidualOfItsAngles) {
  Eigen::VectorXd gradient(y_.size());
  double value;
  ASSERT_TRUE(energy_.Evaluate(y_.data(), &value, gradient.data()));
  Eigen::VectorXd residual = constraints_.Apply(energy_.Angles(y_.data()));
  for (int row = 0; row < residual.size(); ++row) residual[row] -= constraints_.Lower(row);
  EXPECT_LT((gradient - residual).lpNorm<Eigen::Infinity>(), 1e-12);
  EXPECT_GT(gradient.lpNorm<Eigen::Infinity>(), 0.1);
}

TEST_F(DualAngleEnergyTest, HessianPredictsTheGradientWhereNoEdgeChangesSide) {
  SparseMatrix lower;
  ASSERT_TRUE(energy_.Hessian(y_.data(), &lower));
  const Eigen::VectorXd p = Eigen::VectorXd::Random(y_.size()) * 1e-9;
  Eigen::VectorXd here(y_.size()), there(y_.size());
  const Eigen::VectorXd moved = y_ + p;
  energy_.Gradient(y_.data(), here.data());
  energy_.Gradient(moved.data(), there.data());
  const Eigen::VectorXd predicted = lower.selfadjointView<Eigen::Lower>() * p;
  EXPECT_LT((there - here - predicted).lpNorm<Eigen::Infinity>(), 1e-14);
  EXPECT_GT(predicted.lpNorm<Eigen::Infinity>(), 1e-10);
}

TEST_F(DualAngleEnergyTest, SmoothHessianIsTheHessianWhereNothingIsActiveAndAboveItElsewhere) {
  const auto difference = [](const DualAngleEnergy& energy, const Eigen::VectorXd& y,
                             const Eigen::VectorXd& p) {
    SparseMatrix lower, smooth;
    EXPECT_TRUE(energy.Hessian(y.data(), &lower));
    EXPECT_TRUE(energy.SmoothHessian(y.data(), &smooth));
    return p.dot(smooth.selfadjointView<Eigen::Lower>() * p) -
           p.dot(lower.selfadjointView<Eigen::Lower>() * p);
  };
  double largest = 0;
  for (int i = 0; i < 20; ++i) {
    const double above = difference(energy_, y_, Eigen::VectorXd::Random(y_.size()));
    EXPECT_GE(above, -1e-12);
    largest = std::max(largest, above);
  }
  EXPECT_GT(largest, 1);
  const Surface fan = Fan(6, 0.4);
  const ConeTargets targets = FreeBoundaryTargets(fan.triangulation);
  const AngleConstraints constraints(fan.triangulation, targets);
  const CornerAngles reference = AnglesOf(fan);
  const DualAngleEnergy inactive(constraints, reference.value, kEps,
                                 *AngleObjectives().Find("weighted_quadratic"));
  const Eigen::VectorXd zero = Eigen::VectorXd::Zero(constraints.num_rows());
  EXPECT_NEAR(difference(inactive, zero, Eigen::VectorXd::Random(zero.size())), 0, 1e-12);
}

TEST_F(DualAngleEnergyTest, WeakDualityHoldsAtAnyMultipliers) {
  // Any feasible primal point bounds -f from above; the flat equilateral angles of a hexagonal fan
  // are one.
  const Surface fan = Fan(6, 0.4);
  const ConeTargets targets = FreeBoundaryTargets(fan.triangulation);
  const AngleConstraints constraints(fan.triangulation, targets);
  const CornerAngles reference = AnglesOf(fan);
  const DualAngleEnergy energy(constraints, reference.value, kEps,
                               *AngleObjectives().Find("quadratic"));
  const Eigen::VectorXd feasible = Eigen::VectorXd::Constant(18, kPi / 3);
  for (int i = 0; i < 50; ++i) {
    const Eigen::VectorXd y = Eigen::VectorXd::Random(constraints.num_rows()) * 2;
    double value;
    energy.Evaluate(y.data(), &value, nullptr);
    EXPECT_LE(-value, energy.Primal(feasible) + 1e-13);
  }
}

}  // namespace
}  // namespace cirque
