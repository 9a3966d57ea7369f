#pragma once

#include "cirque/domains/domain.h"

namespace cirque {

/// The power of two that a surface's largest coordinate has, where squares of its lengths, or their
/// products, would leave the range of doubles (beyond 2^300, below 2^-300); 0 otherwise.
int ExtremeExponent(const Surface& surface);

/// The surface 2^exponent times as large, exactly.
Surface Scaled(Surface surface, int exponent);

/// The same for a map that is as large as its surface: texture coordinates, flat lengths, radii.
void ScaleMap(int exponent, SurfaceMap* map);

}  // namespace cirque
