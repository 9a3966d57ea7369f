#include "cirque/layout/convex_embedding.h"

#include <algorithm>
#include <cmath>

#include "cirque/linear/registry.h"

namespace cirque {
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
