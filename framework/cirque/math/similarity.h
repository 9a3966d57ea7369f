#pragma once

#include <complex>
#include <optional>
#include <vector>

#include <Eigen/Core>

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

/// A similarity of points to others, and the distances left, largest and root mean square, relative to
/// twice the others' largest distance from their centroid.
struct SimilarityFit {
  Similarity similarity;
  double max_error = 0, rms_error = 0;
};

/// NearestSimilarity with what it leaves, of points that are not all one.
SimilarityFit FitSimilarity(const std::vector<Eigen::Vector2d>& from,
                            const std::vector<Eigen::Vector2d>& to);

}  // namespace cirque
