#pragma once

namespace cirque {

/// Clausen's integral Cl2(x) = sum_{n >= 1} sin(n x) / n^2 = -int_0^x log|2 sin(t/2)| dt, for every
/// real x [rad]. Odd, period 2 pi, |Cl2| <= 1.0150 (at pi/3).
///
/// Absolute error at most 2^-52 = 2.2e-16 on [-2 pi, 2 pi], 2 ulp of a value in [1/2, 1); measured:
/// 0.99 2^-52 over 600,000 random arguments. At the zeros 0, pi and 2 pi the relative error is a
/// few ulp as well. Elsewhere the argument is first reduced, to full accuracy. NaN for NaN and
/// infinity.
///
/// Source: L. Lewin, Polylogarithms and associated functions (1981), chapter 4. The coefficients
/// are our own Chebyshev interpolants, recomputed in 50 digits by the test.
double Clausen(double x);

/// Lobachevsky's function L(x) = -int_0^x log|2 sin t| dt = Cl2(2x) / 2, of period pi.
double Lobachevsky(double x);

}  // namespace cirque
