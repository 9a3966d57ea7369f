#include "cirque/cuts/visibility_cuts.h"

#include "cirque/core/parallel.h"
#include "cirque/mesh/visibility.h"

namespace cirque {

const OptionTable<VisibilityOptions>& VisibilityOptionTable() {
  using O = VisibilityOptions;
  static const OptionTable<O> kTable(
      "visibility", {Option<O>("directions", &O::directions, "from which the surface is looked at")
                         .Between(1, 4096)});
  return kTable;
}

StatusOr<Eigen::VectorXd> VisibilityCuts::EdgeCosts(const CutProblem& problem) const {
  const Triangulation& t = problem.surface.triangulation;
  if (!problem.position) {
    return Status::InvalidInput(
        "visibility looks at a surface in space, and a metric has no points; choose another "
        "cut_cost");
  }
  const Visibility visibility(t, *problem.position, options_.directions);
  const double unseen = 0.5 / options_.directions;
  Eigen::VectorXd costs(t.num_edges());
  ParallelFor(t.num_edges(), [&](Index e) {
    costs[e] = problem.surface.lengths.value[e] * (visibility.Of(e) + unseen);
  });
  return costs;
}

}  // namespace cirque
