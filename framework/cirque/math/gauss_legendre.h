#pragma once

#include <array>
#include <cstddef>

namespace cirque {

/// Integral of f over [a, b] by the Gauss-Legendre rule of 8 nodes. For f analytic with no
/// singularity nearer to the interval than its length the relative error is below 1e-14.
template <typename F>
double Integrate(const F& f, double a, double b) {
  constexpr std::array<double, 4> kNodes = {0.1834346424956498, 0.525532409916329,
                                            0.7966664774136267, 0.9602898564975363};
  constexpr std::array<double, 4> kWeights = {0.362683783378362, 0.31370664587788727,
                                              0.22238103445337448, 0.10122853629037626};
  const double centre = 0.5 * (a + b), half = 0.5 * (b - a);
  double sum = 0.0;
  for (std::size_t k = 0; k < kNodes.size(); ++k) {
    sum += kWeights[k] * (f(centre - half * kNodes[k]) + f(centre + half * kNodes[k]));
  }
  return half * sum;
}

}  // namespace cirque
