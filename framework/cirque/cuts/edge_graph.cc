#include "cirque/cuts/edge_graph.h"

#include <numeric>
#include <utility>

#include "cirque/core/counting_sort.h"

namespace cirque {
namespace {

std::vector<Index> EveryVertexItself(Index num_vertices) {
  std::vector<Index> node(num_vertices);
  std::iota(node.begin(), node.end(), 0);
  return node;
}

}  // namespace

EdgeGraph::EdgeGraph(const Triangulation& t) : EdgeGraph(t, EveryVertexItself(t.num_vertices)) {}

EdgeGraph::EdgeGraph(const Triangulation& t, std::vector<Index> node) : node_(std::move(node)) {
  std::vector<Index> end_node;
  end_node.reserve(2 * t.edge_halfedge.size());
  for (const Index h : t.edge_halfedge) {
    ends_.push_back({node_[t.Tail(h)], node_[t.Tip(h)]});
    end_node.insert(end_node.end(), ends_.back().begin(), ends_.back().end());
  }
  Buckets buckets = SortIntoBuckets(end_node, num_nodes());
  first_ = std::move(buckets.first);
  edge_end_ = std::move(buckets.item);
}

}  // namespace cirque
