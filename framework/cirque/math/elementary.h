#pragma once

#include <cmath>

#include "cirque/core/lanes.h"

namespace cirque {

/// Elementary functions of T, a double or Lanes: sums, products and quotients alone, so that results are
/// the same on every processor and the lanes' are the double's. Polynomials are interpolated at
/// Chebyshev's points to 60 digits; bounds are measured against 50 digits in the tests.

/// The largest |x| for the three that follow.
constexpr double kLargestExponent = 700;

namespace lanes {

/// log 2 in two parts: multiples of the first by an exponent are exact.
constexpr double kLog2High = 0x1.62e42fefa3000p-1, kLog2Low = 0x1.3de6af278ece6p-42;

/// e^x = scale (1 + rest), scale a power of 2.
template <class T>
struct ScaledExponential {
  T scale, rest;
};

template <class T>
[[gnu::always_inline]] inline ScaledExponential<T> SplitExponential(T x) {
  constexpr double kPerLog2 = 0x1.71547652b82fep+0;
  constexpr double c[] = {0x1.5555555555556p-3,  0x1.5555555555555p-5,  0x1.11111111109b3p-7,
                          0x1.6c16c16c167e1p-10, 0x1.a01a01a7c41d5p-13, 0x1.a01a01a47b054p-16,
                          0x1.71de0dae63bb3p-19, 0x1.27e4e1f48534fp-22, 0x1.af38a9b0ec855p-26,
                          0x1.1f66df7fca49fp-29};
  const T k = lanes::Round(x * kPerLog2);
  const T r = (x - k * kLog2High) - k * kLog2Low;
  const T r2 = r * r, r4 = r2 * r2;
  const T low = (c[0] + c[1] * r) + (c[2] + c[3] * r) * r2;
  const T high = (c[4] + c[5] * r) + (c[6] + c[7] * r) * r2;
  const T cubic = low + (high + (c[8] + c[9] * r) * r4) * r4;
  return {lanes::PowerOfTwo(k), r + (0.5 * r2 + r * r2 * cubic)};
}

}  // namespace lanes

/// e^x to 1 ulp, for |x| <= kLargestExponent.
template <class T>
[[gnu::always_inline]] inline T Exponential(T x) {
  const auto e = lanes::SplitExponential(x);
  return e.scale + e.scale * e.rest;
}

/// The same of any number: the library's beyond that.
inline double ExponentialOfAny(double x) {
  return std::abs(x) <= kLargestExponent ? Exponential(x) : std::exp(x);
}

/// e^-x and 1 - e^-x of one exponential, each to 2 ulp, for x from 0 to kLargestExponent.
template <class T>
struct Decay {
  T left, gone;
};

template <class T>
[[gnu::always_inline]] inline Decay<T> DecayBy(T x) {
  const auto e = lanes::SplitExponential(-x);
  const T change = e.scale * e.rest;
  return {e.scale + change, (1.0 - e.scale) - change};
}

/// log x to 1 ulp, for positive normal numbers.
template <class T>
[[gnu::always_inline]] inline T Logarithm(T x) {
  // (2 artanh s - 2 s) / s^3 of z = s^2, with 2 artanh s = log((1 + s) / (1 - s)).
  constexpr double c[] = {0x1.5555555555555p-1, 0x1.9999999999a39p-2, 0x1.2492492476a1ap-2,
                          0x1.c71c7201a55d7p-3, 0x1.745cf8e4bba1bp-3, 0x1.3b1c3c1c81c8fp-3,
                          0x1.0fbde0f4ad17bp-3, 0x1.0c0aff044a970p-3};
  const auto [fraction, exponent] = lanes::Split(x);
  const T f = fraction - 1.0, s = f / (2.0 + f);
  const T z = s * s, z2 = z * z;
  const T low = (c[0] + c[1] * z) + (c[2] + c[3] * z) * z2;
  const T high = (c[4] + c[5] * z) + (c[6] + c[7] * z) * z2;
  const T tail = z * (low + high * (z2 * z2));
  // 2 s = f - s f, and s f = f^2 / 2 - s f^2 / 2: the large terms f and k log 2 are exact.
  const T half = 0.5 * f * f;
  return exponent * lanes::kLog2High -
         ((half - (s * (half + tail) + exponent * lanes::kLog2Low)) - f);
}

/// sin x to 1.1 ulp, relatively exact at both ends, for x in [0, pi].
template <class T>
[[gnu::always_inline]] inline T SineToPi(T x) {
  constexpr double kPerQuarter = 0x1.45f306dc9c883p-1;  // 2 / pi
  constexpr double kQuarter[] = {0x1.921fb54442000p+0, 0x1.a308d313198a0p-41,
                                 0x1.701b839a25205p-92};
  constexpr double s[] = {-0x1.5555555555555p-3, 0x1.1111111110bb2p-7,   -0x1.a01a019e83816p-13,
                          0x1.71de379654304p-19, -0x1.ae600aca92c64p-26, 0x1.5e0b05bff20f2p-33};
  constexpr double c[] = {0x1.5555555555555p-5,   -0x1.6c16c16c16967p-10, 0x1.a01a019f4e9b4p-16,
                          -0x1.27e4fa17bf139p-22, 0x1.1eeb68cd22f56p-29,  -0x1.907d8f29fe831p-37};
  const T k = lanes::Round(x * kPerQuarter);  // 0, 1 or 2
  const T r = ((x - k * kQuarter[0]) - k * kQuarter[1]) - k * kQuarter[2];
  const T z = r * r, z2 = z * z;
  const T sine_tail = (s[0] + s[1] * z) + ((s[2] + s[3] * z) + (s[4] + s[5] * z) * z2) * z2;
  const T cosine_tail = (c[0] + c[1] * z) + ((c[2] + c[3] * z) + (c[4] + c[5] * z) * z2) * z2;
  const T sine = r + r * z * sine_tail;
  const T half = 0.5 * z, one_less = 1.0 - half;
  const T cosine = one_less + (((1.0 - one_less) - half) + z2 * cosine_tail);
  return k == 1.0 ? cosine : (k == 0.0 ? sine : -sine);
}

}  // namespace cirque
