#include <cmath>

#include <gtest/gtest.h>

#include "cirque/core/types.h"
#include "cirque/energy/angle_objective.h"

namespace cirque {
namespace {

constexpr double kEps = 0.05;
constexpr double kReferences[][2] = {{0.7, 1.9}, {1.2, 0.3}, {0.06, 2.9}, {1.7, 1.7}};
constexpr double kSlopes[][2] = {{0, 0}, {-3, 0.1}, {0.4, -0.6}, {2, 1.5}, {5, -9}, {0.3, 4}};

class EveryAngleObjective : public ::testing::TestWithParam<std::string> {
 protected:
  const std::shared_ptr<const AngleObjective> objective_ = *AngleObjectives().Find(GetParam());

  EdgeConjugate At(const double* ref, double s_l, double s_r) const {
    return objective_->InteriorConjugate(ref[0], ref[1], kEps, s_l, s_r);
  }
};

TEST_P(EveryAngleObjective, DistanceIsConvexWithItsMinimumZeroAtTheReference) {
  const double ref = 0.8;
  EXPECT_NEAR(objective_->Distance(ref, ref).value, 0, 1e-15);
  EXPECT_NEAR(objective_->Distance(ref, ref).slope, 0, 1e-15);
  const double h = 1e-5;
  for (const double x : {0.1, 0.5, 0.8, 1.3, 2.9}) {
    const ScalarJet at = objective_->Distance(ref, x);
    const ScalarJet plus = objective_->Distance(ref, x + h),
                    minus = objective_->Distance(ref, x - h);
    EXPECT_NEAR((plus.value - minus.value) / (2 * h), at.slope, 1e-7);
    EXPECT_NEAR((plus.slope - minus.slope) / (2 * h), at.curvature, 1e-5);
    EXPECT_GT(at.curvature, 0);
    const ResidualJet r = objective_->Residual(ref, x);
    EXPECT_NEAR(0.5 * r.value * r.value, at.value, 1e-14);
    EXPECT_NEAR(r.value * r.slope, at.slope, 1e-13);
  }
}

TEST_P(EveryAngleObjective, ConjugateMaximiserBeatsEveryOtherPoint) {
  for (const auto& ref : kReferences) {
    for (const auto& s : kSlopes) {
      const EdgeConjugate g = At(ref, s[0], s[1]);
      const EdgeMargins margins = objective_->Margins(ref[0], ref[1], kEps);
      if (margins.theta >= 0) {
        EXPECT_GE(g.alpha_l, margins.l - 1e-15);
        EXPECT_GE(g.alpha_r, margins.r - 1e-15);
        EXPECT_LE(g.alpha_l + g.alpha_r, kPi - margins.theta + 1e-15);
      }
      for (double a = kEps; a < kPi; a += 0.09) {
        for (double b = kEps; a + b <= kPi - kEps; b += 0.09) {
          const double other =
              s[0] * a + s[1] * b - objective_->Interior(ref[0], ref[1], kEps, a, b);
          EXPECT_GE(g.value + 1e-13 * (1 + std::abs(g.value)), other);
        }
      }
    }
  }
}

TEST_P(EveryAngleObjective, ConjugateDerivativesAreItsMaximiserAndThatsDerivative) {
  const double h = 1e-6;
  for (const auto& ref : kReferences) {
    for (const auto& s : kSlopes) {
      const EdgeConjugate g = At(ref, s[0], s[1]);
      const EdgeConjugate l_plus = At(ref, s[0] + h, s[1]), l_minus = At(ref, s[0] - h, s[1]);
      const EdgeConjugate r_plus = At(ref, s[0], s[1] + h), r_minus = At(ref, s[0], s[1] - h);
      const double scale = 1 + g.h_ll + g.h_rr;
      EXPECT_NEAR((l_plus.value - l_minus.value) / (2 * h), g.alpha_l, 1e-8 * scale);
      EXPECT_NEAR((r_plus.value - r_minus.value) / (2 * h), g.alpha_r, 1e-8 * scale);
      EXPECT_NEAR((l_plus.alpha_l - l_minus.alpha_l) / (2 * h), g.h_ll, 1e-5 * scale);
      EXPECT_NEAR((l_plus.alpha_r - l_minus.alpha_r) / (2 * h), g.h_lr, 1e-5 * scale);
      EXPECT_NEAR((r_plus.alpha_r - r_minus.alpha_r) / (2 * h), g.h_rr, 1e-5 * scale);
      EXPECT_GE(g.h_ll * g.h_rr, g.h_lr * g.h_lr * (1 - 1e-12));
    }
  }
}

TEST_P(EveryAngleObjective, MarginsAreEpsilonButWhereTheReferenceIsLess) {
  const double largest = objective_->Margin(kEps);
  if (largest <= 0) {
    const EdgeMargins none = objective_->Margins(1e-3, 3, kEps);
    for (const double margin : {none.l, none.r, none.theta}) EXPECT_EQ(margin, largest);
    return;
  }
  const EdgeMargins wide = objective_->Margins(0.7, 1.9, kEps);
  for (const double margin : {wide.l, wide.r, wide.theta}) EXPECT_EQ(margin, kEps);
  const EdgeMargins narrow = objective_->Margins(0.06, kPi - 0.07, kEps);
  EXPECT_DOUBLE_EQ(narrow.l, 0.03);
  EXPECT_EQ(narrow.r, kEps);
  EXPECT_EQ(narrow.theta, kEps);
  EXPECT_EQ(objective_->Margins(0, 1, kEps).l, kLeastCornerMargin);
  EXPECT_DOUBLE_EQ(objective_->Margins(0.02, kEps).l, 0.01);
  EXPECT_EQ(objective_->Margins(kPi - 0.02, kEps).theta, kEps);
}

TEST_P(EveryAngleObjective, BoundaryConjugateIsConsistent) {
  const double h = 1e-6;
  for (const double ref : {0.06, 0.9, 3.0}) {
    for (const double s : {-4.0, -0.3, 0.0, 0.7, 6.0}) {
      const EdgeConjugate g = objective_->BoundaryConjugate(ref, kEps, s);
      const EdgeConjugate plus = objective_->BoundaryConjugate(ref, kEps, s + h);
      const EdgeConjugate minus = objective_->BoundaryConjugate(ref, kEps, s - h);
      EXPECT_NEAR((plus.value - minus.value) / (2 * h), g.alpha_l, 1e-8 * (1 + g.h_ll));
      EXPECT_NEAR((plus.alpha_l - minus.alpha_l) / (2 * h), g.h_ll, 1e-5 * (1 + g.h_ll));
      EXPECT_NEAR(g.value, s * g.alpha_l - objective_->Boundary(ref, kEps, g.alpha_l), 1e-13);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Registry, EveryAngleObjective,
                         ::testing::ValuesIn(AngleObjectives().Names()));

}  // namespace
}  // namespace cirque
