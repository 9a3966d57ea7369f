#include "cirque/angles/angle_fit.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "cirque/core/text.h"

namespace cirque {
namespace {

constexpr double kAcceptedSums = 1e-9;  ///< [rad]
constexpr double kAcceptedGap = 1e-8;
constexpr double kLeastEpsilon = 1e-8;

/// The number of reference angles that the objective had to clamp.
int CountClamped(const AngleFitProblem& problem, const AngleObjective& objective) {
  const Triangulation& t = problem.constraints.triangulation();
  const auto clamped = [&](double reference) {
    return objective.ClampReference(reference, problem.epsilon) != reference ? 1 : 0;
  };
  int count = 0;
  for (const double reference : problem.reference) count += clamped(reference);
  if (!objective.MeasuresTheta()) return count;
  for (const Index h : t.edge_halfedge) {
    const double opposite = t.twin[h] == kNone ? 0 : problem.reference[t.twin[h]];
    count += clamped(kPi - problem.reference[h] - opposite);
  }
  return count;
}

/// An objective without inequalities can converge to angles that are no circle pattern's.
Status RequireCoherent(const KktReport& kkt) {
  if (kkt.smallest_angle > 0 && kkt.smallest_theta > 0) return Status();
  return Status(
      StatusCode::kNotConverged,
      fmt::format("the fitted angles are not coherent: smallest corner angle {:.3g} rad, "
                  "smallest intersection angle {:.3g} rad; use an angle fit with inequalities",
                  kkt.smallest_angle, kkt.smallest_theta));
}

/// The largest margin worth trying first.
double FirstEpsilon(const AngleFitProblem& problem) {
  const AngleConstraints& constraints = problem.constraints;
  const std::vector<Index>& corners = constraints.corners();
  double epsilon = problem.epsilon;
  for (std::size_t i = 0; i < constraints.constrained_vertices().size(); ++i) {
    const double sum = constraints.Upper(constraints.num_faces() + static_cast<int>(i));
    epsilon = std::min(epsilon, 0.5 * sum / corners[constraints.constrained_vertices()[i]]);
  }
  return epsilon;
}

}  // namespace

void CloseTriangles(Eigen::VectorXd* alpha) {
  for (Index h = 0; h < alpha->size(); h += 3) {
    auto face = alpha->segment<3>(h);
    face.array() += (kPi - face.sum()) / 3;
  }
}

std::string InfeasibleMessage(const InfeasibilityCertificate& certificate) {
  const std::string margin =
      certificate.epsilon_over_pi == 0
          ? std::string()
          : fmt::format(" with margin {:.1e} rad", certificate.epsilon_over_pi * kPi);
  return fmt::format(
      "no coherent angles{} exist: the infeasibility certificate's multipliers are largest at "
      "faces {} and vertices {} (0-based); allow cones there",
      margin, IdList(certificate.carrying_faces), IdList(certificate.carrying_vertices));
}

Status FinishFit(const AngleFitProblem& problem, const AngleObjective& objective,
                 InfeasibilityCertificate certificate, Eigen::VectorXd alpha,
                 Eigen::VectorXd multipliers, AngleFitResult* result) {
  result->multipliers = std::move(multipliers);
  if (!certificate.empty()) {
    result->infeasibility = std::move(certificate);
    return Status(StatusCode::kInfeasible, InfeasibleMessage(result->infeasibility));
  }
  if (result->solve.termination == Termination::kCancelled) {
    return Status(StatusCode::kCancelled, "angle fit: cancelled");
  }
  const KktReport found = CheckFeasibility(problem.constraints, alpha);
  CloseTriangles(&alpha);
  result->kkt = CheckKkt(problem, objective, alpha, result->multipliers);
  result->angles = {std::move(alpha), problem.epsilon};
  result->clamped_references = CountClamped(problem, objective);
  const double sums = std::max(found.triangle_sum_residual, found.vertex_sum_residual);
  const bool optimal = result->solve.Converged() || result->kkt.RelativeGap() <= kAcceptedGap;
  if (!(sums <= kAcceptedSums && optimal)) {
    return Status(StatusCode::kNotConverged, "angle fit: " + result->solve.BriefReport());
  }
  return RequireCoherent(result->kkt);
}

Status FitAngles(const AngleFitProblem& problem,
                 const std::shared_ptr<const AngleObjective>& objective, const AngleSolver& solver,
                 const SolveControl& control, AngleFitResult* result) {
  AngleFitProblem attempt = problem;
  attempt.epsilon = FirstEpsilon(problem);
  while (true) {
    *result = AngleFitResult();
    const Status status = solver.Fit(attempt, objective, control, result);
    const bool smaller_margin_may_do =
        status.code() == StatusCode::kInfeasible && result->infeasibility.epsilon_over_pi > 0;
    if (!smaller_margin_may_do || attempt.epsilon <= kLeastEpsilon) return status;
    attempt.epsilon = std::max(kLeastEpsilon, attempt.epsilon / 10);
  }
}

}  // namespace cirque
