#include "cirque/cones/greedy_cones.h"

#include <cmath>
#include <optional>

#include "cirque/cones/cone_choice.h"
#include "cirque/cones/cone_fit.h"

namespace cirque {
namespace {

bool IsAdmissible(const ConeProblem& problem, const ConeFit& fit) {
  for (int i = 0; i < fit.size(); ++i) {
    const double curvature = fit.curvature()[i];
    if (curvature < problem.LeastCurvature(fit.vertices()[i])) return false;
    if (curvature > problem.GreatestCurvature()) return false;
  }
  return true;
}

}  // namespace

const OptionTable<GreedyOptions>& GreedyOptionTable() {
  using O = GreedyOptions;
  static const OptionTable<O> kTable(
      "greedy", Joined<O>(BudgetOptions<O>(), {{"pick", &O::pick, "where the next cone goes"},
                                               {"fit", &O::fit, "the curvatures at the end"}}));
  return kTable;
}

StatusOr<std::vector<Cone>> GreedyCones::ChooseAtMost(const ConeProblem& problem, int count) const {
  if (options_.pick == ConePick::kDescent) {
    return ChooseByDescent(problem, std::vector<bool>(problem.triangulation().num_vertices, true),
                           count);
  }
  StatusOr<ConeChoice> choice = ConeChoice::Make(problem, count);
  if (!choice.ok()) return choice.status();
  if (choice->left() == 0) return std::vector<Cone>();
  ConeFit fit(problem);
  while (choice->left() > 0) {
    const std::optional<Index> next =
        choice->TakeBest(DistanceFromCones(problem, fit, fit.LogScale()));
    if (!next) break;
    fit.Add(*next);
    fit.FitZeroAtCones();
  }
  if (options_.fit == CurvatureFit::kLeastSquares || !IsAdmissible(problem, fit)) {
    FitAdmissible(problem, &*choice, &fit);
  }
  return fit.Cones();
}

}  // namespace cirque
