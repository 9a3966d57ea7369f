#pragma once

#include <string>

namespace cirque {

/// The refinement that goes on until a step brings less than a hundred-thousandth.
inline constexpr char kRefineToRest[] = "mips:steps=100,decrease=1e-5";

/// What a map onto a shape of its own is refined by: as `asked`; where that is the default and the
/// closure of its layout misses kAccuracy, until it comes to rest, for such a map is a least one on its
/// shape whatever it began with (Inaccuracy).
std::string RefinementOnShape(const std::string& asked, double layout_closure);

}  // namespace cirque
