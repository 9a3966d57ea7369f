#include "cirque/math/similarity.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace cirque {

using Complex = std::complex<double>;

namespace {

std::vector<Complex> ComplexOf(const std::vector<Eigen::Vector2d>& points) {
  std::vector<Complex> z;
  for (const auto& p : points) z.emplace_back(p.x(), p.y());
  return z;
}

}  // namespace

std::optional<Similarity> NearestSimilarity(const std::vector<Complex>& points,
                                            const std::vector<Complex>& others) {
  const auto count = static_cast<double>(points.size());
  Similarity similarity;
  for (std::size_t k = 0; k < points.size(); ++k) {
    similarity.from += points[k] / count;
    similarity.to += others[k] / count;
  }
  Complex product = 0;
  double spread = 0;
  for (std::size_t k = 0; k < points.size(); ++k) {
    product += std::conj(points[k] - similarity.from) * (others[k] - similarity.to);
    spread += std::norm(points[k] - similarity.from);
  }
  if (!(spread > 0)) return std::nullopt;
  similarity.factor = product / spread;
  return similarity;
}

SimilarityFit FitSimilarity(const std::vector<Eigen::Vector2d>& from,
                            const std::vector<Eigen::Vector2d>& to) {
  const std::vector<Complex> points = ComplexOf(from), others = ComplexOf(to);
  SimilarityFit fit{NearestSimilarity(points, others).value_or(Similarity())};
  double extent = 0, sum_of_squares = 0;
  for (std::size_t i = 0; i < from.size(); ++i) {
    const double error = std::abs(fit.similarity(points[i]) - others[i]);
    fit.max_error = std::max(fit.max_error, error);
    sum_of_squares += error * error;
    extent = std::max(extent, std::abs(others[i] - fit.similarity.to));
  }
  fit.max_error /= 2 * extent;
  fit.rms_error = std::sqrt(sum_of_squares / static_cast<double>(from.size())) / (2 * extent);
  return fit;
}

}  // namespace cirque
