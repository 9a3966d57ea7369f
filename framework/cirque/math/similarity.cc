#include "cirque/math/similarity.h"

namespace cirque {

using Complex = std::complex<double>;

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

}  // namespace cirque
