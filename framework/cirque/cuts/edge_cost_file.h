#pragma once

#include <string>
#include <string_view>

#include <Eigen/Core>

#include "cirque/core/status.h"
#include "cirque/cuts/cut_file.h"

namespace cirque {

/// A file of edge costs: a line `from to cost` for every edge that is not to cost what its length
/// does: all edges between the vertices `from` and `to`, counted from 1 as in an OBJ file and in
/// either order, cost `cost` (>= 0, finite) times as much. '#' begins a comment, empty lines are
/// skipped. Gives one factor an edge. Errors (invalid input), each with file:line: not two whole
/// numbers and a cost, no such vertex, no such edge, an edge named twice.
StatusOr<Eigen::VectorXd> ParseEdgeCosts(const std::string& path, std::string_view text,
                                         const Triangulation& triangulation,
                                         const std::vector<Index>& vertex_in_file);

StatusOr<Eigen::VectorXd> ReadEdgeCostFile(const std::string& path,
                                           const Triangulation& triangulation,
                                           const std::vector<Index>& vertex_in_file);

}  // namespace cirque
