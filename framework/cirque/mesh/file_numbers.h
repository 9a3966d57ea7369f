#pragma once

#include <string>
#include <vector>

#include "cirque/core/types.h"
#include "cirque/mesh/surface.h"

namespace cirque {

/// Messages of the library number vertices and faces as its arrays do and say so:
///   "vertex 3 (0-based)", "faces 2, 5 and 40 more (0-based)", "vertices 3 and 5 (0-based)".
/// People look into their file. This is the message with the numbers of the file instead, from 1:
/// those of the surface's vertices and of the polygons that its faces are parts of. Numbers that are
/// none of the surface's stay, with their "(0-based)".
std::string NumberedAsInFile(const Surface& surface, const std::string& message);

/// The same where the file's order is the arrays' own.
std::string NumberedFromOne(const std::string& message);

}  // namespace cirque
