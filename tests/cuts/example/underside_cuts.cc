#include "tests/cuts/example/underside_cuts.h"

#include <algorithm>

namespace cirque {

const OptionTable<UndersideOptions>& UndersideOptionTable() {
  using O = UndersideOptions;
  static const OptionTable<O> kTable(
      "underside", {Option<O>("weight", &O::weight, "of what lies highest").Between(0, 1e6)});
  return kTable;
}

StatusOr<Eigen::VectorXd> UndersideCuts::EdgeCosts(const CutProblem& problem) const {
  if (!problem.position) return Status::InvalidInput("underside: a metric has no points");
  const Triangulation& t = problem.surface.triangulation;
  const auto height = [&](Index v) { return (*problem.position)[v].z(); };
  double least = height(0), greatest = height(0);
  for (Index v = 0; v < t.num_vertices; ++v) {
    least = std::min(least, height(v)), greatest = std::max(greatest, height(v));
  }
  Eigen::VectorXd costs = problem.surface.lengths.value;
  for (Index e = 0; e < t.num_edges(); ++e) {
    const Index h = t.edge_halfedge[e];
    const double above = 0.5 * (height(t.Tail(h)) + height(t.Tip(h))) - least;
    costs[e] *= 1 + options_.weight * above / std::max(greatest - least, 1e-300);
  }
  return costs;
}

}  // namespace cirque
