#pragma once

#include <complex>
#include <vector>

#include <Eigen/Core>

namespace cirque {

/// The orientation-preserving similarity z -> factor z + shift of the plane.
struct Similarity {
  std::complex<double> factor, shift;
  double max_error = 0;  ///< largest distance left, relative to the diameter of the target
};

/// The least-squares similarity from the first points to the second.
Similarity FitSimilarity(const std::vector<Eigen::Vector2d>& from,
                         const std::vector<Eigen::Vector2d>& to);

}  // namespace cirque
