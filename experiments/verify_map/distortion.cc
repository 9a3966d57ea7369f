#include "experiments/verify_map/distortion.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <map>
#include <numeric>

#include <Eigen/Geometry>

namespace cirque::verify_map {
namespace {

struct TriangleMeasure {
  Index triangle = kNone;
  double area = 0, uv_area = 0;
  double quasi_conformal = 1;
};

/// The map of one triangle as z -> p z + q conj(z); the singular values are |p| + |q| and
/// ||p| - |q||.
TriangleMeasure Measure(const UvComplex& complex, const std::vector<Eigen::Vector3d>& position,
                        Index f) {
  const std::vector<Index>& vertex = complex.mesh().vertex;
  const Eigen::Vector3d e1 = position[vertex[3 * f + 1]] - position[vertex[3 * f]];
  const Eigen::Vector3d e2 = position[vertex[3 * f + 2]] - position[vertex[3 * f]];
  const Point w1 = complex.uv[3 * f + 1] - complex.uv[3 * f];
  const Point w2 = complex.uv[3 * f + 2] - complex.uv[3 * f];
  const double double_area = e1.cross(e2).norm();
  const std::complex<double> z1(e1.norm(), 0), z2(e1.dot(e2) / e1.norm(), double_area / e1.norm());
  const std::complex<double> u1(w1.x(), w1.y()), u2(w2.x(), w2.y());
  const double p = std::abs(u2 * std::conj(z1) - u1 * std::conj(z2));
  const double q = std::abs(u2 * z1 - u1 * z2);
  const double uv_area = std::abs(w1.x() * w2.y() - w1.y() * w2.x()) / 2;
  return {f, double_area / 2, uv_area, (p + q) / std::abs(p - q)};
}

/// The smallest value that at least the given fraction of the area does not exceed.
double Percentile(const std::vector<TriangleMeasure>& sorted, double area, double fraction) {
  double below = 0;
  for (const TriangleMeasure& m : sorted) {
    below += m.area;
    if (below >= fraction * area) return m.quasi_conformal;
  }
  return sorted.back().quasi_conformal;
}

std::vector<TriangleMeasure> MeasureAll(const UvComplex& complex,
                                        const std::vector<Eigen::Vector3d>& position) {
  std::vector<TriangleMeasure> measures;
  measures.reserve(complex.num_triangles());
  for (Index f = 0; f < complex.num_triangles(); ++f) {
    const TriangleMeasure m = Measure(complex, position, f);
    if (m.area > 0 && m.uv_area > 0 && std::isfinite(m.quasi_conformal)) measures.push_back(m);
  }
  return measures;
}

void MeasureAreas(const std::vector<TriangleMeasure>& measures, double area, Distortion* result) {
  const double uv_area =
      std::accumulate(measures.begin(), measures.end(), 0.0,
                      [](double sum, const TriangleMeasure& m) { return sum + m.uv_area; });
  double squares = 0;
  for (const TriangleMeasure& m : measures) {
    const double ratio = std::log(m.uv_area / uv_area) - std::log(m.area / area);
    result->log_area_min = std::fmin(result->log_area_min, ratio);
    result->log_area_max = std::fmax(result->log_area_max, ratio);
    squares += m.area * ratio * ratio;
  }
  result->log_area_l2 = std::sqrt(squares / area);
}

double UvLength(const UvComplex& complex, Index h) {
  return (complex.Tip(h) - complex.Tail(h)).norm();
}

double Median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

}  // namespace

Distortion MeasureDistortion(const UvComplex& complex,
                             const std::vector<Eigen::Vector3d>& position) {
  Distortion result;
  std::vector<TriangleMeasure> measures = MeasureAll(complex, position);
  result.num_skipped = complex.num_triangles() - static_cast<Index>(measures.size());
  if (measures.empty()) return result;
  std::sort(measures.begin(), measures.end(),
            [](const auto& a, const auto& b) { return a.quasi_conformal < b.quasi_conformal; });
  double area = 0, weighted = 0;
  for (const TriangleMeasure& m : measures) {
    area += m.area;
    weighted += m.area * m.quasi_conformal;
  }
  result.quasi_conformal_mean = weighted / area;
  result.quasi_conformal_p50 = Percentile(measures, area, 0.50);
  result.quasi_conformal_p95 = Percentile(measures, area, 0.95);
  result.quasi_conformal_p99 = Percentile(measures, area, 0.99);
  result.quasi_conformal_max = measures.back().quasi_conformal;
  result.quasi_conformal_worst = measures.back().triangle;
  MeasureAreas(measures, area, &result);
  return result;
}

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
