// Energies in parts: whatever the ranks say of their parameters is what the whole says.
#include "cirque/solver/energy_part.h"

#include <gtest/gtest.h>

#include "cirque/energy/circle_pattern_energy.h"
#include "cirque/energy/circle_pattern_source.h"
#include "cirque/energy/dual_angle_energy.h"

#include "tests/common/surfaces.h"
#include "tests/linear/thread_ranks.h"

namespace cirque {
namespace {

/// A surface, an energy on it and its source.
class EnergyPartTest : public ::testing::TestWithParam<std::tuple<std::string, std::string, int>> {
 protected:
  EnergyPartTest()
      : surface_(GeneratedSurface(std::get<1>(GetParam()), 400)),
        reference_(AnglesOf(surface_)),
        angles_{Eigen::VectorXd::Constant(t().num_halfedges(), kPi / 3)},
        pattern_source_(t(), angles_) {
    if (work() == kDualAngleWork) {
      auto dual = std::make_unique<DualAngleEnergy>(AngleConstraints(t(), FreeBoundaryTargets(t())),
                                                    reference_.value, 0.05,
                                                    *AngleObjectives().Find("quadratic"));
      source_ = dual->source();
      whole_ = std::move(dual);
    } else {
      source_ = &pattern_source_;
      whole_ = std::make_unique<CirclePatternEnergy>(t(), angles_);
    }
    x_ = Eigen::VectorXd::Random(whole_->NumParameters());
  }

  const Triangulation& t() const { return surface_.triangulation; }
  std::string work() const { return std::get<0>(GetParam()); }
  int num_ranks() const { return std::get<2>(GetParam()); }

  /// body(part) on all ranks, which have taken their parts.
  void OnRanks(const std::function<void(EnergyPart* part, Ranks& ranks)>& body) const {
    RunOnThreadRanks(num_ranks(), [&](Ranks& ranks) {
      EnergyPart part(&ranks, EnergyPartMakers().at(work()));
      if (ranks.rank() == 0) part.call.source = source_;
      part.Do(EnergyPart::kTake);
      body(&part, ranks);
    });
  }

  const Surface surface_;
  const CornerAngles reference_;
  const CoherentAngles angles_;
  const CirclePatternSource pattern_source_;
  const EnergySource* source_ = nullptr;
  std::unique_ptr<Energy> whole_;
  Eigen::VectorXd x_;
};

TEST_P(EnergyPartTest, GradientIsTheWholesToTheLastBit) {
  Eigen::VectorXd wanted(x_.size()), got = Eigen::VectorXd::Zero(x_.size());
  ASSERT_TRUE(whole_->Gradient(x_.data(), wanted.data()));
  OnRanks([&](EnergyPart* part, Ranks&) {
    part->call.x = x_.data();
    part->call.result = got.data();
    part->Do(EnergyPart::kGradient);
    EXPECT_TRUE(part->call.done);
  });
  EXPECT_EQ(wanted, got);
  EXPECT_GT(wanted.lpNorm<Eigen::Infinity>(), 0.1);
}

TEST_P(EnergyPartTest, SharesAddUpToTheValue) {
  double wanted = 0;
  ASSERT_TRUE(whole_->Evaluate(x_.data(), &wanted, nullptr));
  OnRanks([&](EnergyPart* part, Ranks&) {
    part->call.x = x_.data();
    part->Do(EnergyPart::kShare);
    EXPECT_TRUE(part->call.done);
    EXPECT_NEAR(part->call.number, wanted, 1e-12 * std::abs(wanted));
  });
}

TEST_P(EnergyPartTest, SolvesAsTheWholeHessianDoes) {
  SparseMatrix lower;
  ASSERT_TRUE(whole_->Hessian(x_.data(), &lower));
  const Eigen::VectorXd b = Eigen::VectorXd::Random(x_.size());
  constexpr double kDamping = 1e-3;
  Eigen::VectorXd x = Eigen::VectorXd::Zero(x_.size());
  double mean = 0;
  OnRanks([&](EnergyPart* part, Ranks& ranks) {
    part->call.x = x_.data();
    part->Do(EnergyPart::kLinearize);
    EXPECT_TRUE(part->call.done);
    if (ranks.rank() == 0) mean = part->call.number;
    part->call.x = b.data();
    part->call.result = x.data();
    part->call.damping = ranks.rank() == 0 ? kDamping : -1;  // the first rank's counts
    part->call.tolerance = ranks.rank() == 0 ? 1e-10 : 1;
    part->Do(EnergyPart::kSolve);
    EXPECT_TRUE(part->call.done);
  });
  EXPECT_NEAR(mean, Diagonal(lower).mean(), 1e-12);
  for (int j = 0; j < lower.cols(); ++j) DiagonalEntry(&lower, j) += kDamping;
  for (const int g : whole_->GaugeParameters()) DiagonalEntry(&lower, g) *= 2;
  const Eigen::VectorXd image = lower.selfadjointView<Eigen::Lower>() * x;
  EXPECT_LT((image - b).lpNorm<Eigen::Infinity>(), 1e-9);
}

TEST_P(EnergyPartTest, OneSmoothMatrixServesThoseNearIt) {
  SparseMatrix lower;
  Eigen::VectorXd zero = Eigen::VectorXd::Zero(x_.size()), x = zero;
  if (!whole_->SmoothHessian(zero.data(), &lower)) {
    OnRanks([&](EnergyPart* part, Ranks&) {
      part->call.x = zero.data();
      part->Do(EnergyPart::kLinearizeSmooth);
      EXPECT_FALSE(part->call.done);
    });
    return;
  }
  ASSERT_TRUE(whole_->Hessian(zero.data(), &lower));
  const Eigen::VectorXd b = Eigen::VectorXd::Random(x_.size());
  constexpr double kDamping = 1e-9;
  SolveSummary summary;
  OnRanks([&](EnergyPart* part, Ranks& ranks) {
    part->call.x = zero.data();
    part->Do(EnergyPart::kLinearizeSmooth);
    part->call.damping = kDamping;
    part->Do(EnergyPart::kPrepare);
    EXPECT_TRUE(part->call.done);
    part->Do(EnergyPart::kLinearize);
    part->call.x = b.data();
    part->call.result = x.data();
    part->call.tolerance = 1e-8;
    if (ranks.rank() == 0) part->call.summary = &summary;
    part->Do(EnergyPart::kSolve);
    EXPECT_TRUE(part->call.done);
  });
  for (int j = 0; j < lower.cols(); ++j) DiagonalEntry(&lower, j) += kDamping;
  for (const int g : whole_->GaugeParameters()) DiagonalEntry(&lower, g) *= 2;
  const Eigen::VectorXd image = lower.selfadjointView<Eigen::Lower>() * x;
  EXPECT_LT((image - b).norm(), 1.1e-8 * b.norm());
  EXPECT_LT(summary.cg_iterations, 20);
}

INSTANTIATE_TEST_SUITE_P(Works, EnergyPartTest,
                         ::testing::Combine(::testing::Values(kCirclePatternWork, kDualAngleWork),
                                            ::testing::Values("bumpy_terrain", "torus"),
                                            ::testing::Values(1, 2, 4)));

}  // namespace
}  // namespace cirque
