#include "cirque/cuts/preferring_cuts.h"

#include <cmath>

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

}  // namespace

StatusOr<Eigen::VectorXd> DistortionCuts::EdgeCosts(const CutProblem& problem) const {
  const EdgeLengths& lengths = problem.surface.lengths;
  return Preferring(LogStretch(lengths, problem.flat), lengths);
}

StatusOr<Eigen::VectorXd> CurvatureCuts::EdgeCosts(const CutProblem& problem) const {
  return Preferring(EdgeCurvature(problem.surface), problem.surface.lengths);
}

}  // namespace cirque
