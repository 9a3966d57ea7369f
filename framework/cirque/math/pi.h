#pragma once

namespace cirque {

/// pi - kPi: with it sums that cancel pi keep their digits.
inline constexpr double kPiLow = 0x1.1a62633145c07p-53;

}  // namespace cirque
