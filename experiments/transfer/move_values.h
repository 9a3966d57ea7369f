#pragma once

#include <string>

#include <Eigen/Core>

#include "cirque/core/status.h"

#include "experiments/transfer/map_file.h"

namespace cirque {

/// A table of numbers: a line for every row, blanks between numbers, '#' before comments. Errors
/// (invalid input) with file:line: no number, a row of another length than the first.
StatusOr<Eigen::MatrixXd> ReadValues(const std::string& path);

/// Writes one, in the fewest digits that read back to the same bits.
Status WriteValues(const std::string& path, const Eigen::MatrixXd& values);

/// Values of the vertices of `from`, a row each, at those of `to`: linear on the triangles of `from`.
/// Vertices of `to` in no face have what `from` has for those of that number, or 0.
Eigen::MatrixXd MoveVertexValues(const MapFile& from, const Eigen::MatrixXd& values,
                                 const MapFile& to);

/// Values of the faces of `from`, a row each, for those of `to`. A piece of an exact map has that of
/// the face or piece where its middle is; a face of the mesh the mean over the surface of what its
/// pieces have, by their areas.
Eigen::MatrixXd MoveFaceValues(const MeshOfMaps& of, const MapFile& from,
                               const Eigen::MatrixXd& values, const MapFile& to);

}  // namespace cirque
