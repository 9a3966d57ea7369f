#pragma once

#include <string>
#include <string_view>

#include "cirque/core/atomic_file.h"
#include "cirque/core/status.h"
#include "cirque/io/polygon_soup.h"

namespace cirque {

/// Parses text OFF; '#' starts a comment.
///
///   OFF                  or COFF, NOFF, STOFF and their mixtures
///   V F [E]              numbers of vertices, faces and edges, also behind the keyword
///   x y z ...            V lines; normals, colours and texture coordinates behind are ignored
///   n v_1 ... v_n ...    F lines: vertices counted from 0; colours behind are ignored
///
/// Errors are "path:line: ...": no keyword, a number that is missing or none, fewer than three
/// corners, a vertex that does not exist, fewer or more lines than the header promises.
StatusOr<PolygonSoup> ParseOff(const std::string& path, std::string_view text);

/// The mesh as text OFF, without texture coordinates.
TextPieces FormatOff(const PolygonSoup& mesh);

}  // namespace cirque
