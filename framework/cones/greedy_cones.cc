#include "cirque/cones/greedy_cones.h"

#include <cmath>
#include <optional>

#include "cirque/cones/cone_choice.h"
#include "cirque/cones/cone_fit.h"

namespace cirque {
namespace {

/// How far each vertex is from the level of the cones so far, or where there are none, from what
/// nothing would have to be done about.
Eigen::VectorXd ScoreAgainstCones(const ConeProblem& problem, const ConeFit& fit,
                                  const Eigen::VectorXd& field) {
  double level = 0;
  if (problem.IsClosed()) {
    // Both fields are known up to a constant.
    level = 0.5 * (field.maxCoeff() + field.minCoeff());
    if (fit.size() > 0) level = field(fit.vertices()).mean();
  }
  return (field.array() - level).abs();
}

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

StatusOr<std::vector<Cone>> GreedyCones::PlaceAtMost(const ConeProblem& problem, int count) const {
  StatusOr<ConeChoice> choice = ConeChoice::Make(problem, count);
  if (!choice.ok()) return choice.status();
  if (choice->left() == 0) return std::vector<Cone>();
  const bool descent = options_.pick == "descent";
  ConeFit fit(problem);
  while (choice->left() > 0) {
    const Eigen::VectorXd score =
        ScoreAgainstCones(problem, fit, descent ? fit.Descent() : fit.LogScale());
    const std::optional<Index> next = choice->TakeBest(score);
    if (!next) break;
    fit.Add(*next);
    // Before the cones can carry the total within their bounds, the bounds do not count.
    if (!descent || !fit.FitLeastSquares()) fit.FitZeroAtCones();
  }
  if (options_.fit == "least_squares" || !IsAdmissible(problem, fit)) fit.FitLeastSquares();
  return fit.Cones();
}

}  // namespace cirque
