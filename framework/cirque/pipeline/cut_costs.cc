#include "cirque/pipeline/cut_costs.h"

#include <cmath>

#include "cirque/core/text.h"
#include "cirque/cuts/edge_files.h"
#include "cirque/intrinsic/intrinsic_surface.h"

namespace cirque {
namespace {

/// The lengths, cheap where `field` (>= 0, E) is large.
Eigen::VectorXd Preferring(const Eigen::VectorXd& field, const EdgeLengths& lengths) {
  const double mean = field.mean();
  if (!(mean > 0)) return lengths.value;
  return lengths.value.array() / (1 + field.array() / mean);
}

Eigen::VectorXd LogStretch(const EdgeLengths& lengths, const EdgeLengths& flat) {
  const Eigen::ArrayXd u = (flat.value.array() / lengths.value.array()).log();
  return (u - u.mean()).abs();
}

Eigen::VectorXd EdgeCurvature(const IntrinsicSurface& surface) {
  const Triangulation& t = surface.triangulation;
  Eigen::VectorXd curvature = Eigen::VectorXd::Constant(t.num_vertices, 2 * kPi);
  for (Index h = 0; h < t.num_halfedges(); ++h) curvature[t.vertex[h]] -= surface.angles.value[h];
  Eigen::VectorXd of_edge(t.num_edges());
  const auto at = [&](Index v) { return surface.boundary[v] ? 0 : std::abs(curvature[v]); };
  for (Index e = 0; e < t.num_edges(); ++e) {
    const Index h = t.edge_halfedge[e];
    of_edge[e] = 0.5 * (at(t.Tail(h)) + at(t.Tip(h)));
  }
  return of_edge;
}

Eigen::VectorXd CostsBy(const IntrinsicSurface& surface, const EdgeLengths& flat, CutCost cost) {
  const EdgeLengths& lengths = surface.lengths;
  switch (cost) {
    case CutCost::kFlatLength:
      return flat.value;
    case CutCost::kLength:
      return lengths.value;
    case CutCost::kDistortion:
      return Preferring(LogStretch(lengths, flat), lengths);
    case CutCost::kCurvature:
      return Preferring(EdgeCurvature(surface), lengths);
  }
  return flat.value;
}

}  // namespace

StatusOr<Eigen::VectorXd> CutCosts(const IntrinsicSurface& surface, const EdgeLengths& flat,
                                   const ParameterizeOptions& options,
                                   const std::vector<Index>& vertex_in_file) {
  const Eigen::VectorXd costs = CostsBy(surface, flat, options.cut_cost);
  if (options.edge_costs.empty()) return costs;
  const auto factors = ReadEdgeCostFile(options.edge_costs, surface.triangulation, vertex_in_file);
  if (!factors.ok()) return factors.status();
  return Eigen::VectorXd(costs.cwiseProduct(*factors));
}

double RelativeCutLength(const IntrinsicSurface& surface, const Cut& cut) {
  if (cut.IsEmpty()) return 0;
  const Triangulation& t = surface.triangulation;
  double length = 0;
  for (Index e = 0; e < t.num_edges(); ++e) {
    if (cut.edge[e] && !t.IsBoundaryEdge(e)) length += surface.lengths.value[e];
  }
  return length / std::sqrt(SurfaceArea(surface));
}

}  // namespace cirque
