// Energies in parts: whatever the ranks say of their parameters is what the whole says.
#include "cirque/solver/energy_part.h"

#include <atomic>
#include <cmath>

#include <gtest/gtest.h>

#include "cirque/energy/circle_pattern_energy.h"
#include "cirque/energy/circle_pattern_source.h"
#include "cirque/energy/dual_angle_energy.h"
#include "cirque/solver/newton_on_ranks.h"
#include "cirque/solver/newton_strategies.h"

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
  void OnRanks(const std::function<void(NewtonPart* part, Ranks& ranks)>& body) const {
    RunOnThreadRanks(num_ranks(), [&](Ranks& ranks) {
      NewtonPart part(&ranks, EnergyPartMakers().at(work()));
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
  OnRanks([&](NewtonPart* part, Ranks&) {
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
  OnRanks([&](NewtonPart* part, Ranks&) {
    part->call.x = x_.data();
    part->Do(EnergyPart::kShare);
    EXPECT_TRUE(part->call.done);
    EXPECT_NEAR(part->call.number, wanted, 1e-12 * std::abs(wanted));
  });
}

/// The Hessian at x damped as Newton's systems are.
SparseMatrix DampedHessian(const Energy& energy, const Eigen::VectorXd& x, double damping) {
  SparseMatrix lower;
  EXPECT_TRUE(energy.Hessian(x.data(), &lower));
  for (int j = 0; j < lower.cols(); ++j) DiagonalEntry(&lower, j) += damping;
  for (const int g : energy.GaugeParameters()) DiagonalEntry(&lower, g) *= 2;
  return lower;
}

TEST_P(EnergyPartTest, SolvesAsTheWholeHessianDoes) {
  SparseMatrix hessian;
  ASSERT_TRUE(whole_->Hessian(x_.data(), &hessian));
  const double mean_of_whole = Diagonal(hessian).mean();
  const Eigen::VectorXd b = Eigen::VectorXd::Random(x_.size());
  constexpr double kDamping = 1e-3;
  Eigen::VectorXd x = Eigen::VectorXd::Zero(x_.size());
  OnRanks([&](NewtonPart* part, Ranks&) {
    SolveSummary summary;
    double mean = 0;
    ASSERT_TRUE(part->Linearize(part->Scatter(x_.data()), &mean));
    EXPECT_NEAR(mean, mean_of_whole, 1e-12);
    Eigen::VectorXd own;
    ASSERT_TRUE(part->Solve(kDamping, part->Scatter(b.data()), 1e-10, &own, &summary));
    part->Gather(own, x.data());
  });
  const SparseMatrix lower = DampedHessian(*whole_, x_, kDamping);
  const Eigen::VectorXd image = lower.selfadjointView<Eigen::Lower>() * x;
  EXPECT_LT((image - b).lpNorm<Eigen::Infinity>(), 1e-9);
}

TEST_P(EnergyPartTest, OneSmoothMatrixServesThoseNearIt) {
  SparseMatrix lower;
  Eigen::VectorXd zero = Eigen::VectorXd::Zero(x_.size()), x = zero;
  const bool has_smooth = whole_->SmoothHessian(zero.data(), &lower);
  const Eigen::VectorXd b = Eigen::VectorXd::Random(x_.size());
  constexpr double kDamping = 1e-9;
  OnRanks([&](NewtonPart* part, Ranks&) {
    SolveSummary summary;
    double mean = 0;
    const Eigen::VectorXd start = part->Scatter(zero.data());
    ASSERT_EQ(part->LinearizeSmooth(start, &mean), has_smooth);
    if (!has_smooth) return;
    EXPECT_TRUE(part->PrepareForSystemsNear(kDamping, &summary));
    EXPECT_TRUE(part->Linearize(start, &mean));
    Eigen::VectorXd own;
    EXPECT_TRUE(part->Solve(kDamping, part->Scatter(b.data()), 1e-8, &own, &summary));
    EXPECT_LT(summary.cg_iterations, 20);
    part->Gather(own, x.data());
  });
  if (!has_smooth) return;
  const Eigen::VectorXd image =
      DampedHessian(*whole_, zero, kDamping).selfadjointView<Eigen::Lower>() * x;
  EXPECT_LT((image - b).norm(), 1.1e-8 * b.norm());
}

TEST_P(EnergyPartTest, RelaxingLowersTheValueAndKnowsItsGradient) {
  // Near the minimum few entries of the gradient stand out once one parameter is moved.
  Eigen::VectorXd x = Eigen::VectorXd::Zero(x_.size()), after = x;
  NewtonStrategy(NewtonOptions()).Minimize(*whole_, {}, &x);
  x[x.size() / 2] += 0.1;
  Eigen::VectorXd gradient(x.size()), told = gradient;
  double before = 0, now = 0;
  ASSERT_TRUE(whole_->Evaluate(x.data(), &before, gradient.data()));
  const double threshold = 0.1 * gradient.lpNorm<Eigen::Infinity>();
  Eigen::VectorXd by_whole = x, gradient_by_whole = gradient;
  const bool relaxes = whole_->Relax(threshold, by_whole.data(), gradient_by_whole.data());
  EXPECT_EQ(relaxes, work() == kDualAngleWork);
  OnRanks([&](NewtonPart* part, Ranks&) {
    Eigen::VectorXd own = part->Scatter(x.data()), slopes = part->Scatter(gradient.data());
    ASSERT_EQ(part->Relax(threshold, &own, &slopes), relaxes);
    part->Gather(own, after.data());
    part->Gather(slopes, told.data());
  });
  ASSERT_TRUE(whole_->Evaluate(after.data(), &now, gradient.data()));
  EXPECT_EQ(gradient, told);
  if (relaxes) {
    EXPECT_LT(now, before);
  } else {
    EXPECT_EQ(after, x);
  }
}

TEST_P(EnergyPartTest, AllFindTheMinimumTogether) {
  // Far off, Newton's matrix of a dual needs more damping than multigrid is asked for.
  if (work() == kDualAngleWork) x_.setZero();
  Eigen::VectorXd wanted = x_, got = x_;
  const SolveSummary whole = NewtonStrategy(NewtonOptions()).Minimize(*whole_, {}, &wanted);
  std::vector<Eigen::VectorXd> seen;
  SolveSummary summary;
  const SolveControl control = {.callback = [&](const IterationRecord&, const Eigen::VectorXd& x) {
    seen.push_back(x);
    return CallbackAction::kContinue;
  }};
  OnRanks([&](NewtonPart* part, Ranks& ranks) {
    if (ranks.rank() == 0) {
      part->call.control = &control;
      part->call.x = part->call.result = got.data();
      part->call.summary = &summary;
    }
    part->Do(NewtonPart::kMinimize);
    EXPECT_TRUE(part->call.done);
  });
  EXPECT_TRUE(summary.Converged()) << summary.BriefReport();
  EXPECT_NEAR(summary.final_value, whole.final_value, 1e-11 * std::abs(whole.final_value));
  EXPECT_NEAR(summary.initial_value, whole.initial_value, 1e-11 * std::abs(whole.initial_value));
  Eigen::VectorXd gradient(x_.size());
  ASSERT_TRUE(whole_->Gradient(got.data(), gradient.data()));
  EXPECT_LT(gradient.lpNorm<Eigen::Infinity>(), 1.01e-11);
  ASSERT_EQ(static_cast<int>(seen.size()), summary.num_iterations());
  EXPECT_GT(summary.num_iterations(), 1);
  EXPECT_EQ(seen.back(), got);
}

/// What the first rank's caller asks holds on all: none goes on, or waits.
TEST_P(EnergyPartTest, AllEndWhenTheFirstIsAskedTo) {
  if (work() == kDualAngleWork) x_.setZero();
  const std::atomic<bool> cancelled = true;
  const SolveControl stops = {
      .callback = [](const auto&, const auto&) { return CallbackAction::kStop; }};
  const SolveControl is_cancelled = {.callback = {}, .cancelled = &cancelled};
  InexactNewtonOptions hasty;
  hasty.max_seconds = 0;
  struct Case {
    SolveControl control;
    InexactNewtonOptions options;
    Termination wanted;
  };
  for (const Case& asked : {Case{stops, {}, Termination::kStoppedByCaller},
                            Case{is_cancelled, {}, Termination::kCancelled},
                            Case{{}, hasty, Termination::kTimeLimit}}) {
    OnRanks([&](NewtonPart* part, Ranks& ranks) {
      const bool first = ranks.rank() == 0;
      Eigen::VectorXd x = part->Scatter(x_.data());
      bool failed = true;
      InexactNewtonOptions options = asked.options;
      if (!first) options.max_seconds = 1e9;
      const SolveSummary summary =
          MinimizeOnRanks(options, first ? asked.control : SolveControl(), part, &x, &failed);
      EXPECT_EQ(summary.termination, asked.wanted) << ranks.rank();
      EXPECT_FALSE(failed);
    });
  }
}

INSTANTIATE_TEST_SUITE_P(Works, EnergyPartTest,
                         ::testing::Combine(::testing::Values(kCirclePatternWork, kDualAngleWork),
                                            ::testing::Values("bumpy_terrain", "torus"),
                                            ::testing::Values(1, 2, 4)));

}  // namespace
}  // namespace cirque
