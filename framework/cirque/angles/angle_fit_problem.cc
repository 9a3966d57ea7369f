#include "cirque/angles/angle_fit_problem.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

#include "cirque/core/parallel.h"
#include "cirque/energy/dual_angle_energy.h"

namespace cirque {
namespace {

/// The larger value, or NaN as soon as one is: a report must not swallow what is undefined.
double Worse(double a, double b) {
  return std::isnan(a) || std::isnan(b) ? kUnset : std::max(a, b);
}

/// Collects the conditions on the inequalities' multipliers, edge by edge.
class InequalityCheck {
 public:
  /// `distances`: those of all corners from their references (DualAngleEnergy).
  InequalityCheck(const AngleFitProblem& problem, const AngleObjective& objective,
                  const Eigen::VectorXd& alpha, const std::vector<ScalarJet>& distances,
                  const Eigen::VectorXd& y)
      : problem_(problem), objective_(objective), alpha_(alpha), distances_(distances), y_(y) {}

  void AddEdge(Index l, Index r) {
    if (r == kNone) return AddBoundaryEdge(l);
    const EdgeMargins margin = MarginsOf(problem_, objective_, l);
    const double theta = kPi - alpha_[l] - alpha_[r];
    const double excess_l = Excess(l, theta, kPi - problem_.reference[l] - problem_.reference[r]);
    const double excess_r = Excess(r, theta, kPi - problem_.reference[l] - problem_.reference[r]);
    if (margin.theta < 0) return AddFree(excess_l), AddFree(excess_r);
    const double slack_l = alpha_[l] - margin.l, slack_r = alpha_[r] - margin.r;
    const double slack = theta - margin.theta;
    violation_ = std::max({violation_, -slack_l, -slack_r, -slack});
    if (slack >= slack_l && slack >= slack_r) {
      Add(-excess_l, slack_l);
      Add(-excess_r, slack_r);
      return;
    }
    const bool left_is_free = slack_l >= slack_r;
    const double mu = left_is_free ? excess_l : excess_r;
    Add(mu, slack);
    Add(mu - (left_is_free ? excess_r : excess_l), left_is_free ? slack_r : slack_l);
  }

  void Add(const InequalityCheck& other) {
    dual_infeasibility_ = Worse(dual_infeasibility_, other.dual_infeasibility_);
    complementarity_ = Worse(complementarity_, other.complementarity_);
    largest_slope_ = std::max(largest_slope_, other.largest_slope_);
    violation_ = std::max(violation_, other.violation_);
  }

  double dual_infeasibility() const { return dual_infeasibility_ / (1 + largest_slope_); }
  double complementarity() const { return complementarity_; }
  double violation() const { return violation_; }

 private:
  void AddBoundaryEdge(Index h) {
    const EdgeMargins margin = MarginsOf(problem_, objective_, h);
    const double theta = kPi - alpha_[h];
    const double excess = Excess(h, theta, kPi - problem_.reference[h]);
    if (margin.theta < 0) return AddFree(excess);
    const double slack_alpha = alpha_[h] - margin.l, slack_theta = theta - margin.theta;
    violation_ = std::max({violation_, -slack_alpha, -slack_theta});
    slack_theta < slack_alpha ? Add(excess, slack_theta) : Add(-excess, slack_alpha);
  }

  /// (A'y - grad phi)_h.
  double Excess(Index h, double theta, double theta_reference) {
    const double target = problem_.constraints.Slope(y_.data(), h);
    largest_slope_ = std::max(largest_slope_, std::abs(target));
    double gradient = distances_[h].slope;
    if (objective_.MeasuresTheta()) {
      const double reference = objective_.ClampReference(theta_reference, problem_.epsilon);
      gradient -= objective_.Distance(reference, theta).slope;
    }
    return target - gradient;
  }

  /// A multiplier with what is left to the margin that it holds.
  void Add(double multiplier, double slack) {
    dual_infeasibility_ = Worse(dual_infeasibility_, -multiplier);
    complementarity_ = Worse(complementarity_, std::abs(multiplier * slack));
  }

  /// Without inequalities the whole excess is an error.
  void AddFree(double excess) {
    dual_infeasibility_ = Worse(dual_infeasibility_, std::abs(excess));
  }

  const AngleFitProblem& problem_;
  const AngleObjective& objective_;
  const Eigen::VectorXd& alpha_;
  const std::vector<ScalarJet>& distances_;
  const Eigen::VectorXd& y_;
  double dual_infeasibility_ = 0, complementarity_ = 0, largest_slope_ = 0, violation_ = 0;
};

double RangeComplementarity(const AngleConstraints& constraints, const Eigen::VectorXd& alpha,
                            const Eigen::VectorXd& y) {
  const Eigen::VectorXd sums = constraints.Apply(alpha);
  double worst = 0;
  for (int row = constraints.num_faces(); row < constraints.num_rows(); ++row) {
    const double lower = constraints.Lower(row), upper = constraints.Upper(row);
    if (lower == upper) continue;
    worst = Worse(worst, std::abs(y[row] * (sums[row] - (y[row] > 0 ? lower : upper))));
  }
  return worst;
}

}  // namespace

EdgeMargins MarginsOf(const AngleFitProblem& problem, const AngleObjective& objective, Index h) {
  const Index g = problem.constraints.triangulation().twin[h];
  return g == kNone
             ? objective.Margins(problem.reference[h], problem.epsilon)
             : objective.Margins(problem.reference[h], problem.reference[g], problem.epsilon);
}

double KktReport::RelativeGap() const { return std::abs(primal - dual) / (1 + std::abs(primal)); }

KktReport CheckFeasibility(const AngleConstraints& constraints, const Eigen::VectorXd& alpha) {
  const Triangulation& t = constraints.triangulation();
  KktReport report;
  const Eigen::VectorXd sums = constraints.Apply(alpha);
  report.triangle_sum_residual = report.vertex_sum_residual = 0;
  for (int row = 0; row < constraints.num_rows(); ++row) {
    const double outside =
        std::max({0.0, constraints.Lower(row) - sums[row], sums[row] - constraints.Upper(row)});
    double& residual =
        row < constraints.num_faces() ? report.triangle_sum_residual : report.vertex_sum_residual;
    residual = Worse(residual, std::isnan(sums[row]) ? kUnset : outside);
  }
  report.smallest_angle = alpha.minCoeff();
  report.smallest_theta = kPi;
  for (const Index h : t.edge_halfedge) {
    const double opposite = t.twin[h] == kNone ? 0 : alpha[t.twin[h]];
    report.smallest_theta = std::min(report.smallest_theta, kPi - alpha[h] - opposite);
  }
  return report;
}

KktReport CheckKkt(const AngleFitProblem& problem, const AngleObjective& objective,
                   const Eigen::VectorXd& alpha, const Eigen::VectorXd& y) {
  KktReport report = CheckFeasibility(problem.constraints, alpha);
  // The energy shares the objective for the length of this call only: an aliasing pointer owns
  // nothing.
  const std::shared_ptr<const AngleObjective> borrowed(std::shared_ptr<void>(), &objective);
  const DualAngleEnergy energy(problem.constraints, problem.reference, problem.epsilon, borrowed);
  const std::vector<ScalarJet> distances = energy.Distances(alpha);
  report.primal = energy.Primal(alpha, distances);
  double negated_dual = kUnset;
  report.stationarity = (alpha - energy.Angles(y.data(), &negated_dual)).lpNorm<Eigen::Infinity>();
  report.dual = -negated_dual;
  const Triangulation& t = problem.constraints.triangulation();
  InequalityCheck check(problem, objective, alpha, distances, y);
  std::vector<InequalityCheck> of_block(NumBlocks(t.num_edges()), check);
  ForEachBlock(t.num_edges(), [&](int block, int begin, int end) {
    for (Index e = begin; e < end; ++e) {
      of_block[block].AddEdge(t.edge_halfedge[e], t.twin[t.edge_halfedge[e]]);
    }
  });
  for (const InequalityCheck& part : of_block) check.Add(part);
  report.inequality_violation = check.violation();
  report.dual_infeasibility = check.dual_infeasibility();
  report.complementarity =
      Worse(check.complementarity(), RangeComplementarity(problem.constraints, alpha, y)) /
      (1 + std::abs(report.primal));
  return report;
}

}  // namespace cirque
