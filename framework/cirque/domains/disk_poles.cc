#include "cirque/domains/disk_poles.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "cirque/intrinsic/corner_angles.h"
#include "cirque/mesh/holes.h"

namespace cirque {
namespace {

/// How far every edge is from Delaunay in the surface glued to its mirror image [rad].
std::vector<double> DelaunayExcess(const Triangulation& t, const CornerAngles& angles) {
  std::vector<double> excess(t.num_edges(), 0);
  for (Index h = 0; h < t.num_halfedges(); ++h) excess[t.edge[h]] += angles.value[h];
  for (Index e = 0; e < t.num_edges(); ++e) {
    excess[e] = std::max(0.0, excess[e] - (t.IsBoundaryEdge(e) ? 0.5 * kPi : kPi));
  }
  return excess;
}

}  // namespace

std::vector<Index> RankPoles(const IntrinsicSurface& whole, const std::vector<bool>& core) {
  const SubTriangulation part = KeepFaces(whole.triangulation, core);
  const Triangulation& t = part.triangulation;
  CornerAngles angles = {Eigen::VectorXd(t.num_halfedges())};
  for (Index h = 0; h < t.num_halfedges(); ++h) {
    angles.value[h] = whole.angles.value[part.Halfedge(h)];
  }
  const std::vector<double> excess = DelaunayExcess(t, angles);
  std::vector<double> bend(t.num_vertices, -kPi), fault(t.num_vertices, 0);
  for (Index h = 0; h < t.num_halfedges(); ++h) bend[t.vertex[h]] += angles.value[h];
  for (Index e = 0; e < t.num_edges(); ++e) {
    const Index h = t.edge_halfedge[e];
    const double bent = t.IsBoundaryEdge(e) ? 0.5 : 0;
    fault[t.Tail(h)] += excess[e] + bent * (std::abs(bend[t.Tail(h)]) + std::abs(bend[t.Tip(h)]));
    fault[t.Tip(h)] += excess[e] + bent * (std::abs(bend[t.Tail(h)]) + std::abs(bend[t.Tip(h)]));
  }
  std::vector<std::pair<double, Index>> ranked;
  const std::vector<Index> loop = BoundaryLoops(t).front();
  for (const Index h : loop) ranked.emplace_back(fault[t.Tail(h)], part.vertex[t.Tail(h)]);
  std::sort(ranked.begin(), ranked.end());
  std::vector<Index> poles;
  for (const auto& [unused, v] : ranked) poles.push_back(v);
  return poles;
}

}  // namespace cirque
