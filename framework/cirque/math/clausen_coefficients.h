#pragma once

#include <array>

namespace cirque {

/// P(t) = (Cl2(x) - x + x log x) / x^3 at t = x^2, interpolated in the Chebyshev nodes of
/// [0, (pi / 2)^2].
inline constexpr std::array<double, 8> kClausenNearZero = {
    0.013888888888888888,   6.944444444451165e-05, 7.873519772573527e-07, 1.1482218186762021e-08,
    1.8978578414248702e-10, 3.389794982855225e-12, 6.255469496392517e-14, 1.5270563246700983e-15};

/// Cl2(pi - y) / y = log 2 + t Q(t) at t = y^2, Q interpolated in the Chebyshev nodes of
/// [0, (pi / 2)^2].
inline constexpr std::array<double, 14> kClausenNearPi = {
    -0.041666666666666664,   -0.0010416666666666719,  -4.9603174603036476e-05,
    -2.92796516897403e-06,   -1.9415383233140636e-07, -1.3871023662017367e-08,
    -1.0439782403469208e-09, -8.17410640600354e-11,   -6.512616360289692e-12,
    -5.892385276389723e-13,  -2.4107330042608247e-14, -1.0624827304401617e-14,
    9.648992593644653e-16,   -1.5976150103774488e-16};

}  // namespace cirque
