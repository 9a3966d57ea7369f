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
  static const OptionTable<GreedyOptions> kTable("greedy", [] {
    auto fields = BudgetFields<GreedyOptions>();
    fields.push_back(
        {"pick", &GreedyOptions::pick, 0, 0, {"extreme", "descent"}, "where the next cone goes"});
    fields.push_back({"fit",
                      &GreedyOptions::fit,
                      0,
                      0,
                      {"least_squares", "zero_at_cones"},
                      "the curvatures at the end"});
    return fields;
  }());
  return kTable;
}

StatusOr<std::vector<Cone>> GreedyCones::ChooseAtMost(const ConeProblem& problem, int count) const {
  if (options_.pick == "descent") {
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
  if (options_.fit == "least_squares" || !IsAdmissible(problem, fit)) fit.FitLeastSquares();
  return fit.Cones();
}

}  // namespace cirque
