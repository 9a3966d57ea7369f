#pragma once

#include <array>

namespace cirque {

/// P(t) = (Cl2(x) - x + x log x) / x^3 at t = x^2, interpolated in the Chebyshev nodes of
/// [0, (2 pi / 3)^2].
inline constexpr std::array<double, 10> kClausenNearZero = {
    0.013888888888888888,   6.944444444444851e-05,  7.873519777976576e-07, 1.1482216431958081e-08,
    1.8978856948835737e-10, 3.3874111736819805e-12, 6.36703812464277e-14,  1.2637115348076768e-15,
    2.1856233598150802e-17, 8.369832750017018e-19};

/// Q(t) = Cl2(pi - y) / y at t = y^2, interpolated in the Chebyshev nodes of [0, (pi / 3)^2].
inline constexpr std::array<double, 12> kClausenNearPi = {
    0.6931471805599453,      -0.041666666666666664,   -0.0010416666666666376,
    -4.960317460366705e-05,  -2.927965163238991e-06,  -1.9415386219040102e-07,
    -1.3870926802550982e-08, -1.0441834322710436e-09, -8.145153349330034e-11,
    -6.783440153081196e-12,  -4.267868020917325e-13,  -8.203214490703403e-14};

}  // namespace cirque
