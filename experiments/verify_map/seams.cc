#include "experiments/verify_map/seams.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>
#include <vector>

namespace cirque::verify_map {
namespace {

double UvLength(const UvComplex& complex, Index h) {
  return (complex.Tip(h) - complex.Tail(h)).norm();
}

double Median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

}  // namespace

SeamAgreement CompareSeams(const UvComplex& complex) {
  struct Side {
    Index halfedge;
    double log_ratio;  ///< of the length in the patch of smaller number to the other
  };
  std::map<std::pair<Index, Index>, std::vector<Side>> sides_of;
  SeamAgreement result;
  for (Index h = 0; h < static_cast<Index>(complex.uv.size()); ++h) {
    const Index t = complex.surface.twin[h];
    if (t < h || !complex.IsSeam(h)) continue;
    ++result.num_edges;
    const Index a = complex.patch[h / 3], b = complex.patch[t / 3];
    const double ratio = std::log(UvLength(complex, h)) - std::log(UvLength(complex, t));
    sides_of[std::minmax(a, b)].push_back({h, a <= b ? ratio : -ratio});
  }
  for (const auto& [patches, sides] : sides_of) {
    std::vector<double> ratios;
    for (const Side& side : sides) ratios.push_back(side.log_ratio);
    const double scale = patches.first == patches.second ? 0.0 : Median(std::move(ratios));
    for (const Side& side : sides) {
      const double difference = std::abs(std::expm1(side.log_ratio - scale));
      if (difference <= result.largest_difference) continue;
      result.largest_difference = difference;
      result.worst_halfedge = side.halfedge;
    }
  }
  return result;
}

}  // namespace cirque::verify_map
