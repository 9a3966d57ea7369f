// Every strategy of the registry on every energy of the registry.
#include <atomic>
#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cirque/solver/ceres_strategies.h"

#include "experiments/common/solver_problem.h"
#include "tests/common/surfaces.h"
#include "tests/solver/strategy_fixtures.h"

namespace cirque {
namespace {

using testing::HasSubstr;

constexpr double kSameMinimiser = 1e-8;

const StudyProblem& Problem() {
  static const std::shared_ptr<const StudyProblem> kProblem =
      *MakeProblem("terrain", GeneratedSurface("bumpy_terrain", 150));
  return *kProblem;
}

bool Factors(const std::string& strategy) { return strategy != "ceres_line_search"; }

/// Whether the strategy needs residual blocks, which not every energy has.
bool NeedsResiduals(const std::string& strategy) { return strategy == "ceres_trust_region"; }

struct Solved {
  SolveSummary summary;
  Eigen::VectorXd x;
};

Solved Minimize(const Energy& energy, const SolverStrategy& strategy, Eigen::VectorXd start,
                const SolveControl& control = {}) {
  Solved solved;
  solved.x = std::move(start);
  solved.summary = strategy.Minimize(energy, control, &solved.x);
  return solved;
}

void ExpectFilled(const SolveSummary& s) {
  EXPECT_GT(s.num_iterations(), 0);
  EXPECT_GT(s.gradient_evaluations, 0);
  EXPECT_GT(s.value_evaluations, 0);
  EXPECT_TRUE(std::isfinite(s.initial_value) && std::isfinite(s.final_value));
  EXPECT_LT(s.final_gradient_max, s.initial_gradient_max);
  for (const double seconds : {s.evaluation_seconds, s.factorization_seconds, s.solve_seconds}) {
    EXPECT_GE(seconds, 0);
    EXPECT_LE(seconds, s.total_seconds);
  }
  EXPECT_GT(s.evaluation_seconds, 0);
  EXPECT_TRUE(s.x_changed);
  EXPECT_FALSE(s.message.empty());
  EXPECT_THAT(s.BriefReport(), HasSubstr(ToString(s.termination)));
}

class EveryStrategyOnEveryEnergy
    : public ::testing::TestWithParam<std::tuple<std::string, std::string>> {};

TEST_P(EveryStrategyOnEveryEnergy, FindsNewtonsMinimiser) {
  const auto& [name, energy_name] = GetParam();
  const std::unique_ptr<Energy> energy = (*Energies().Find(energy_name))(Problem().input);
  const Eigen::VectorXd start = StartOf(*energy, Problem().input);
  const Solved found = Minimize(*energy, *Strategy(name), start);
  if (found.summary.termination == Termination::kUnsupported) {
    EXPECT_TRUE(NeedsResiduals(name) && !OffersResiduals(*energy));
    EXPECT_EQ(found.x, start);
    EXPECT_THAT(found.summary.message, HasSubstr("no least-squares form"));
    return;
  }
  const Solved newton = Minimize(*energy, *Strategy("newton"), start);
  ASSERT_TRUE(newton.summary.Converged()) << newton.summary.BriefReport();
  ExpectFilled(found.summary);
  Eigen::VectorXd gradient(energy->NumParameters());
  energy->Gradient(found.x.data(), gradient.data());
  EXPECT_NEAR(found.summary.final_gradient_max, gradient.lpNorm<Eigen::Infinity>(), 1e-13);
  EXPECT_TRUE(found.summary.Converged()) << found.summary.FullReport();
  EXPECT_EQ(found.summary.factorizations > 0, Factors(name));
  EXPECT_NEAR(found.summary.final_value, newton.summary.final_value,
              1e-12 * (1 + std::abs(newton.summary.final_value)));
  const Eigen::VectorXd difference =
      ComparableSolution(*energy, found.x) - ComparableSolution(*energy, newton.x);
  EXPECT_LE(difference.lpNorm<Eigen::Infinity>(), kSameMinimiser) << found.summary.FullReport();
}

INSTANTIATE_TEST_SUITE_P(Registries, EveryStrategyOnEveryEnergy,
                         ::testing::Combine(::testing::ValuesIn(SolverStrategies().Names()),
                                            ::testing::ValuesIn(Energies().Names())),
                         [](const auto& instance) {
                           return std::get<0>(instance.param) + "_" + std::get<1>(instance.param);
                         });

/// On the circle-pattern energy, which every strategy minimises.
class EveryStrategy : public ::testing::TestWithParam<std::string> {
 protected:
  Solved Run(const OptionMap& options, const SolveControl& control = {}) const {
    return Minimize(*energy_, *Strategy(GetParam(), options), start_, control);
  }

  const std::unique_ptr<Energy> energy_ = (*Energies().Find("circle_pattern"))(Problem().input);
  const Eigen::VectorXd start_ = Eigen::VectorXd::Zero(energy_->NumParameters());
};

TEST_P(EveryStrategy, CallsBackOnceAnIterateWithThatIterate) {
  int calls = 0;
  const SolveControl control{[&](const IterationRecord& record, const Eigen::VectorXd& x) {
    EXPECT_EQ(record.iteration, ++calls);
    Eigen::VectorXd gradient(x.size());
    energy_->Gradient(x.data(), gradient.data());
    EXPECT_NEAR(record.gradient_max, gradient.lpNorm<Eigen::Infinity>(), 1e-13);
    return CallbackAction::kContinue;
  }};
  const Solved solved = Run({}, control);
  EXPECT_EQ(calls, solved.summary.num_iterations());
  EXPECT_GT(calls, 1);
}

TEST_P(EveryStrategy, StopsWhenTheCallbackSays) {
  Eigen::VectorXd last;
  const SolveControl control{[&](const IterationRecord& record, const Eigen::VectorXd& x) {
    last = x;
    return record.iteration == 2 ? CallbackAction::kStop : CallbackAction::kContinue;
  }};
  const Solved solved = Run({}, control);
  EXPECT_EQ(solved.summary.termination, Termination::kStoppedByCaller);
  EXPECT_EQ(solved.summary.num_iterations(), 2);
  EXPECT_EQ(solved.x, last);
  EXPECT_NE(solved.x, start_);
}

TEST_P(EveryStrategy, HonoursCancellation) {
  std::atomic<bool> cancelled = true;
  const Solved at_once = Run({}, {{}, &cancelled});
  EXPECT_EQ(at_once.summary.termination, Termination::kCancelled);
  EXPECT_EQ(at_once.x, start_);
  EXPECT_FALSE(at_once.summary.x_changed);
  cancelled = false;
  const IterationCallback cancel = [&](const IterationRecord&, const Eigen::VectorXd&) {
    cancelled = true;
    return CallbackAction::kContinue;
  };
  const Solved later = Run({}, {cancel, &cancelled});
  EXPECT_EQ(later.summary.termination, Termination::kCancelled);
  EXPECT_EQ(later.summary.num_iterations(), 1);
}

TEST_P(EveryStrategy, HonoursLimits) {
  const Solved no_steps = Run({{"max_iterations", "0"}});
  EXPECT_EQ(no_steps.summary.termination, Termination::kIterationLimit);
  EXPECT_EQ(no_steps.x, start_);
  const Solved two_steps = Run({{"max_iterations", "2"}});
  EXPECT_EQ(two_steps.summary.termination, Termination::kIterationLimit);
  EXPECT_EQ(two_steps.summary.num_iterations(), 2);
  const Solved no_time = Run({{"max_seconds", "0"}});
  EXPECT_EQ(no_time.summary.termination, Termination::kTimeLimit);
  const Solved loose = Run({{"gradient_tolerance", "0.1"}});
  EXPECT_EQ(loose.summary.termination, Termination::kConverged);
  EXPECT_LE(loose.summary.final_gradient_max, 0.1);
  EXPECT_GT(loose.summary.final_gradient_max, 1e-10);
}

TEST_P(EveryStrategy, ReportsAnInvalidStartAndLeavesItAlone) {
  Eigen::VectorXd start = start_;
  start[3] = std::numeric_limits<double>::quiet_NaN();
  const Solved solved = Minimize(*energy_, *Strategy(GetParam()), start);
  EXPECT_EQ(solved.summary.termination, Termination::kInvalidStart);
  EXPECT_FALSE(solved.summary.x_changed);
  EXPECT_TRUE(std::isnan(solved.x[3]));
  EXPECT_EQ(solved.x[2], 0);
}

TEST_P(EveryStrategy, ASolutionNeedsNoStep) {
  const Solved newton = Minimize(*energy_, *Strategy("newton"), start_);
  const Solved again = Minimize(*energy_, *Strategy(GetParam()), newton.x);
  EXPECT_TRUE(again.summary.Converged());
  EXPECT_EQ(again.summary.num_iterations(), 0);
  EXPECT_FALSE(again.summary.x_changed);
}

TEST_P(EveryStrategy, RefusesOptionsByNameValueAndBound) {
  const auto message = [](const OptionMap& options) {
    return MakeSolverStrategy(GetParam(), options).status().message();
  };
  const std::string& name = GetParam();
  EXPECT_EQ(message({{"max_iterations", "-1"}}),
            name + ": max_iterations = '-1' is not an integer in [0, 2.14748e+09]");
  EXPECT_EQ(message({{"gradient_tolerance", "2"}}),
            name + ": gradient_tolerance = '2' is not a number in [0, 1]");
  EXPECT_EQ(message({{"max_seconds", "soon"}}),
            name + ": max_seconds = 'soon' is not a number in [0, 1e+09] s");
  EXPECT_THAT(message({{"max_iteration", "1"}}), HasSubstr("max_iterations"));
}

INSTANTIATE_TEST_SUITE_P(Registry, EveryStrategy, ::testing::ValuesIn(SolverStrategies().Names()),
                         [](const auto& instance) { return instance.param; });

}  // namespace
}  // namespace cirque
