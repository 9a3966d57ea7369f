#pragma once

#include <complex>
#include <utility>

namespace cirque {

/// Two periods of a lattice of the plane, second / first = tau.
struct Lattice {
  std::complex<double> first, second;

  std::complex<double> Tau() const { return second / first; }
  /// z as a combination of the periods, real factors.
  std::pair<double, double> Coordinates(std::complex<double> z) const;
};

/// The shortest periods of the lattice that two vectors span (C. F. Gauss, "Disquisitiones
/// arithmeticae", 1801): tau is in the fundamental domain of the modular group, Im tau > 0, |tau| >= 1,
/// |Re tau| <= 1/2. @pre finite vectors that are not parallel.
Lattice ReduceLattice(std::complex<double> a, std::complex<double> b);

/// The nearest multiple of 2^exponent.
double RoundToGrid(double x, int exponent);

}  // namespace cirque
