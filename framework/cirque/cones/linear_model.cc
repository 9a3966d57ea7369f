#include "cirque/cones/linear_model.h"

#include <algorithm>
#include <cmath>

namespace cirque {
namespace {

constexpr double kLeastWeight = 1e-8, kGreatestWeight = 1e8;  ///< of an edge
constexpr double kLeastArea = 1e-6;                           ///< of a vertex, in means

double Cotangent(double angle) { return std::cos(angle) / std::max(std::sin(angle), 1e-12); }

}  // namespace

Eigen::VectorXd CotangentWeights(const IntrinsicSurface& surface) {
  const Triangulation& t = surface.triangulation;
  Eigen::VectorXd weight(t.num_edges());
  for (Index e = 0; e < t.num_edges(); ++e) {
    const Index h = t.edge_halfedge[e];
    double sum = Cotangent(surface.angles.value[h]);
    if (t.twin[h] != kNone) sum += Cotangent(surface.angles.value[t.twin[h]]);
    weight[e] = std::clamp(0.5 * sum, kLeastWeight, kGreatestWeight);
  }
  return weight;
}

Eigen::VectorXd VertexAreas(const IntrinsicSurface& surface) {
  const Triangulation& t = surface.triangulation;
  const Eigen::VectorXd& length = surface.lengths.value;
  Eigen::VectorXd area = Eigen::VectorXd::Zero(t.num_vertices);
  for (Index h = 0; h < t.num_halfedges(); ++h) {
    const Index first = h - h % 3;
    area[t.vertex[h]] += length[t.edge[first]] * length[t.edge[first + 1]] *
                         std::sin(surface.angles.value[first + 2]);
  }
  area = area.cwiseMax(kLeastArea * area.mean());
  return area / area.sum();
}

}  // namespace cirque
