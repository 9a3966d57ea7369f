#include "cirque/energy/angle_constraints.h"

#include <glog/logging.h>

#include "cirque/core/parallel.h"

namespace cirque {

AngleConstraints::AngleConstraints(const Triangulation& t, const ConeTargets& targets)
    : triangulation_(t),
      num_faces_(t.num_faces()),
      corners_(CornersPerVertex(t)),
      row_of_vertex_(t.num_vertices, kNone),
      lower_(num_faces_, kPi),
      upper_(num_faces_, kPi) {
  CHECK_EQ(static_cast<int>(targets.lower.size()), t.num_vertices);
  CHECK_EQ(static_cast<int>(targets.upper.size()), t.num_vertices);
  for (Index v = 0; v < t.num_vertices; ++v) {
    if (targets.lower[v] <= 0 && targets.upper[v] >= kPi * corners_[v]) continue;
    row_of_vertex_[v] = num_rows();
    constrained_vertices_.push_back(v);
    lower_.push_back(targets.lower[v]);
    upper_.push_back(targets.upper[v]);
  }
}

void AngleConstraints::Apply(const Eigen::VectorXd& alpha, Eigen::Ref<Eigen::VectorXd> sums) const {
  ParallelFor(num_faces_, [&](Index f) { sums[f] = alpha.segment<3>(3 * f).sum(); });
  sums.tail(num_rows() - num_faces_).setZero();
  for (Index h = 0; h < triangulation_.num_halfedges(); ++h) {
    if (const int row = VertexRow(h); row != kNone) sums[row] += alpha[h];
  }
}

Eigen::VectorXd AngleConstraints::Apply(const Eigen::VectorXd& alpha) const {
  Eigen::VectorXd sums(num_rows());
  Apply(alpha, sums);
  return sums;
}

}  // namespace cirque
