#pragma once

#include "cirque/core/atomic_file.h"
#include "cirque/io/polygon_soup.h"

namespace cirque {

/// The mesh as Wavefront OBJ: its v lines, its vt lines, then `f v` or `f v/vt`, all in the soup's
/// order.
TextPieces FormatObj(const PolygonSoup& mesh);

}  // namespace cirque
