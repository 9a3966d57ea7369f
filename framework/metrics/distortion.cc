#include "cirque/metrics/distortion.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "cirque/math/compensated_sum.h"

namespace cirque {
namespace {

/// A triangle laid into the plane with its first edge on the x axis: the columns are the edges from
/// corner 0.
Eigen::Matrix2d LayOutTriangle(double a, double b, double c) {
  // a is opposite corner 0; corner 1 lies at (c, 0), corner 2 at distance b from corner 0.
  const double x = (b * b + c * c - a * a) / (2 * c);
  Eigen::Matrix2d edges;
  edges << c, x, 0, std::sqrt(std::max(0.0, (b - x) * (b + x)));
  return edges;
}

/// sigma_max / sigma_min of a 2x2 matrix with positive determinant, by its conformal and
/// anticonformal parts.
double SingularValueRatio(const Eigen::Matrix2d& m) {
  const double conformal = std::hypot(m(0, 0) + m(1, 1), m(1, 0) - m(0, 1));
  const double anticonformal = std::hypot(m(0, 0) - m(1, 1), m(1, 0) + m(0, 1));
  if (conformal <= anticonformal) return std::numeric_limits<double>::infinity();
  return (conformal + anticonformal) / (conformal - anticonformal);
}

}  // namespace

FaceDistortion MeasureDistortion(const Triangulation& t, const EdgeLengths& lengths,
                                 const CornerUv& uv) {
  FaceDistortion d;
  d.quasi_conformal.resize(t.num_faces());
  d.log_area_ratio.resize(t.num_faces());
  d.area.resize(t.num_faces());
  Eigen::VectorXd image_area(t.num_faces());
  for (Index f = 0; f < t.num_faces(); ++f) {
    const auto length = [&](int k) { return lengths.value[t.edge[3 * f + k]]; };
    const Eigen::Matrix2d source = LayOutTriangle(length(0), length(1), length(2));
    Eigen::Matrix2d image;
    image << uv.value[3 * f + 1] - uv.value[3 * f], uv.value[3 * f + 2] - uv.value[3 * f];
    d.quasi_conformal[f] = SingularValueRatio(image * source.inverse());
    d.area[f] = 0.5 * source.determinant();
    image_area[f] = 0.5 * image.determinant();
  }
  d.area /= d.area.sum();
  d.log_area_ratio = (image_area.array() / image_area.sum() / d.area.array()).log();
  return d;
}

DistortionSummary Summarize(const FaceDistortion& d) {
  DistortionSummary s;
  s.quasi_conformal_mean = d.area.dot(d.quasi_conformal);
  s.quasi_conformal_max = d.quasi_conformal.maxCoeff();
  s.log_area_ratio_l2 = std::sqrt(d.area.dot(d.log_area_ratio.cwiseAbs2()));
  s.log_area_ratio_min = d.log_area_ratio.minCoeff();
  s.log_area_ratio_max = d.log_area_ratio.maxCoeff();
  return s;
}

}  // namespace cirque
