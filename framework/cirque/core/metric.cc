#include "cirque/core/metric.h"

namespace cirque {

ConeTargets FreeBoundaryTargets(const Triangulation& t) {
  const std::vector<bool> boundary = BoundaryVertices(t);
  const std::vector<Index> corners = CornersPerVertex(t);
  ConeTargets targets;
  for (Index v = 0; v < t.num_vertices; ++v) {
    targets.lower.push_back(boundary[v] ? 0 : 2 * kPi);
    targets.upper.push_back(boundary[v] ? kPi * corners[v] : 2 * kPi);
  }
  return targets;
}

}  // namespace cirque
