#pragma once

#include "cirque/core/atomic_file.h"
#include "cirque/io/polygon_soup.h"

namespace cirque {

/// The mesh as text PLY with double coordinates, without texture coordinates.
TextPieces FormatPly(const PolygonSoup& mesh);

}  // namespace cirque
