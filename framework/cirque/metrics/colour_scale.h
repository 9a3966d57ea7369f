#pragma once

#include "cirque/io/coloured_ply.h"

namespace cirque {

/// The colour of a value between `least` and `greatest`; beyond them that of the end, grey for NaN.
/// Ranges on one side of zero: from dark blue through green to light yellow, lightness growing in
/// equal steps. Ranges from negative to positive: from blue through light grey in the middle to
/// red, lightness falling in equal steps to both sides. Both are straight or bent paths in the
/// perceptual space OKLab (B. Ottosson, 2020).
Colour ColourOnScale(double value, double least, double greatest);

}  // namespace cirque
