#pragma once

#include "cirque/core/atomic_file.h"
#include "cirque/io/polygon_soup.h"

namespace cirque {

/// The mesh as text OFF, without texture coordinates.
TextPieces FormatOff(const PolygonSoup& mesh);

}  // namespace cirque
