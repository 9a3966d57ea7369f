#pragma once

#include <array>
#include <utility>
#include <vector>

#include <Eigen/Core>

#include "cirque/core/status.h"
#include "cirque/core/triangulation.h"

namespace cirque {

/// The edges of a triangulation as a graph, whose nodes are classes of vertices: a boundary loop
/// contracted to one node is walked along for free.
class EdgeGraph {
 public:
  /// Every vertex a node.
  explicit EdgeGraph(const Triangulation& triangulation);

  /// `node` gives the class of every vertex, a number below the number of vertices.
  EdgeGraph(const Triangulation& triangulation, std::vector<Index> node);

  Index num_nodes() const { return static_cast<Index>(node_.size()); }
  Index num_edges() const { return static_cast<Index>(ends_.size()); }
  Index Node(Index vertex) const { return node_[vertex]; }
  const std::array<Index, 2>& Ends(Index edge) const { return ends_[edge]; }
  Index Across(Index edge, Index node) const {
    return ends_[edge][0] == node ? ends_[edge][1] : ends_[edge][0];
  }

  /// Visits the edges at a node; those that lead back to it twice.
  template <class Visit>
  void ForEachEdgeAt(Index node, const Visit& visit) const {
    for (Index i = first_[node]; i < first_[node + 1]; ++i) visit(edge_end_[i] / 2);
  }

 private:
  std::vector<Index> node_;
  std::vector<std::array<Index, 2>> ends_;
  std::vector<Index> first_, edge_end_;  // compressed rows of edge ends 2 e and 2 e + 1
};

/// Shortest paths from every node of a graph to the nearest of some sources.
struct ShortestPathForest {
  std::vector<double> distance;  ///< per node; infinity where no source is reached
  std::vector<Index> source;     ///< per node: the source it is nearest to, kNone where none
  std::vector<Index> edge;       ///< per node: the edge towards the source, kNone at a source
};

/// Dijkstra's algorithm from several sources, O(E log E). Costs are one an edge, >= 0; no path leads
/// along an edge of infinite cost.
ShortestPathForest GrowShortestPaths(const EdgeGraph& graph, const Eigen::VectorXd& edge_cost,
                                     const std::vector<Index>& sources);

/// The edges of a shortest path between two vertices, in order from `from` to `to`. Errors (invalid
/// input): a vertex that does not exist, no path.
StatusOr<std::vector<Index>> ShortestPath(const Triangulation& triangulation,
                                          const Eigen::VectorXd& edge_cost, Index from, Index to);

/// The cut along shortest paths between pairs of vertices: what the user of the original program
/// did by clicking on them. Errors as above.
StatusOr<Cut> CutAlongShortestPaths(const Triangulation& triangulation,
                                    const Eigen::VectorXd& edge_cost,
                                    const std::vector<std::pair<Index, Index>>& ends);

}  // namespace cirque
