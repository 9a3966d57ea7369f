#pragma once

#include <string_view>

#include "experiments/common/map_view/raster.h"

namespace cirque {

/// Letters made of lines, for pictures that no browser sets: small letters, digits, A and what
/// formulas need. Other characters are blanks.

/// Whether the font has the character; it has a blank.
bool HasGlyph(char character);

/// The width of a text whose figures are `size` high.
double TextWidth(std::string_view text, double size);

/// Writes it from `x` on, the feet of the letters at `baseline`.
void DrawText(std::string_view text, double x, double baseline, double size, const Rgb& colour,
              Raster* raster);

}  // namespace cirque
