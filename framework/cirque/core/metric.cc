#include "cirque/core/metric.h"

#include <vector>

#include <glog/logging.h>

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

namespace {

/// Sum of the angles minus pi F, summed as curvatures in units of pi: those of flat vertices are
/// exactly 0 and multiples of pi/2 add up without rounding.
double Excess(const std::vector<double>& angles, const Triangulation& t) {
  double sum = 0;
  for (const double angle : angles) sum += angle / kPi - 2;
  return kPi * (sum + (2. * t.num_vertices - t.num_faces()));
}

}  // namespace

GaussBonnetDefect MeasureGaussBonnetDefect(const Triangulation& t, const ConeTargets& targets) {
  CHECK_EQ(static_cast<Index>(targets.lower.size()), t.num_vertices);
  CHECK_EQ(static_cast<Index>(targets.upper.size()), t.num_vertices);
  return {Excess(targets.lower, t), Excess(targets.upper, t)};
}

}  // namespace cirque
