#pragma once

#include <cmath>

#include "cirque/math/elementary.h"

namespace cirque {

// HalfAngle and HalfAngleWeight of circle_angle.h, of T, a double or Lanes, from e^-|d|.

/// That of any |d|.
inline Decay<double> DecayByAny(double x) {
  return x <= kLargestExponent ? DecayBy(x) : Decay<double>{std::exp(-x), 1.0};
}

/// The arctangent's sides, sin theta and e^d - cos theta = expm1(d) + (1 - cos theta), both scaled by
/// e^-d where d > 0. A cancellation of the two terms happens only near phi = pi/2, where it is harmless.
template <class T>
struct HalfAngleSides {
  T sine, cosine;
};

template <class T>
[[gnu::always_inline]] inline HalfAngleSides<T> SidesOfHalfAngle(T d, T sine, T one_minus_cosine,
                                                                 const Decay<T>& decay) {
  const T one = decay.left - decay.left + 1.0;
  const T scale = d > 0.0 ? decay.left : one;
  const T growth = d > 0.0 ? decay.gone : -decay.gone;
  return {scale * sine, growth + scale * one_minus_cosine};
}

/// sin theta / (cosh d - cos theta), both scaled by 2 q with q = e^-|d|.
template <class T>
[[gnu::always_inline]] inline T WeightOfHalfAngle(T sine, T one_minus_cosine,
                                                  const Decay<T>& decay) {
  const T twice = 2.0 * decay.left;
  return twice * sine / (decay.gone * decay.gone + twice * one_minus_cosine);
}

}  // namespace cirque
