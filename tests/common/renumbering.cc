#include "tests/common/renumbering.h"

#include <algorithm>
#include <numeric>
#include <random>
#include <utility>

namespace cirque {
namespace {

std::vector<Index> RandomPermutation(Index n, std::mt19937* random) {
  std::vector<Index> permutation(n);
  std::iota(permutation.begin(), permutation.end(), 0);
  std::shuffle(permutation.begin(), permutation.end(), *random);
  return permutation;
}

}  // namespace

Renumbering Renumber(const Triangulation& t, unsigned seed) {
  std::mt19937 random(seed);
  Renumbering r;
  r.vertex = RandomPermutation(t.num_vertices, &random);
  const std::vector<Index> face = RandomPermutation(t.num_faces(), &random);
  r.halfedge.resize(t.num_halfedges());
  for (Index f = 0; f < t.num_faces(); ++f) {
    const auto turn = static_cast<Index>(random() % 3);
    for (Index k = 0; k < 3; ++k) r.halfedge[3 * f + k] = 3 * face[f] + (k + turn) % 3;
  }
  std::vector<Index> vertex(t.num_halfedges()), twin(t.num_halfedges(), kNone);
  for (Index h = 0; h < t.num_halfedges(); ++h) {
    vertex[r.halfedge[h]] = r.vertex[t.vertex[h]];
    if (t.twin[h] != kNone) twin[r.halfedge[h]] = r.halfedge[t.twin[h]];
  }
  r.triangulation = NumberEdges(t.num_vertices, std::move(vertex), std::move(twin));
  return r;
}

EdgeLengths Renumbering::Lengths(const Triangulation& from, const EdgeLengths& lengths) const {
  EdgeLengths renumbered = {Eigen::VectorXd(lengths.value.size())};
  for (Index e = 0; e < from.num_edges(); ++e) {
    renumbered.value[triangulation.edge[halfedge[from.edge_halfedge[e]]]] = lengths.value[e];
  }
  return renumbered;
}

ConeTargets Renumbering::Targets(const ConeTargets& targets) const {
  ConeTargets renumbered = targets;
  for (std::size_t v = 0; v < vertex.size(); ++v) {
    renumbered.lower[vertex[v]] = targets.lower[v];
    renumbered.upper[vertex[v]] = targets.upper[v];
  }
  return renumbered;
}

Eigen::VectorXd Renumbering::PerHalfedge(const Eigen::VectorXd& values) const {
  Eigen::VectorXd renumbered(values.size());
  for (Index h = 0; h < values.size(); ++h) renumbered[halfedge[h]] = values[h];
  return renumbered;
}

}  // namespace cirque
