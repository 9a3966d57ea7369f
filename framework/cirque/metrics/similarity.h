#pragma once

#include <complex>
#include <vector>

#include <Eigen/Core>

namespace cirque {

/// The orientation-preserving similarity z -> factor z + shift of the plane.
struct Similarity {
  std::complex<double> factor, shift;
  /// The distances left, largest and root mean square, relative to twice the target's largest
  /// distance from its centroid.
  double max_error = 0, rms_error = 0;
};

/// The least-squares similarity from the first points to the second.
Similarity FitSimilarity(const std::vector<Eigen::Vector2d>& from,
                         const std::vector<Eigen::Vector2d>& to);

}  // namespace cirque
