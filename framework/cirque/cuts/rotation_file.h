#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "cirque/core/status.h"
#include "cirque/core/triangulation.h"
#include "cirque/cuts/edge_files.h"
#include "cirque/intrinsic/loop_rotations.h"

namespace cirque {

/// Parses a file of rotations along loops, text, '#' starts a comment, a line a loop:
///
///   rotation face face face ...
///
/// the rotation in radians, then the faces that the loop passes, counted from 1 as in the mesh file,
/// each next to the one before it and the first next to the last. The rotation is that of
/// RotationAlong: the angles of the corners that the loop has on its left, less those on its
/// right, modulo 2 pi. (Field tools have the same numbers, in a file of rotations and one of faces.)
///
/// Errors are "path:line: ...": no number, fewer than three faces, no such face or one of more than
/// three corners, faces that have no edge in common, or several, a loop that turns back, a rotation
/// that is not finite.
StatusOr<std::vector<LoopRotation>> ParseRotations(const std::string& path, std::string_view text,
                                                   const Triangulation& triangulation,
                                                   const FileNumbers& numbers);

StatusOr<std::vector<LoopRotation>> ReadRotationFile(const std::string& path,
                                                     const Triangulation& triangulation,
                                                     const FileNumbers& numbers);

}  // namespace cirque
