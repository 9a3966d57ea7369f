#pragma once

#include <string>
#include <string_view>

#include "cirque/core/atomic_file.h"
#include "cirque/core/status.h"
#include "cirque/io/polygon_soup.h"

namespace cirque {

/// Parses Wavefront OBJ: text, a statement a line, '#' starts a comment.
///
///   v x y z            a point; weights and colours after it are ignored
///   vt u [v]           a texture coordinate, v = 0 where it is left out
///   f c c c ...        a polygon of three corners or more, each of them one of
///                        v   v/vt   v//vn   v/vt/vn
///   (any other word)   ignored, normals among them
///
/// Indices count from 1, or backwards from the latest (-1) when negative; they may refer to later
/// lines. A backslash at the end of a line joins the next one to it.
///
/// Errors are "path:line: ..." and say what was expected: a coordinate that is no number, a corner
/// that is none, a face of fewer than three, an index of 0, before the first or beyond the last.
StatusOr<PolygonSoup> ParseObj(const std::string& path, std::string_view text);

/// The mesh as Wavefront OBJ: its v lines, its vt lines, then `f v` or `f v/vt`, all in the soup's
/// order.
TextPieces FormatObj(const PolygonSoup& mesh);

}  // namespace cirque
