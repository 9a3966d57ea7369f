#include "cirque/cones/cone_choice.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include <fmt/format.h>

namespace cirque {
namespace {

constexpr double kSlack = 1e-9;  ///< [rad]

}  // namespace

ConeChoice::ConeChoice(const ConeProblem& problem, int count)
    : problem_(&problem),
      left_(count),
      chosen_(problem.triangulation().num_vertices, false),
      by_capacity_(problem.candidates()) {
  std::stable_sort(by_capacity_.begin(), by_capacity_.end(), [&](Index a, Index b) {
    return problem.LeastCurvature(a) < problem.LeastCurvature(b);
  });
}

/// Whether `left` cones do, whose least curvatures add up to `least`.
bool ConeChoice::CanCarryTotal(double least) const {
  const double total = problem_->TotalCurvature();
  const double greatest = left_ * problem_->GreatestCurvature();
  return !problem_->IsClosed() ||
         (least <= total + kSlack && (left_ > 0 ? greatest >= total - kSlack : total == 0));
}

StatusOr<ConeChoice> ConeChoice::Make(const ConeProblem& problem, int count) {
  const auto most = static_cast<int>(problem.candidates().size());
  ConeChoice choice(problem, std::min(count, most));
  double least = choice.LeastOfOthers(choice.left_, nullptr);
  while (choice.left_ < most && !choice.CanCarryTotal(least)) {
    least += problem.LeastCurvature(choice.by_capacity_[choice.left_++]);
  }
  if (choice.CanCarryTotal(least)) return choice;
  return Status::InvalidInput(
      fmt::format("cones at all {} vertices cannot carry the curvature {:.6g} pi that Gauss-Bonnet "
                  "asks for: subdivide the surface, or give the cones in a file",
                  most, problem.TotalCurvature() / kPi));
}

/// The sum of the `count` least curvatures among the unchosen, and which they are.
double ConeChoice::LeastOfOthers(int count, std::vector<bool>* among) const {
  double sum = 0;
  for (const Index v : by_capacity_) {
    if (count == 0) break;
    if (chosen_[v]) continue;
    sum += problem_->LeastCurvature(v);
    if (among) (*among)[v] = true;
    --count;
  }
  return sum;
}

std::optional<Index> ConeChoice::TakeBest(const Eigen::VectorXd& score) {
  if (left_ == 0) return std::nullopt;
  const double total = problem_->TotalCurvature();
  std::vector<bool> among_best(chosen_.size(), false);
  const double others = LeastOfOthers(left_ - 1, &among_best);
  const double with_next = LeastOfOthers(left_, nullptr);
  Index best = kNone;
  double best_score = -std::numeric_limits<double>::infinity();
  for (const Index v : problem_->candidates()) {
    if (chosen_[v] || !(score[v] > best_score)) continue;
    const double least = among_best[v] ? with_next : problem_->LeastCurvature(v) + others;
    if (problem_->IsClosed() && chosen_least_ + least > total + kSlack) continue;
    best = v;
    best_score = score[v];
  }
  if (best == kNone) return std::nullopt;
  chosen_[best] = true;
  chosen_least_ += problem_->LeastCurvature(best);
  --left_;
  return best;
}

namespace {

constexpr double kNever = -std::numeric_limits<double>::infinity();

}  // namespace

Eigen::VectorXd DistanceFromCones(const ConeProblem& problem, const ConeFit& fit,
                                  const Eigen::VectorXd& field) {
  double level = 0;
  if (problem.IsClosed()) {
    const double total = problem.TotalCurvature();
    level = total > 0 ? field.maxCoeff() : total < 0 ? field.minCoeff() : 0;
    if (fit.size() > 0) level = field(fit.vertices()).mean();
  }
  return (field.array() - level).abs();
}

bool FitAdmissible(const ConeProblem& problem, ConeChoice* choice, ConeFit* fit) {
  Eigen::VectorXd room(problem.triangulation().num_vertices);
  for (const Index v : problem.candidates()) room[v] = -problem.LeastCurvature(v);
  while (!fit->FitLeastSquares()) {
    const std::optional<Index> v = choice->TakeBest(room);
    if (!v) return false;
    fit->Add(*v);
  }
  return true;
}

StatusOr<std::vector<Cone>> ChooseByDescent(const ConeProblem& problem,
                                            const std::vector<bool>& allowed, int count) {
  StatusOr<ConeChoice> choice = ConeChoice::Make(problem, count);
  if (!choice.ok()) return choice.status();
  if (choice->left() == 0) return std::vector<Cone>();
  ConeFit fit(problem);
  while (choice->left() > 0) {
    Eigen::VectorXd score = DistanceFromCones(problem, fit, fit.Descent());
    for (Index v = 0; v < score.size(); ++v) {
      if (!allowed[v]) score[v] = kNever;
    }
    const std::optional<Index> next = choice->TakeBest(score);
    if (!next) break;
    fit.Add(*next);
    // Before the cones can carry the total within their bounds, the bounds do not count.
    if (!fit.FitLeastSquares()) fit.FitZeroAtCones();
  }
  FitAdmissible(problem, &*choice, &fit);
  return fit.Cones();
}

}  // namespace cirque
