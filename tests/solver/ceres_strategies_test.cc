// What is particular to the strategies on Ceres.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "experiments/common/solver_problem.h"
#include "tests/common/surfaces.h"
#include "tests/solver/strategy_fixtures.h"

namespace cirque {
namespace {

using testing::HasSubstr;

class CeresStrategiesTest : public ::testing::Test {
 protected:
  SolveSummary Minimize(const std::string& strategy, const OptionMap& options,
                        Eigen::VectorXd* x) const {
    *x = Eigen::VectorXd::Zero(energy_->NumParameters());
    return Strategy(strategy, options)->Minimize(*energy_, {}, x);
  }

  double DistanceToNewton(const Eigen::VectorXd& x) const {
    Eigen::VectorXd newton;
    EXPECT_TRUE(Minimize("newton", {}, &newton).Converged());
    return (ComparableSolution(*energy_, x) - ComparableSolution(*energy_, newton))
        .lpNorm<Eigen::Infinity>();
  }

  const std::shared_ptr<const StudyProblem> problem_ =
      *MakeProblem("terrain", GeneratedSurface("bumpy_terrain", 400, 3));
  const std::unique_ptr<Energy> energy_ = (*Energies().Find("circle_pattern"))(problem_->input);
};

TEST_F(CeresStrategiesTest, EveryTrustRegionMethodFindsTheMinimum) {
  for (const char* method : {"levenberg_marquardt", "dogleg"}) {
    for (const char* residuals : {"exact", "gradient"}) {
      Eigen::VectorXd x;
      const SolveSummary summary =
          Minimize("ceres_trust_region", {{"trust_region", method}, {"residuals", residuals}}, &x);
      EXPECT_LE(summary.final_gradient_max, 1e-9) << method << residuals << summary.FullReport();
      EXPECT_LE(DistanceToNewton(x), 1e-8) << method << residuals;
      EXPECT_EQ(x[0], 0) << "the gauge moved";
      EXPECT_GE(summary.hessian_evaluations, summary.num_iterations());
      EXPECT_GE(summary.factorizations, summary.num_iterations());
    }
  }
}

TEST_F(CeresStrategiesTest, EdgeResidualsMakeGaussNewtonContractFast) {
  // docs/mathematics.md, Radii: by 0.02 to 0.2 a step from zero.
  Eigen::VectorXd x;
  const SolveSummary summary = Minimize("ceres_trust_region", {}, &x);
  ASSERT_TRUE(summary.Converged()) << summary.FullReport();
  EXPECT_LE(summary.num_iterations(), 16);
}

TEST_F(CeresStrategiesTest, ThreadsDoNotChangeTheSolution) {
  Eigen::VectorXd one, two;
  Minimize("ceres_trust_region", {{"num_threads", "1"}}, &one);
  Minimize("ceres_trust_region", {{"num_threads", "2"}}, &two);
  EXPECT_LE((one - two).lpNorm<Eigen::Infinity>(), 1e-10);
}

TEST_F(CeresStrategiesTest, GradientResidualsServeAnyEnergyEvenWithAChangingPattern) {
  // The quadratic dual's Hessian gains and loses entries as edges leave and reach their margins.
  const std::unique_ptr<Energy> dual = (*Energies().Find("quadratic_dual"))(problem_->input);
  Eigen::VectorXd x = Eigen::VectorXd::Zero(dual->NumParameters());
  const SolveSummary summary =
      Strategy("ceres_trust_region", {{"residuals", "gradient"}})->Minimize(*dual, {}, &x);
  EXPECT_LE(summary.final_gradient_max, 1e-9) << summary.FullReport();
  Eigen::VectorXd newton = Eigen::VectorXd::Zero(x.size());
  Strategy("newton")->Minimize(*dual, {}, &newton);
  EXPECT_LE(
      (ComparableSolution(*dual, x) - ComparableSolution(*dual, newton)).lpNorm<Eigen::Infinity>(),
      1e-8);
}

TEST_F(CeresStrategiesTest, EveryLineSearchDirectionDescends) {
  Eigen::VectorXd x;
  const double least = Minimize("newton", {}, &x).final_value;
  const OptionMap methods[] = {{{"direction", "lbfgs"}},
                               {{"direction", "bfgs"}},
                               {{"direction", "nonlinear_conjugate_gradient"}},
                               {{"direction", "steepest_descent"}},
                               {{"direction", "steepest_descent"}, {"line_search", "armijo"}}};
  for (OptionMap options : methods) {
    options["max_iterations"] = "200";
    const SolveSummary summary = Minimize("ceres_line_search", options, &x);
    EXPECT_LT(summary.final_value - least, 0.25 * (summary.initial_value - least))
        << summary.BriefReport();
    EXPECT_GT(summary.final_value, least - 1e-11);
    EXPECT_THAT(summary.strategy, HasSubstr(options["direction"]));
  }
}

TEST(CeresLineSearch, BfgsRefusesManyParameters) {
  const QuadraticEnergy energy(Eigen::VectorXd::Ones(2001));
  Eigen::VectorXd x = Eigen::VectorXd::Zero(2001);
  const SolveSummary summary =
      Strategy("ceres_line_search", {{"direction", "bfgs"}})->Minimize(energy, {}, &x);
  EXPECT_EQ(summary.termination, Termination::kUnsupported);
  EXPECT_EQ(summary.message, "bfgs keeps a dense matrix: 2001 parameters > 2000; use lbfgs");
  EXPECT_TRUE(x.isZero(0));
}

TEST(CeresLineSearch, SolvesAQuadraticToRounding) {
  const QuadraticEnergy energy(Eigen::VectorXd::LinSpaced(60, -3, 7));
  for (const char* direction : {"lbfgs", "bfgs", "nonlinear_conjugate_gradient"}) {
    Eigen::VectorXd x = Eigen::VectorXd::Zero(60);
    const SolveSummary summary =
        Strategy("ceres_line_search", {{"direction", direction}})->Minimize(energy, {}, &x);
    EXPECT_TRUE(summary.Converged()) << summary.BriefReport();
    EXPECT_LT((x - energy.minimiser()).lpNorm<Eigen::Infinity>(), 1e-10) << direction;
  }
}

TEST_F(CeresStrategiesTest, DiagonalScalingHelpsWhereWeightsVary) {
  Eigen::VectorXd x;
  const double least = Minimize("newton", {}, &x).final_value;
  const auto gap = [&](const std::string& scaling) {
    const OptionMap options = {{"scaling", scaling}, {"max_iterations", "60"}};
    return Minimize("ceres_line_search", options, &x).final_value - least;
  };
  EXPECT_LT(gap("diagonal"), 0.5 * gap("none"));
}

TEST(CeresLineSearch, OptionsAreBounded) {
  const auto message = [](const OptionMap& options) {
    return MakeSolverStrategy("ceres_line_search", options).status().message();
  };
  EXPECT_EQ(message({{"max_lbfgs_rank", "0"}}),
            "ceres_line_search: max_lbfgs_rank = '0' is not an integer in [1, 1000]");
  EXPECT_EQ(message({{"direction", "lbfgs"}, {"line_search", "armijo"}}),
            "ceres_line_search: line_search = 'armijo' does not go with direction = 'lbfgs'; use "
            "wolfe");
  EXPECT_EQ(message({{"direction", "steepest_descent"}, {"line_search", "armijo"}}), "");
}

TEST(CeresTrustRegion, OptionsAreBounded) {
  const auto message = [](const OptionMap& options) {
    return MakeSolverStrategy("ceres_trust_region", options).status().message();
  };
  EXPECT_EQ(
      message({{"trust_region", "newton"}}),
      "ceres_trust_region: trust_region = 'newton' is not one of levenberg_marquardt, dogleg");
  EXPECT_EQ(message({{"num_threads", "0"}}),
            "ceres_trust_region: num_threads = '0' is not an integer in [1, 256]");
}

TEST(CeresTrustRegion, SaysWhichEnergiesItCannotTake) {
  const QuadraticEnergy energy(Eigen::VectorXd::Ones(3));
  Eigen::VectorXd x = Eigen::VectorXd::Zero(3);
  const SolveSummary refused = Strategy("ceres_trust_region")->Minimize(energy, {}, &x);
  EXPECT_EQ(refused.termination, Termination::kUnsupported);
  EXPECT_EQ(refused.message,
            "the energy has no least-squares form; use residuals = gradient or another strategy");
  const SolveSummary solved =
      Strategy("ceres_trust_region", {{"residuals", "gradient"}})->Minimize(energy, {}, &x);
  EXPECT_TRUE(solved.Converged());
  EXPECT_LT((x - energy.minimiser()).lpNorm<Eigen::Infinity>(), 1e-10);
}

}  // namespace
}  // namespace cirque
