#include "cirque/metrics/quasi_conformal.h"

#include "cirque/metrics/statistics.h"

namespace cirque {
namespace {

Measurement Measure(const MappedFaces& faces) {
  const Eigen::VectorXd ratio = faces.sigma_max.cwiseQuotient(faces.sigma_min);
  const std::vector<double> at = AreaPercentiles(faces.area, ratio, {0.50, 0.95, 0.99});
  return {ratio, {AreaMean(faces.area, ratio), at[0], at[1], at[2], Largest(ratio)}};
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
          Measure};
}

}  // namespace cirque
