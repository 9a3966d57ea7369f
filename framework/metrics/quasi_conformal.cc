#include "cirque/metrics/quasi_conformal.h"

#include "cirque/metrics/statistics.h"

namespace cirque {
namespace {

Measurement Measure(const MappedFaces& faces) {
  const Eigen::VectorXd ratio = faces.sigma_max.cwiseQuotient(faces.sigma_min);
  return {ratio,
          {AreaMean(faces.area, ratio), AreaPercentile(faces.area, ratio, 0.50),
           AreaPercentile(faces.area, ratio, 0.95), AreaPercentile(faces.area, ratio, 0.99),
           Largest(ratio)}};
}

}  // namespace

Metric QuasiConformal() {
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
