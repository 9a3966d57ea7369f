#pragma once

#include <utility>
#include <vector>

#include <Eigen/Core>

#include "cirque/core/cut.h"
#include "cirque/core/status.h"
#include "cirque/cuts/edge_graph.h"

namespace cirque {

/// Shortest paths from every node of a graph to the nearest of some sources.
struct ShortestPathForest {
  std::vector<double> distance;  ///< per node; infinity where no source is reached
  std::vector<Index> source;     ///< per node: the source it is nearest to, kNone where none
  std::vector<Index> edge;       ///< per node: the edge towards the source, kNone at a source
};

/// Dijkstra's algorithm from several sources, O(E log E). Costs are one an edge, finite and >= 0.
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
