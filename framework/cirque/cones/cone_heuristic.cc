#include "cirque/cones/cone_heuristic.h"

#include <algorithm>
#include <utility>

namespace cirque {
namespace {

constexpr int kDefaultCones = 8, kMostCones = 1024;

}  // namespace

bool BudgetedHeuristic::MeetsTarget(const ConeProblem& problem,
                                    const StatusOr<std::vector<Cone>>& cones) const {
  if (!cones.ok()) return false;
  const Eigen::VectorXd u = PredictedLogScale(problem, *cones);
  const double norm =
      budget_.norm == LogScaleNorm::kL2 ? AreaNorm(problem, u) : u.lpNorm<Eigen::Infinity>();
  return norm <= budget_.target;
}

StatusOr<std::vector<Cone>> BudgetedHeuristic::Choose(const ConeProblem& problem) const {
  const bool has_target = budget_.target > 0;
  int most = budget_.cones >= 0 ? budget_.cones : has_target ? kMostCones : kDefaultCones;
  most = std::min(most, static_cast<int>(problem.candidates().size()));
  if (!has_target) return ChooseAtMost(problem, most);
  int below = -1, enough = 0;
  StatusOr<std::vector<Cone>> best = ChooseAtMost(problem, enough);
  while (!MeetsTarget(problem, best)) {
    if (enough == most) return best;
    below = enough;
    enough = std::min(most, std::max(1, 2 * enough));
    best = ChooseAtMost(problem, enough);
  }
  while (enough - below > 1) {
    const int middle = (below + enough) / 2;
    StatusOr<std::vector<Cone>> cones = ChooseAtMost(problem, middle);
    const bool met = MeetsTarget(problem, cones);
    (met ? enough : below) = middle;
    if (met) best = std::move(cones);
  }
  return best;
}

Eigen::VectorXd PredictedLogScale(const ConeProblem& problem, const std::vector<Cone>& cones) {
  Eigen::VectorXd right = -problem.curvature();
  for (const Cone& cone : cones) {
    if (!problem.IsCandidate(cone.vertex)) continue;
    right[cone.vertex] += 2 * kPi - 0.5 * (cone.lower + cone.upper);
  }
  return problem.Solve(right);
}

}  // namespace cirque
