// Every angle solver on every objective: the same minimiser, the same report.
#include "cirque/angles/registry.h"

#include <algorithm>
#include <atomic>
#include <set>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cirque/solver/solver_strategy.h"

#include "tests/common/surfaces.h"

namespace cirque {
namespace {

using ::testing::HasSubstr;

struct Fitted {
  Status status;
  AngleFitResult result;
};

Fitted Fit(const std::string& method, const std::string& objective, const Surface& surface,
           const ConeTargets& targets, const SolveControl& control = {},
           const OptionMap& options = {}) {
  const AngleConstraints constraints(surface.triangulation, targets);
  const CornerAngles reference = AnglesOf(surface);
  const auto made = MakeAngleSolver(method, options);
  EXPECT_TRUE(made.ok()) << made.status().message();
  Fitted fitted;
  fitted.status = FitAngles({constraints, reference.value, 1e-3},
                            *AngleObjectives().Find(objective), **made, control, &fitted.result);
  return fitted;
}

Fitted FlatFit(const std::string& method, const std::string& objective, const Surface& surface) {
  return Fit(method, objective, surface, FreeBoundaryTargets(surface.triangulation));
}

bool Takes(const std::string& method, const std::string& objective) {
  return method != "interior_point" || objective != "barrier";
}

double Difference(const Fitted& a, const Fitted& b) {
  return (a.result.angles.value - b.result.angles.value).lpNorm<Eigen::Infinity>();
}

TEST(AngleSolvers, AgreeOnTheMinimiserOfEveryObjective) {
  for (const char* surface_name : {"bumpy_terrain", "capped_tube", "enneper_patch"}) {
    const Surface surface = GeneratedSurface(surface_name, 250);
    for (const std::string& objective : AngleObjectives().Names()) {
      if (objective == "least_squares") continue;  // may be incoherent, see below
      const Fitted reference = FlatFit("newton", objective, surface);
      ASSERT_TRUE(reference.status.ok()) << reference.status.message();
      EXPECT_GT((reference.result.angles.value - AnglesOf(surface).value).norm(), 1e-3);
      for (const std::string& method : AngleSolvers().Names()) {
        if (!Takes(method, objective)) continue;
        SCOPED_TRACE(std::string(surface_name) + " " + objective + " " + method);
        const Fitted fitted = FlatFit(method, objective, surface);
        ASSERT_TRUE(fitted.status.ok()) << fitted.status.message();
        EXPECT_LT(Difference(fitted, reference), 1e-6);
      }
    }
  }
}

TEST(AngleSolvers, MeetTheOptimalityConditionsOfEveryObjective) {
  const Surface surface = GeneratedSurface("bumpy_terrain", 300, 3);
  for (const std::string& objective : AngleObjectives().Names()) {
    for (const std::string& method : AngleSolvers().Names()) {
      if (!Takes(method, objective)) continue;
      SCOPED_TRACE(objective + " " + method);
      const Fitted fitted = FlatFit(method, objective, surface);
      const KktReport& kkt = fitted.result.kkt;
      EXPECT_LT(kkt.triangle_sum_residual, 1e-14);
      EXPECT_LT(kkt.vertex_sum_residual, 1e-10);
      EXPECT_LT(kkt.inequality_violation, 1e-10);
      EXPECT_LT(kkt.stationarity, 1e-7);
      EXPECT_LT(kkt.dual_infeasibility, 1e-5);
      EXPECT_LT(kkt.complementarity, 1e-8);
      EXPECT_LT(kkt.RelativeGap(), 1e-8);
      EXPECT_GT(kkt.primal, 1e-3);
      EXPECT_GT(fitted.result.multipliers.norm(), 1e-3);
    }
  }
}

TEST(AngleSolvers, SummariesSayWhatWasDone) {
  const Surface surface = GeneratedSurface("bumpy_terrain", 200);
  for (const std::string& method : AngleSolvers().Names()) {
    SCOPED_TRACE(method);
    const SolveSummary solve = FlatFit(method, "quadratic", surface).result.solve;
    EXPECT_TRUE(solve.Converged()) << solve.BriefReport();
    EXPECT_GT(solve.num_iterations(), 0);
    EXPECT_GT(solve.factorizations, 0);
    EXPECT_GE(std::max(solve.factorizations, solve.linear_solves), solve.num_iterations());
    EXPECT_TRUE(solve.x_changed);
    EXPECT_GT(solve.total_seconds, 0);
    EXPECT_GE(solve.total_seconds, solve.factorization_seconds);
    EXPECT_LT(solve.final_gradient_max, 1e-10);
    EXPECT_FALSE(solve.message.empty());
  }
}

TEST(AngleSolvers, TakeRangedAngleSums) {
  // The rim's angle sums are held to a range that binds at some vertices and not at others.
  const Surface surface = GeneratedSurface("bumpy_terrain", 200);
  const Triangulation& t = surface.triangulation;
  ConeTargets targets = FreeBoundaryTargets(t);
  const std::vector<bool> boundary = BoundaryVertices(t);
  for (Index v = 0; v < t.num_vertices; ++v) {
    if (boundary[v]) targets.lower[v] = 0.9 * kPi, targets.upper[v] = 1.1 * kPi;
  }
  // Two corners take the curvature that the rest of the rim may not have.
  int freed = 0;
  for (Index v = 0; v < t.num_vertices && freed < 8; ++v) {
    if (boundary[v] && CornersPerVertex(t)[v] >= 2) targets.lower[v] = 0.2 * kPi, ++freed;
  }
  const Fitted interior = Fit("interior_point", "quadratic", surface, targets);
  const Fitted augmented = Fit("ceres_augmented_lagrangian", "quadratic", surface, targets);
  ASSERT_TRUE(interior.status.ok()) << interior.status.message();
  ASSERT_TRUE(augmented.status.ok()) << augmented.status.message();
  EXPECT_LT(Difference(interior, augmented), 1e-6);
  EXPECT_LT(interior.result.kkt.RelativeGap(), 1e-10);
  EXPECT_LT(interior.result.kkt.complementarity, 1e-10);
  for (const char* newton : {"newton", "newton_cg"}) {
    const Fitted dual = Fit(newton, "quadratic", surface, targets);
    ASSERT_TRUE(dual.status.ok()) << dual.status.message();
    EXPECT_LT(Difference(interior, dual), 1e-8) << newton;
    EXPECT_LT(dual.result.kkt.complementarity, 1e-12) << newton;
    EXPECT_LE(dual.result.solve.num_iterations(), 12) << newton;
  }
  const Fitted refused = Fit("ceres_line_search", "quadratic", surface, targets);
  EXPECT_EQ(refused.status.code(), StatusCode::kInvalidInput) << refused.status.message();
  const auto y =
      interior.result.multipliers.tail(interior.result.multipliers.size() - t.num_faces());
  EXPECT_GT(y.maxCoeff(), 1e-3);  // some sums are held up, some down, some run free
  EXPECT_LT(y.minCoeff(), -1e-3);
}

TEST(AngleSolvers, FixedSumsAtEveryVertexLeaveAGaugeThatIsHandled) {
  const Surface fan = Fan(6, 0.5);
  ConeTargets targets = FreeBoundaryTargets(fan.triangulation);
  for (Index v = 1; v <= 6; ++v) targets.lower[v] = targets.upper[v] = (v % 2 ? 5 : 7) * kPi / 9;
  const Fitted reference = Fit("newton", "quadratic", fan, targets);
  ASSERT_TRUE(reference.status.ok()) << reference.status.message();
  for (const char* method : {"interior_point", "ceres_augmented_lagrangian"}) {
    const Fitted fitted = Fit(method, "quadratic", fan, targets);
    ASSERT_TRUE(fitted.status.ok()) << fitted.status.message();
    EXPECT_LT(Difference(fitted, reference), 1e-8) << method;
  }
}

TEST(AngleSolvers, EachCertifiesInfeasibility) {
  const Surface kleetope = Kleetope(GeneratedSurface("bumpy_terrain", 100));
  for (const std::string& method : AngleSolvers().Names()) {
    SCOPED_TRACE(method);
    const Fitted fitted = FlatFit(method, "quadratic", kleetope);
    EXPECT_EQ(fitted.status.code(), StatusCode::kInfeasible) << fitted.status.message();
    EXPECT_EQ(fitted.result.infeasibility.epsilon_over_pi, 0);
    EXPECT_GT(fitted.result.infeasibility.margin, 0);
  }
}

TEST(AngleSolvers, MarginsShrinkUnderEach) {
  const Surface fan = Fan(40, 0.1);
  // 40 corners of 0.12 rad would take more than half of the full angle.
  const AngleConstraints constraints(fan.triangulation, FreeBoundaryTargets(fan.triangulation));
  const CornerAngles reference = AnglesOf(fan);
  for (const std::string& method : AngleSolvers().Names()) {
    AngleFitResult result;
    const Status status =
        FitAngles({constraints, reference.value, 0.12}, *AngleObjectives().Find("quadratic"),
                  **MakeAngleSolver(method), {}, &result);
    ASSERT_TRUE(status.ok()) << method << ": " << status.message();
    EXPECT_LT(result.angles.epsilon, 0.12);
    EXPECT_GE(result.kkt.smallest_angle, result.angles.epsilon - 1e-9);
  }
}

TEST(AngleSolvers, EndWhenAsked) {
  const Surface surface = GeneratedSurface("capped_tube", 200);
  const ConeTargets targets = FreeBoundaryTargets(surface.triangulation);
  const std::atomic<bool> cancelled = true;
  for (const std::string& method : AngleSolvers().Names()) {
    SCOPED_TRACE(method);
    EXPECT_EQ(Fit(method, "quadratic", surface, targets, {{}, &cancelled}).status.code(),
              StatusCode::kCancelled);
    int calls = 0;
    const auto stop = [&](const IterationRecord&, const Eigen::VectorXd& x) {
      EXPECT_GT(x.size(), 0);
      ++calls;
      return CallbackAction::kStop;
    };
    const Fitted stopped = Fit(method, "quadratic", surface, targets, {stop, nullptr});
    EXPECT_EQ(stopped.result.solve.termination, Termination::kStoppedByCaller);
    EXPECT_EQ(calls, 1);
    const Fitted limited =
        Fit(method, "quadratic", surface, targets, {}, {{"max_iterations", "1"}});
    EXPECT_EQ(limited.result.solve.termination, Termination::kIterationLimit);
    EXPECT_EQ(limited.status.code(), StatusCode::kNotConverged);
    const Fitted late = Fit(method, "quadratic", surface, targets, {}, {{"max_seconds", "0"}});
    EXPECT_EQ(late.result.solve.termination, Termination::kTimeLimit);
  }
}

TEST(AngleSolvers, NamesOfSolverStrategiesMeanTheDual) {
  std::set<std::string> names;
  for (const std::string& name : AngleSolverNames()) {
    EXPECT_TRUE(names.insert(name).second) << name;
    const Status status = MakeAngleSolver(name).status();
    EXPECT_TRUE(status.ok() || status.message().find("built without") != std::string::npos) << name;
  }
  const auto unknown = MakeAngleSolver("interior_pint");
  EXPECT_EQ(unknown.status().code(), StatusCode::kInvalidInput);
  EXPECT_THAT(unknown.status().message(), HasSubstr("did you mean 'interior_point'?"));
  for (const std::string& name : names) {
    EXPECT_THAT(unknown.status().message(), HasSubstr(name));
  }
}

TEST(AngleSolvers, OptionsInTheTextPrecedeOthers) {
  const Surface surface = GeneratedSurface("bumpy_terrain", 400);
  const ConeTargets targets = FreeBoundaryTargets(surface.triangulation);
  for (const std::string method : {"newton_cg", "dual", "interior_point"}) {
    const Fitted limited = Fit(method + ":max_iterations=1", "quadratic", surface, targets, {},
                               {{"max_iterations", "50"}});
    EXPECT_EQ(limited.result.solve.num_iterations(), 1) << method;
    EXPECT_EQ(limited.result.solve.termination, Termination::kIterationLimit) << method;
  }
  EXPECT_TRUE(CheckAngleSolver("newton_amg:max_cg_iterations=5").ok());
  EXPECT_TRUE(CheckAngleSolver("dual:strategy=newton,max_seconds=3").ok());
  for (const char* refused : {"interior_pint", "newton:steps=3", "dual:strategy=none",
                              "interior_point:gap_tolerance=-1"}) {
    EXPECT_EQ(CheckAngleSolver(refused).code(), StatusCode::kInvalidInput) << refused;
  }
}

/// However it is said; components are then mapped one after the other.
TEST(AngleSolvers, TellWhetherProcessesShareTheWork) {
  for (const char* shared :
       {"newton_amg", "newton_amg:max_cg_iterations=5", "dual:strategy=newton_amg"}) {
    EXPECT_TRUE(IsDistributedAngleSolver(shared)) << shared;
    EXPECT_TRUE(CheckAngleSolver(shared).ok()) << shared;
  }
  for (const char* alone : {"auto", "dual", "dual:strategy=newton", "interior_point", "newton_am"})
    EXPECT_FALSE(IsDistributedAngleSolver(alone)) << alone;
}

TEST(AngleSolvers, OptionsAreRefusedByNameValueAndBound) {
  const auto message = [](const std::string& method, const OptionMap& options) {
    return MakeAngleSolver(method, options).status().message();
  };
  EXPECT_THAT(message("interior_point", {{"max_iteration", "5"}}),
              HasSubstr("unknown interior_point option 'max_iteration'; did you mean"));
  EXPECT_EQ(message("interior_point", {{"gap_tolerance", "-1"}}),
            "interior_point: gap_tolerance = '-1' is not a number in [0, 1]");
  EXPECT_EQ(message("ceres_augmented_lagrangian", {{"max_outer_iterations", "0"}}),
            "ceres_augmented_lagrangian: max_outer_iterations = '0' is not an integer in [1, "
            "2.14748e+09]");
  EXPECT_THAT(message("newton", {{"gradient_tolerance", "x"}}), HasSubstr("gradient_tolerance"));
  EXPECT_THAT(message("dual", {{"strategy", "newtn"}}), HasSubstr("did you mean 'newton'?"));
}

TEST(AngleSolvers, InteriorPointRefusesWhatMeasuresIntersectionAngles) {
  const Surface fan = Fan(6, 0.5);
  const Fitted fitted = FlatFit("interior_point", "barrier", fan);
  EXPECT_EQ(fitted.status.code(), StatusCode::kInvalidInput);
  EXPECT_THAT(fitted.status.message(), HasSubstr("not barrier"));
}

}  // namespace
}  // namespace cirque
