#include "cirque/cones/cone_clusters.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "cirque/cones/cone_choice.h"
#include "cirque/cones/cone_fit.h"
#include "cirque/mesh/disjoint_sets.h"

namespace cirque {

std::vector<CurvatureCluster> ClusterCurvature(const Triangulation& t, const Eigen::VectorXd& mu,
                                               double threshold) {
  DisjointSets sets(t.num_vertices);
  for (const Index h : t.edge_halfedge) {
    const double a = mu[t.Tail(h)], b = mu[t.Tip(h)];
    if (std::min(std::abs(a), std::abs(b)) > threshold && a * b > 0) {
      sets.Unite(t.Tail(h), t.Tip(h));
    }
  }
  std::vector<CurvatureCluster> of_root(t.num_vertices);
  for (Index v = 0; v < t.num_vertices; ++v) {
    if (std::abs(mu[v]) <= threshold) continue;
    CurvatureCluster& cluster = of_root[sets.Find(v)];
    cluster.curvature += mu[v];
    if (cluster.vertex == kNone || std::abs(mu[v]) > std::abs(mu[cluster.vertex])) {
      cluster.vertex = v;
    }
  }
  std::erase_if(of_root, [](const CurvatureCluster& c) { return c.vertex == kNone; });
  std::stable_sort(of_root.begin(), of_root.end(), [](const auto& a, const auto& b) {
    return std::abs(a.curvature) > std::abs(b.curvature);
  });
  return of_root;
}

StatusOr<std::vector<Cone>> ConesAtClusters(const ConeProblem& problem,
                                            const std::vector<CurvatureCluster>& clusters,
                                            int count) {
  StatusOr<ConeChoice> choice = ConeChoice::Make(problem, count);
  if (!choice.ok()) return choice.status();
  const Index num_vertices = problem.triangulation().num_vertices;
  const double nothing = -std::numeric_limits<double>::infinity();
  Eigen::VectorXd score = Eigen::VectorXd::Constant(num_vertices, nothing);
  for (const CurvatureCluster& c : clusters) score[c.vertex] = std::abs(c.curvature);
  ConeFit fit(problem);
  while (const std::optional<Index> v = choice->TakeBest(score)) fit.Add(*v);
  if (choice->left() == count || fit.FitLeastSquares()) {
    if (fit.size() > 0 || !problem.IsClosed() || problem.TotalCurvature() == 0) return fit.Cones();
  }
  for (const Index v : problem.candidates()) score[v] = -problem.LeastCurvature(v);
  while (!fit.FitLeastSquares()) {
    const std::optional<Index> v = choice->TakeBest(score);
    if (!v) break;
    fit.Add(*v);
  }
  return fit.Cones();
}

}  // namespace cirque
