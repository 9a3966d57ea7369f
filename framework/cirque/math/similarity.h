#pragma once

#include <complex>
#include <optional>
#include <vector>

namespace cirque {

/// z -> factor (z - from) + to.
struct Similarity {
  std::complex<double> factor = 1, from = 0, to = 0;

  std::complex<double> operator()(std::complex<double> z) const { return factor * (z - from) + to; }
};

/// The similarity that takes points nearest to others, in the mean square. Nothing where the points are
/// all one. @pre as many points as others, one or more.
std::optional<Similarity> NearestSimilarity(const std::vector<std::complex<double>>& points,
                                            const std::vector<std::complex<double>>& others);

}  // namespace cirque
