#pragma once

#include <utility>
#include <vector>

#include <Eigen/Core>

#include "cirque/core/types.h"

/// Where the boundary of a mesh lies on itself without being joined there.
namespace cirque {

/// Edges of a boundary by the numbers of their ends.
using BoundaryEdges = std::vector<std::pair<Index, Index>>;

/// The vertices that are ends of `edges` and lie inside another of them: no further from it than
/// 1e-9 of its length, and from its ends further than that. Increasing. O(n log n) where edges do
/// not crowd.
std::vector<Index> FindTJunctions(const std::vector<Eigen::Vector3d>& points,
                                  const BoundaryEdges& edges);

/// The number of `edges` whose two ends lie where those of another one do.
Index CountCoincidentEdges(const std::vector<Eigen::Vector3d>& points, const BoundaryEdges& edges);

}  // namespace cirque
