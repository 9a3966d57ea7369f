// The residual blocks of the augmented Lagrangian: their squares are its formula, their Jacobians its
// differences.
#include <algorithm>
#include <cmath>
#include <cstdlib>

#include <ceres/problem.h>
#include <gtest/gtest.h>

#include "cirque/angles/augmented_lagrangian_angle_solver.h"

#include "tests/common/surfaces.h"

namespace cirque {
namespace {

TEST(SignedDistance, IsZeroInsideAndSignedOutside) {
  EXPECT_EQ(SignedDistance(1.5, 1, 2), 0);
  EXPECT_EQ(SignedDistance(0.5, 1, 2), -0.5);
  EXPECT_EQ(SignedDistance(2.25, 1, 2), 0.25);
  EXPECT_EQ(SignedDistance(3, 3, 3), 0);
}

class AugmentedResiduals : public testing::TestWithParam<std::string> {
 protected:
  AugmentedResiduals() {
    std::srand(2);
    state_.penalty = 30;
    state_.y = Eigen::VectorXd::Random(constraints_.num_rows());
    state_.of_lower = Eigen::VectorXd::Random(t_.num_halfedges()).cwiseAbs();
    state_.of_sums = Eigen::VectorXd::Random(t_.num_edges()).cwiseAbs();
    alpha_ = (reference_.value.array() + 0.05 * Eigen::ArrayXd::Random(t_.num_halfedges()))
                 .cwiseMax(0.1)
                 .cwiseMin(1.4);
    AddAngleResiduals({constraints_, reference_.value, kMargin}, *objective_, state_, alpha_.data(),
                      &problem_);
  }

  static ConeTargets Ranged(const Triangulation& t) {
    ConeTargets targets = FreeBoundaryTargets(t);
    targets.lower[0] = 5.5;
    targets.upper[0] = 7;
    return targets;
  }

  double Cost(std::vector<double>* gradient = nullptr) {
    double cost = 0;
    EXPECT_TRUE(problem_.Evaluate({}, &cost, nullptr, gradient, nullptr));
    return cost;
  }

  /// The formula of AddAngleResiduals' docstring.
  double Formula() const {
    double value = 0;
    for (const Index l : t_.edge_halfedge) {
      const Index r = t_.twin[l];
      value += r == kNone ? objective_->Boundary(reference_.value[l], kMargin, alpha_[l])
                          : objective_->Interior(reference_.value[l], reference_.value[r], kMargin,
                                                 alpha_[l], alpha_[r]);
    }
    const double rho = state_.penalty;
    const auto penalty = [rho](double x) { return 0.5 * rho * x * x; };
    const Eigen::VectorXd sums = constraints_.Apply(alpha_);
    for (int row = 0; row < constraints_.num_rows(); ++row) {
      value += penalty(SignedDistance(sums[row] - state_.y[row] / rho, constraints_.Lower(row),
                                      constraints_.Upper(row)));
    }
    if (!(objective_->Margin(kMargin) > 0)) return value;
    for (Index e = 0; e < t_.num_edges(); ++e) {
      const Index l = t_.edge_halfedge[e], r = t_.twin[l];
      const EdgeMargins m = MarginsOf({constraints_, reference_.value, kMargin}, *objective_, l);
      value += penalty(std::max(0.0, m.l - alpha_[l] + state_.of_lower[l] / rho));
      if (r != kNone) value += penalty(std::max(0.0, m.r - alpha_[r] + state_.of_lower[r] / rho));
      const double sum = alpha_[l] + (r == kNone ? 0 : alpha_[r]);
      value += penalty(std::max(0.0, sum - (kPi - m.theta) + state_.of_sums[e] / rho));
    }
    return value;
  }

  static constexpr double kMargin = 0.3;  ///< wide, so that many inequalities count
  const Surface surface_ = Fan(6, 0.5);
  const Triangulation& t_ = surface_.triangulation;
  const AngleConstraints constraints_{t_, Ranged(t_)};
  const CornerAngles reference_ = AnglesOf(surface_);
  const std::shared_ptr<const AngleObjective> objective_ = *AngleObjectives().Find(GetParam());
  AugmentedState state_;
  Eigen::VectorXd alpha_;
  ceres::Problem problem_;
};

TEST_P(AugmentedResiduals, SquaresAddUpToTheFormula) {
  const double expected = Formula();
  EXPECT_GT(expected, 0.01);
  EXPECT_NEAR(Cost(), expected, 1e-10 * expected);
  // The outer loop changes the state in between.
  state_.penalty *= 7;
  state_.y *= -1;
  state_.of_lower *= 3;
  EXPECT_NE(Formula(), expected);
  EXPECT_NEAR(Cost(), Formula(), 1e-10 * Formula());
}

TEST_P(AugmentedResiduals, JacobiansAreDifferences) {
  std::vector<double> gradient;
  Cost(&gradient);
  ASSERT_EQ(gradient.size(), static_cast<std::size_t>(alpha_.size()));
  constexpr double kStep = 1e-6;
  double largest = 0;
  for (int i = 0; i < alpha_.size(); ++i) {
    const double x = alpha_[i];
    alpha_[i] = x + kStep;
    const double above = Formula();
    alpha_[i] = x - kStep;
    const double below = Formula();
    alpha_[i] = x;
    EXPECT_NEAR(gradient[i], (above - below) / (2 * kStep), 1e-6 * (1 + std::abs(gradient[i])));
    largest = std::max(largest, std::abs(gradient[i]));
  }
  EXPECT_GT(largest, 0.1);
}

INSTANTIATE_TEST_SUITE_P(Registry, AugmentedResiduals, testing::ValuesIn(AngleObjectives().Names()),
                         [](const auto& of_case) { return of_case.param; });

}  // namespace
}  // namespace cirque
