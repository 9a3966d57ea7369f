#include "cirque/metrics/similarity.h"

#include <algorithm>
#include <cmath>

namespace cirque {
namespace {

std::complex<double> Complex(const Eigen::Vector2d& p) { return {p.x(), p.y()}; }

std::complex<double> Mean(const std::vector<Eigen::Vector2d>& points) {
  std::complex<double> sum = 0;
  for (const auto& p : points) sum += Complex(p);
  return sum / static_cast<double>(points.size());
}

}  // namespace

Similarity FitSimilarity(const std::vector<Eigen::Vector2d>& from,
                         const std::vector<Eigen::Vector2d>& to) {
  const std::complex<double> from_mean = Mean(from), to_mean = Mean(to);
  std::complex<double> covariance = 0;
  double variance = 0, extent = 0;
  for (std::size_t i = 0; i < from.size(); ++i) {
    const std::complex<double> centred = Complex(from[i]) - from_mean;
    covariance += std::conj(centred) * (Complex(to[i]) - to_mean);
    variance += std::norm(centred);
    extent = std::max(extent, std::abs(Complex(to[i]) - to_mean));
  }
  Similarity s;
  s.factor = covariance / variance;
  s.shift = to_mean - s.factor * from_mean;
  double sum_of_squares = 0;
  for (std::size_t i = 0; i < from.size(); ++i) {
    const double error = std::abs(s.factor * Complex(from[i]) + s.shift - Complex(to[i]));
    s.max_error = std::max(s.max_error, error / (2 * extent));
    sum_of_squares += error * error;
  }
  s.rms_error = std::sqrt(sum_of_squares / static_cast<double>(from.size())) / (2 * extent);
  return s;
}

}  // namespace cirque
