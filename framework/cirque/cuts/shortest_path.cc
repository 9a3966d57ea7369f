#include "cirque/cuts/shortest_path.h"

#include <algorithm>
#include <functional>
#include <limits>
#include <numeric>
#include <queue>
#include <utility>

#include <fmt/format.h>
#include <glog/logging.h>

#include "cirque/core/grouping.h"

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

ShortestPathForest GrowShortestPaths(const EdgeGraph& graph, const Eigen::VectorXd& edge_cost,
                                     const std::vector<Index>& sources) {
  CHECK_EQ(edge_cost.size(), graph.num_edges());
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  ShortestPathForest forest = {std::vector<double>(graph.num_nodes(), kInfinity),
                               std::vector<Index>(graph.num_nodes(), kNone),
                               std::vector<Index>(graph.num_nodes(), kNone)};
  using Entry = std::pair<double, Index>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
  for (const Index s : sources) {
    forest.distance[s] = 0;
    forest.source[s] = s;
    queue.emplace(0, s);
  }
  while (!queue.empty()) {
    const auto [distance, n] = queue.top();
    queue.pop();
    if (distance > forest.distance[n]) continue;
    graph.ForEachEdgeAt(n, [&, d = distance, n = n](Index e) {
      const Index m = graph.Across(e, n);
      if (!(d + edge_cost[e] < forest.distance[m])) return;
      forest.distance[m] = d + edge_cost[e];
      forest.source[m] = forest.source[n];
      forest.edge[m] = e;
      queue.emplace(forest.distance[m], m);
    });
  }
  return forest;
}

namespace {

Status RequireVertex(const Triangulation& t, Index v) {
  if (v >= 0 && v < t.num_vertices) return Status();
  return Status::InvalidInput(fmt::format(
      "there is no vertex {} (0-based): the surface has {} vertices", v, t.num_vertices));
}

StatusOr<std::vector<Index>> PathInGraph(const EdgeGraph& graph, const Eigen::VectorXd& edge_cost,
                                         Index from, Index to) {
  const ShortestPathForest forest = GrowShortestPaths(graph, edge_cost, {to});
  if (forest.source[from] == kNone) {
    return Status::InvalidInput(
        fmt::format("no path of edges joins the vertices {} and {} (0-based)", from, to));
  }
  std::vector<Index> path;
  for (Index n = from; n != to; n = graph.Across(path.back(), n)) path.push_back(forest.edge[n]);
  return path;
}

}  // namespace

StatusOr<std::vector<Index>> ShortestPath(const Triangulation& t, const Eigen::VectorXd& edge_cost,
                                          Index from, Index to) {
  for (const Index v : {from, to}) {
    if (Status s = RequireVertex(t, v); !s.ok()) return s;
  }
  return PathInGraph(EdgeGraph(t), edge_cost, from, to);
}

StatusOr<Cut> CutAlongShortestPaths(const Triangulation& t, const Eigen::VectorXd& edge_cost,
                                    const std::vector<std::pair<Index, Index>>& ends) {
  const EdgeGraph graph(t);
  Cut cut = {std::vector<bool>(t.num_edges(), false)};
  for (const auto& [from, to] : ends) {
    for (const Index v : {from, to}) {
      if (Status s = RequireVertex(t, v); !s.ok()) return s;
    }
    const StatusOr<std::vector<Index>> path = PathInGraph(graph, edge_cost, from, to);
    if (!path.ok()) return path.status();
    for (const Index e : *path) cut.edge[e] = !t.IsBoundaryEdge(e);
  }
  return cut;
}

}  // namespace cirque
