#include "cirque/metrics/measures.h"

namespace cirque {
namespace {

Measurement MeasureRatios(const MappedFaces& faces) {
  const Eigen::VectorXd ratio = faces.sigma_max.cwiseQuotient(faces.sigma_min);
  const std::vector<double> at = AreaPercentiles(faces.area, ratio, {0.50, 0.95, 0.99});
  return {ratio, {AreaMean(faces.area, ratio), at[0], at[1], at[2], Largest(ratio)}};
}

Measurement MeasureAngles(const MappedFaces& faces) {
  const Eigen::Matrix3Xd difference = (faces.image_angle - faces.angle).cwiseAbs();
  const Eigen::VectorXd largest = difference.colwise().maxCoeff();
  const Eigen::VectorXd error = difference.colwise().mean();
  const double mean = AreaMean(faces.area, error);
  return {error, {mean, Largest(largest), 3 * mean}};
}

/// s/t + t/s - 2 = (s - t)^2 / (s t), without cancellation near s = t.
Measurement MeasureDistortion(const MappedFaces& faces) {
  const Eigen::ArrayXd s = faces.sigma_max.array(), t = faces.sigma_min.array();
  const Eigen::VectorXd distortion = (s - t).square() / (s * t);
  return {distortion, {Largest(distortion)}};
}

}  // namespace

DistortionMeasure QuasiConformal() {
  return {"angles",
          "sigma_max / sigma_min",
          1,
          1.2,
          {{"quasi_conformal_mean", "mean of sigma_max / sigma_min"},
           {"quasi_conformal_p50", "its median by area"},
           {"quasi_conformal_p95", "its 95th percentile by area"},
           {"quasi_conformal_p99", "its 99th percentile by area"},
           {"quasi_conformal_max", "its maximum"}},
          MeasureRatios};
}

DistortionMeasure AngleError() {
  return {"angles",
          "mean |angle difference| [rad]",
          0,
          0.1,
          {{"angle_error_mean", "mean |angle difference| over the corners [rad]"},
           {"angle_error_max", "its maximum [rad]"},
           {"angle_discrepancy", "sum A sum |angle difference| [rad] (Shay, Solomon, Stein)"}},
          MeasureAngles};
}

DistortionMeasure AngleDistortion() {
  return {"angles",
          "s/t + t/s - 2",
          0,
          0.03,
          {{"angle_distortion_max", "maximum of s/t + t/s - 2 (Shay, Solomon, Stein)"}},
          MeasureDistortion};
}

}  // namespace cirque
