#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <Eigen/Core>

#include "cirque/core/status.h"
#include "cirque/core/triangulation.h"
#include "cirque/mesh/surface.h"

namespace cirque {

/// The numbers that vertices and faces bear in the mesh file, counted from 0. Triangles that were
/// split off one polygon bear its number; numbers of faces do not decrease.
struct FileNumbers {
  std::vector<Index> vertex, face;
  std::vector<bool> inside = {};  ///< E: edges inside a face, which the file has not; empty: none

  bool IsInside(Index edge) const { return !inside.empty() && inside[edge]; }
};

FileNumbers NumbersInFile(const Surface& surface);

/// Of a triangulation that is a file of its own (CON).
FileNumbers OwnNumbers(const Triangulation& triangulation);

/// The edge-cut file of Kharevych's thesis: a line `from to face` for every opened edge: the edge
/// from vertex `from` to vertex `to` of `face`, which lies to its left. The face tells edges apart
/// that join the same vertices, as in a CON file. Vertices and faces are counted from 1, as in an
/// OBJ file. A face to the right of the edge is understood where none on the left is meant (the
/// file's faces may be oriented either way). '#' begins a comment, empty lines are skipped.
/// Errors (invalid input), each with file:line: not three whole numbers, a vertex or face that does
/// not exist, a face without that edge or in which the two vertices are not next to each other, an
/// edge given twice, a boundary edge.
StatusOr<Cut> ParseCut(const std::string& path, std::string_view text,
                       const Triangulation& triangulation, const FileNumbers& numbers);

StatusOr<Cut> ReadCutFile(const std::string& path, const Triangulation& triangulation,
                          const FileNumbers& numbers);

/// The text of such a file.
std::string FormatCut(const Triangulation& triangulation, const FileNumbers& numbers,
                      const Cut& cut);

/// Writes the file whole or not at all.
Status WriteCutFile(const std::string& path, const Triangulation& triangulation,
                    const FileNumbers& numbers, const Cut& cut);

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
