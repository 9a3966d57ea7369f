#pragma once

#include <complex>
#include <cstring>

#include "cirque/core/lanes.h"

/// Loops over columns that are too short for BLAS, of real and of complex numbers, on lanes.
namespace cirque::column {

using Complex = std::complex<double>;

constexpr int kComplexes = kLanes / 2;  ///< that lanes hold, real and imaginary parts in turn

[[gnu::always_inline]] inline double Conjugate(double x) { return x; }
[[gnu::always_inline]] inline Complex Conjugate(Complex x) { return {x.real(), -x.imag()}; }

[[gnu::always_inline]] inline Lanes Load(const Complex* from) {
  return lanes::Load(reinterpret_cast<const double*>(from));
}
[[gnu::always_inline]] inline void Store(Lanes x, Complex* to) {
  std::memcpy(static_cast<void*>(to), &x, sizeof(x));
}

/// Real and imaginary parts exchanged.
[[gnu::always_inline]] inline Lanes Swap(Lanes x) {
  return __builtin_shufflevector(x, x, 1, 0, 3, 2);
}

/// to[i] += factor from[i]
[[gnu::always_inline]] inline void AddMultiple(double factor, const double* from, int n,
                                               double* to) {
  for (int i = 0; i < n; ++i) to[i] += factor * from[i];
}
[[gnu::always_inline]] inline void AddMultiple(Complex factor, const Complex* from, int n,
                                               Complex* to) {
  const double a = factor.real(), b = factor.imag();
  const Lanes real = {a, a, a, a}, imaginary = {-b, b, -b, b};
  int i = 0;
  for (; i + kComplexes <= n; i += kComplexes) {
    const Lanes x = Load(from + i);
    Store(Load(to + i) + (real * x + imaginary * Swap(x)), to + i);
  }
  if (i == n) return;
  const double x = from[i].real(), y = from[i].imag();
  to[i] += Complex(a * x - b * y, a * y + b * x);
}

/// to[i] *= factor
template <class Scalar>
[[gnu::always_inline]] inline void Scale(double factor, int n, Scalar* to) {
  for (int i = 0; i < n; ++i) to[i] *= factor;
}

/// sum of conj(a[i]) b[i]
[[gnu::always_inline]] inline double Dot(const double* a, const double* b, int n) {
  constexpr int kStep = 2 * kLanes;
  Lanes even{}, odd{};
  int i = 0;
  for (; i + kStep <= n; i += kStep) {
    even += lanes::Load(a + i) * lanes::Load(b + i);
    odd += lanes::Load(a + i + kLanes) * lanes::Load(b + i + kLanes);
  }
  even += odd;
  double sum = (even[0] + even[1]) + (even[2] + even[3]);
  for (; i < n; ++i) sum += a[i] * b[i];
  return sum;
}
[[gnu::always_inline]] inline Complex Dot(const Complex* a, const Complex* b, int n) {
  Lanes straight{}, crossed{};
  int i = 0;
  for (; i + kComplexes <= n; i += kComplexes) {
    const Lanes x = Load(a + i), y = Load(b + i);
    straight += x * y;
    crossed += x * Swap(y);
  }
  double real = (straight[0] + straight[1]) + (straight[2] + straight[3]);
  double imaginary = (crossed[0] - crossed[1]) + (crossed[2] - crossed[3]);
  if (i < n) {
    real += a[i].real() * b[i].real() + a[i].imag() * b[i].imag();
    imaginary += a[i].real() * b[i].imag() - a[i].imag() * b[i].real();
  }
  return {real, imaginary};
}

}  // namespace cirque::column
