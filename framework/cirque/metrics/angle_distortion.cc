#include "cirque/metrics/angle_distortion.h"

#include "cirque/metrics/statistics.h"

namespace cirque {
namespace {

/// s/t + t/s - 2 = (s - t)^2 / (s t), without cancellation near s = t.
Measurement Measure(const MappedFaces& faces) {
  const Eigen::ArrayXd s = faces.sigma_max.array(), t = faces.sigma_min.array();
  const Eigen::VectorXd distortion = (s - t).square() / (s * t);
  return {distortion, {Largest(distortion)}};
}

}  // namespace

DistortionMeasure AngleDistortion() {
  return {"angles",
          "s/t + t/s - 2",
          0,
          0.03,
          {{"angle_distortion_max", "maximum of s/t + t/s - 2 (Shay, Solomon, Stein)"}},
          Measure};
}

}  // namespace cirque
