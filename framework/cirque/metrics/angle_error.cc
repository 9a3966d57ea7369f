#include "cirque/metrics/angle_error.h"

#include "cirque/metrics/statistics.h"

namespace cirque {
namespace {

Measurement Measure(const MappedFaces& faces) {
  const Eigen::Matrix3Xd difference = (faces.image_angle - faces.angle).cwiseAbs();
  const Eigen::VectorXd largest = difference.colwise().maxCoeff();
  const Eigen::VectorXd error = difference.colwise().mean();
  const double mean = AreaMean(faces.area, error);
  return {error, {mean, Largest(largest), 3 * mean}};
}

}  // namespace

DistortionMeasure AngleError() {
  return {"angles",
          "mean |angle difference| [rad]",
          0,
          0.1,
          {{"angle_error_mean", "mean |angle difference| over the corners [rad]"},
           {"angle_error_max", "its maximum [rad]"},
           {"angle_discrepancy", "sum A sum |angle difference| [rad] (Shay, Solomon, Stein)"}},
          Measure};
}

}  // namespace cirque
