#include "cirque/layout/linear_layout.h"

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
    const Eigen::Vector2d pull = cotangent * open.TargetVector(h);
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
  return LayoutAt(open, open.TargetVectors(), position);
}

namespace {

constexpr double kLeastWeight = 1e-2, kLargestWeight = 1e4;

}  // namespace

Eigen::VectorXd PositiveCotangents(const Triangulation& t, const CornerAngles& angles) {
  Eigen::VectorXd weights = Eigen::VectorXd::Zero(t.num_edges());
  for (Index h = 0; h < t.num_halfedges(); ++h) {
    weights[t.edge[h]] += std::cos(angles.value[h]) / std::sin(angles.value[h]);
  }
  return weights.unaryExpr([](double w) {
    return std::isfinite(w) ? std::clamp(w, kLeastWeight, kLargestWeight) : kLeastWeight;
  });
}

Status EmbedConvexly(const Triangulation& t, const Eigen::VectorXd& edge_weights,
                     const std::vector<bool>& fixed, std::vector<Eigen::Vector2d>* position) {
  std::vector<Index> unknown(t.num_vertices, kNone);
  Index count = 0;
  for (Index v = 0; v < t.num_vertices; ++v) {
    if (!fixed[v]) unknown[v] = count++;
  }
  if (count == 0) return Status();
  std::vector<Eigen::Triplet<double>> entries;
  Eigen::MatrixX2d right_side = Eigen::MatrixX2d::Zero(count, 2);
  const auto add_end = [&](Index v, Index w, double weight) {
    if (unknown[v] == kNone) return;
    entries.emplace_back(unknown[v], unknown[v], weight);
    if (unknown[w] == kNone) right_side.row(unknown[v]) += weight * (*position)[w].transpose();
    if (unknown[w] < unknown[v] && unknown[w] != kNone) {
      entries.emplace_back(unknown[v], unknown[w], -weight);
    }
  };
  for (Index e = 0; e < t.num_edges(); ++e) {
    const Index a = t.Tail(t.edge_halfedge[e]), b = t.Tip(t.edge_halfedge[e]);
    add_end(a, b, edge_weights[e]);
    add_end(b, a, edge_weights[e]);
  }
  SparseMatrix lower(count, count);
  lower.setFromTriplets(entries.begin(), entries.end());
  const auto cholesky = MakeCholesky();
  if (!cholesky->Factorize(lower)) {
    return Status(
        StatusCode::kNotConverged,
        "the convex embedding's matrix is singular to rounding; a vertex is joined to the "
        "boundary by nothing but edges of extreme lengths");
  }
  for (int k = 0; k < 2; ++k) {
    const Eigen::VectorXd x = cholesky->Solve(right_side.col(k));
    for (Index v = 0; v < t.num_vertices; ++v) {
      if (unknown[v] != kNone) (*position)[v][k] = x[unknown[v]];
    }
  }
  return Status();
}

}  // namespace cirque
