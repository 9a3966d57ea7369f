#include "cirque/pipeline/cut_costs.h"

#include <algorithm>
#include <cmath>
#include <memory>

#include "cirque/cuts/edge_files.h"
#include "cirque/cuts/registry.h"
#include "cirque/mesh/visibility.h"

namespace cirque {
namespace {

/// Over the square root of the area the lengths of the cut's edges, each times share(edge).
template <class Share>
double SumOverCut(const IntrinsicSurface& surface, const Cut& cut, const Share& share) {
  const Triangulation& t = surface.triangulation;
  double length = 0;
  for (Index e = 0; e < t.num_edges(); ++e) {
    if (cut.edge[e] && !t.IsBoundaryEdge(e)) length += surface.lengths.value[e] * share(e);
  }
  return length / std::sqrt(SurfaceArea(surface));
}

constexpr int kDirections = 64;
constexpr int kLooks = 4096;   ///< at the edges of a cut, from all directions together, at least
constexpr int kMostParts = 8;  ///< of the directions

}  // namespace

StatusOr<Eigen::VectorXd> CutCosts(const CutProblem& problem, const ParameterizeOptions& options,
                                   const std::vector<Index>& vertex_in_file) {
  StatusOr<std::shared_ptr<const CutHeuristic>> heuristic = options.own_cut;
  if (!options.own_cut) heuristic = ParseCutHeuristic(options.cut_cost);
  if (!heuristic.ok()) return heuristic.status();
  const StatusOr<Eigen::VectorXd> costs = (*heuristic)->EdgeCosts(problem);
  if (!costs.ok() || options.edge_costs.empty()) return costs;
  const auto factors =
      ReadEdgeCostFile(options.edge_costs, problem.surface.triangulation, vertex_in_file);
  if (!factors.ok()) return factors.status();
  return Eigen::VectorXd(costs->cwiseProduct(*factors));
}

double RelativeCutLength(const IntrinsicSurface& surface, const Cut& cut) {
  return cut.IsEmpty() ? 0 : SumOverCut(surface, cut, [](Index) { return 1; });
}

double VisibleCutLength(const IntrinsicSurface& surface,
                        const std::vector<Eigen::Vector3d>& position, const Cut& cut) {
  if (cut.IsEmpty()) return 0;
  const Visibility visibility(surface.triangulation, position, kDirections);
  // Of a long cut a part of the directions for each edge, other ones for the next, which add up to the
  // same.
  const auto edges = std::count(cut.edge.begin(), cut.edge.end(), true);
  const int parts = std::clamp(static_cast<int>(edges) * kDirections / kLooks, 1, kMostParts);
  return SumOverCut(surface, cut, [&](Index e) { return visibility.Of(e, e % parts, parts); });
}

}  // namespace cirque
