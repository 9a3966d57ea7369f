#include "cirque/layout/poisson_layout.h"

#include <algorithm>
#include <cmath>

#include "cirque/linear/registry.h"

namespace cirque {
namespace {

/// The number of every vertex among the unknowns; kNone for the first vertex of each patch.
struct Unknowns {
  std::vector<Index> of_vertex;
  Index count = 0;
};

Unknowns NumberUnknowns(const OpenSurface& open) {
  const Triangulation& t = open.triangulation;
  std::vector<bool> pinned(t.num_vertices, false), patch_seen(open.patches.count, false);
  for (Index f = 0; f < t.num_faces(); ++f) {
    const Index patch = open.patches.of_face[f];
    if (!patch_seen[patch]) pinned[t.vertex[3 * f]] = true;
    patch_seen[patch] = true;
  }
  Unknowns unknowns;
  for (Index v = 0; v < t.num_vertices; ++v) {
    unknowns.of_vertex.push_back(pinned[v] ? kNone : unknowns.count++);
  }
  return unknowns;
}

/// The normal equations A p = b, A by its lower triangle.
struct NormalEquations {
  SparseMatrix lower;
  Eigen::MatrixX2d right_side;
};

NormalEquations Assemble(const OpenSurface& open, const CornerAngles& angles,
                         const Unknowns& unknowns) {
  const Triangulation& t = open.triangulation;
  NormalEquations equations = {SparseMatrix(unknowns.count, unknowns.count),
                               Eigen::MatrixX2d::Zero(unknowns.count, 2)};
  std::vector<Eigen::Triplet<double>> entries;
  const auto add_end = [&](Index i, double weight, const Eigen::Vector2d& pull) {
    if (i == kNone) return;
    entries.emplace_back(i, i, weight);
    equations.right_side.row(i) += pull.transpose();
  };
  for (Index h = 0; h < t.num_halfedges(); ++h) {
    const double cotangent = std::cos(angles.value[h]) / std::sin(angles.value[h]);
    const Index i = unknowns.of_vertex[t.Tail(h)], j = unknowns.of_vertex[t.Tip(h)];
    const Eigen::Vector2d pull = cotangent * open.Wanted(h);
    add_end(i, cotangent, -pull);
    add_end(j, cotangent, pull);
    if (i != kNone && j != kNone) {
      entries.emplace_back(std::max(i, j), std::min(i, j), -cotangent);
    }
  }
  equations.lower.setFromTriplets(entries.begin(), entries.end());
  return equations;
}

}  // namespace

StatusOr<PlanarLayout> LayOutByLeastSquares(const Triangulation& t, const CornerAngles& flat_angles,
                                            const EdgeLengths& lengths, const Cut& cut) {
  const OpenSurface open = OpenWithDirections(t, flat_angles, lengths, cut);
  const Unknowns unknowns = NumberUnknowns(open);
  const NormalEquations equations = Assemble(open, flat_angles, unknowns);
  const auto cholesky = MakeCholesky();
  if (!cholesky->Factorize(equations.lower)) {
    return Status(StatusCode::kNotConverged,
                  "least-squares layout: its matrix is not positive definite in floating point "
                  "(corner angles near 0 or pi); lay out by directions instead");
  }
  const Eigen::VectorXd x = cholesky->Solve(equations.right_side.col(0));
  const Eigen::VectorXd y = cholesky->Solve(equations.right_side.col(1));
  std::vector<Eigen::Vector2d> position;
  for (const Index i : unknowns.of_vertex) {
    position.push_back(i == kNone ? Eigen::Vector2d(0, 0) : Eigen::Vector2d(x[i], y[i]));
  }
  return LayoutAt(open, position);
}

}  // namespace cirque
