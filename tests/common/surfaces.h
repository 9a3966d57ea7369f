#pragma once

#include <string>

#include "cirque/core/metric.h"
#include "cirque/mesh/surface.h"

namespace cirque {

/// A generator's mesh as a surface.
Surface GeneratedSurface(const std::string& generator, Index triangles, unsigned seed = 1);

/// A vertex in the middle of n triangles whose outer vertices lie at the given angle steps around
/// it (they need not add up to 2 pi: the apex is lifted), radius 1.
Surface Fan(int n, double height);

/// The flat rectangle [0, columns] x [0, rows] of unit squares, vertex (i, j) being number j
/// (columns + 1) + i. Diagonals pass through points of even i + j: with an even number of rows and
/// columns all corners have two triangles.
Surface FlatStrip(int columns, int rows);

/// Every face split into three by a vertex at its centroid.
Surface Kleetope(const Surface& surface);

/// The surface's corner angles [rad].
CornerAngles AnglesOf(const Surface& surface);

}  // namespace cirque
