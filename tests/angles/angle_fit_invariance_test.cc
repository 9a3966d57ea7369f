// What the fitted angles do not depend on, which of all feasible angles they are, and known answers
// at both ends of a range.
#include <algorithm>
#include <cmath>
#include <map>
#include <string>

#include <gtest/gtest.h>

#include "cirque/angles/infeasibility.h"
#include "cirque/angles/registry.h"
#include "cirque/intrinsic/intrinsic_surface.h"

#include "tests/common/renumbering.h"
#include "tests/common/surfaces.h"

namespace cirque {
namespace {

constexpr double kEpsilon = 1e-3;

/// The solvers that find ranged sums: all but the strategies without a treatment of kinks.
constexpr const char* kSolvers[] = {"newton", "newton_cg", "interior_point",
                                    "ceres_augmented_lagrangian"};

bool Takes(const std::string& solver, const std::string& objective) {
  return solver != "interior_point" || objective != "barrier";
}

AngleFitResult Fit(const std::string& solver, const std::string& objective,
                   const AngleConstraints& constraints, const Eigen::VectorXd& reference,
                   const Eigen::VectorXd* start = nullptr) {
  AngleFitResult result;
  const Status status =
      FitAngles({constraints, reference, kEpsilon, start}, *AngleObjectives().Find(objective),
                **MakeAngleSolver(solver), {}, &result);
  EXPECT_TRUE(status.ok()) << solver << " " << objective << ": " << status.message();
  return result;
}

class AngleFitOf : public testing::TestWithParam<const char*> {
 protected:
  const Surface surface_ = GeneratedSurface(GetParam(), 200);
  const Triangulation& t_ = surface_.triangulation;
  const ConeTargets targets_ = FreeBoundaryTargets(t_);
  const AngleConstraints constraints_{t_, targets_};
  const CornerAngles reference_ = AnglesOf(surface_);
};

TEST_P(AngleFitOf, DoesNotDependOnScale) {
  const EdgeLengths lengths = MeasureEdgeLengths(surface_);
  for (const char* solver : kSolvers) {
    const AngleFitResult fit = Fit(solver, "quadratic", constraints_, reference_.value);
    ASSERT_GT((fit.angles.value - reference_.value).norm(), 1e-3);
    // By a power of two to the last bit, otherwise to rounding.
    for (const double scale : {std::ldexp(1, -30), 3.7e5}) {
      const CornerAngles scaled = MeasureCornerAngles(t_, {scale * lengths.value});
      const AngleFitResult other = Fit(solver, "quadratic", constraints_, scaled.value);
      const double difference = (other.angles.value - fit.angles.value).lpNorm<Eigen::Infinity>();
      EXPECT_LE(difference, scale < 1 ? 0 : 1e-9) << solver;
    }
  }
}

TEST_P(AngleFitOf, DoesNotDependOnNumbering) {
  const Renumbering r = Renumber(t_, 4);
  const AngleConstraints constraints(r.triangulation, r.Targets(targets_));
  const Eigen::VectorXd reference = r.PerHalfedge(reference_.value);
  for (const std::string& objective : AngleObjectives().Names()) {
    if (objective == "least_squares") continue;  // may be incoherent
    for (const char* solver : kSolvers) {
      if (!Takes(solver, objective)) continue;
      const AngleFitResult fit = Fit(solver, objective, constraints_, reference_.value);
      const AngleFitResult other = Fit(solver, objective, constraints, reference);
      const Eigen::VectorXd difference = other.angles.value - r.PerHalfedge(fit.angles.value);
      EXPECT_LT(difference.lpNorm<Eigen::Infinity>(), 1e-6) << objective << " " << solver;
    }
  }
}

double Value(const AngleObjective& objective, const AngleConstraints& constraints,
             const Eigen::VectorXd& reference, const Eigen::VectorXd& alpha) {
  const Triangulation& t = constraints.triangulation();
  double sum = 0;
  for (const Index l : t.edge_halfedge) {
    const Index r = t.twin[l];
    sum += r == kNone
               ? objective.Boundary(reference[l], kEpsilon, alpha[l])
               : objective.Interior(reference[l], reference[r], kEpsilon, alpha[l], alpha[r]);
  }
  return sum;
}

TEST_P(AngleFitOf, EachObjectiveIsLeastAtItsOwnSolution) {
  // The solutions of the others are feasible too, and so is all that lies between two.
  std::map<std::string, Eigen::VectorXd> solution;
  for (const std::string& name : AngleObjectives().Names()) {
    if (name == "least_squares") continue;
    solution[name] = Fit("newton", name, constraints_, reference_.value).angles.value;
  }
  ASSERT_GE(solution.size(), 3u);
  for (const auto& [name, own] : solution) {
    const AngleObjective& objective = **AngleObjectives().Find(name);
    const double least = Value(objective, constraints_, reference_.value, own);
    EXPECT_GT(least, 1e-4);
    for (const auto& [other_name, other] : solution) {
      if (other_name == name || (other - own).norm() < 1e-6) continue;
      double before = least;
      for (const double share : {0.03, 0.3, 1.0}) {
        const double value =
            Value(objective, constraints_, reference_.value, (1 - share) * own + share * other);
        EXPECT_GT(value, before) << name << " towards " << other_name << " by " << share;
        before = value;
      }
    }
  }
}

TEST_P(AngleFitOf, AStartAtTheSolutionsMultipliersIsTheSolution) {
  const AngleFitResult fit = Fit("newton", "quadratic", constraints_, reference_.value);
  const AngleFitResult again =
      Fit("newton", "quadratic", constraints_, reference_.value, &fit.multipliers);
  EXPECT_LE(again.solve.num_iterations(), 1);
  EXPECT_LT(again.solve.num_iterations(), fit.solve.num_iterations());
  EXPECT_LT((again.angles.value - fit.angles.value).lpNorm<Eigen::Infinity>(), 1e-9);
}

INSTANTIATE_TEST_SUITE_P(Surfaces, AngleFitOf,
                         testing::Values("bumpy_terrain", "spherical_cap", "capped_tube"),
                         [](const auto& of_case) { return std::string(of_case.param); });

/// A symmetric fan with a range for its apex: the sum nearest to the reference's, split evenly.
TEST(AngleFitRange, ASumOutsideStopsAtTheNearerEnd) {
  constexpr int n = 7;
  const Surface fan = Fan(n, 0.6);
  const CornerAngles reference = AnglesOf(fan);
  double reference_sum = 0;
  for (Index h = 0; h < fan.triangulation.num_halfedges(); ++h) {
    if (fan.triangulation.vertex[h] == 0) reference_sum += reference.value[h];
  }
  const std::pair<double, double> ranges[] = {{reference_sum + 0.5, reference_sum + 1},
                                              {reference_sum - 1, reference_sum - 0.5},
                                              {reference_sum - 0.5, reference_sum + 0.5}};
  for (const auto& [lower, upper] : ranges) {
    ConeTargets targets = FreeBoundaryTargets(fan.triangulation);
    targets.lower[0] = lower;
    targets.upper[0] = upper;
    const AngleConstraints constraints(fan.triangulation, targets);
    const double sum = std::clamp(reference_sum, lower, upper);
    for (const char* solver : kSolvers) {
      SCOPED_TRACE(solver);
      const AngleFitResult fit = Fit(solver, "quadratic", constraints, reference.value);
      for (Index h = 0; h < fan.triangulation.num_halfedges(); ++h) {
        const bool at_apex = fan.triangulation.vertex[h] == 0;
        EXPECT_NEAR(fit.angles.value[h], at_apex ? sum / n : 0.5 * (kPi - sum / n), 1e-8);
      }
      // The apex's multiplier pulls towards the range: 3/2 of what each of its corners is off.
      const double y = fit.multipliers[fan.triangulation.num_faces()];
      EXPECT_NEAR(y, 1.5 * (sum - reference_sum) / n, 1e-6);
    }
  }
}

TEST(AngleFitRange, ATighterRangeNeverFitsBetter) {
  const Surface surface = GeneratedSurface("bumpy_terrain", 150);
  const Triangulation& t = surface.triangulation;
  const CornerAngles reference = AnglesOf(surface);
  const std::vector<bool> boundary = BoundaryVertices(t);
  double before = 0;
  for (const double width : {2.0, 0.5, 0.1, 0.0}) {
    ConeTargets targets = FreeBoundaryTargets(t);
    for (Index v = 0; v < t.num_vertices; ++v) {
      if (!boundary[v]) targets.lower[v] -= width, targets.upper[v] += width;
    }
    const AngleConstraints constraints(t, targets);
    const double primal = Fit("newton", "quadratic", constraints, reference.value).kkt.primal;
    EXPECT_GE(primal, before - 1e-12) << width;
    before = primal;
  }
  EXPECT_GT(before, 1e-2);
}

}  // namespace
}  // namespace cirque
