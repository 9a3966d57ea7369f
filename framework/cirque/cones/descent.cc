#include "cirque/cones/descent.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "cirque/cones/cone_choice.h"
#include "cirque/core/disjoint_sets.h"

namespace cirque {
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

StatusOr<std::vector<Cone>> PlaceByDescent(const ConeProblem& problem,
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
  Eigen::VectorXd room(problem.triangulation().num_vertices);
  for (const Index v : problem.candidates()) room[v] = -problem.LeastCurvature(v);
  while (!fit.FitLeastSquares()) {
    const std::optional<Index> v = choice->TakeBest(room);
    if (!v) break;
    fit.Add(*v);
  }
  return fit.Cones();
}

std::vector<bool> Support(const Eigen::VectorXd& mu, double threshold) {
  std::vector<bool> support(mu.size());
  for (Eigen::Index v = 0; v < mu.size(); ++v) support[v] = std::abs(mu[v]) > threshold;
  return support;
}

int NumClusters(const Triangulation& t, const Eigen::VectorXd& mu, double threshold) {
  DisjointSets sets(t.num_vertices);
  for (const Index h : t.edge_halfedge) {
    const double a = mu[t.Tail(h)], b = mu[t.Tip(h)];
    if (std::min(std::abs(a), std::abs(b)) > threshold && a * b > 0) {
      sets.Unite(t.Tail(h), t.Tip(h));
    }
  }
  int count = 0;
  for (Index v = 0; v < t.num_vertices; ++v) {
    if (std::abs(mu[v]) > threshold && sets.Find(v) == v) ++count;
  }
  return count;
}

}  // namespace cirque
