#include "cirque/metrics/log_area_ratio.h"

#include <cmath>

#include "cirque/metrics/statistics.h"

namespace cirque {
namespace {

Measurement Measure(const MappedFaces& faces) {
  const Eigen::VectorXd ratio = (faces.image_area.array() / faces.area.array()).log();
  return {ratio,
          {Smallest(ratio), Largest(ratio), AreaMean(faces.area, ratio),
           std::sqrt(AreaMean(faces.area, ratio.cwiseAbs2()))}};
}

}  // namespace

DistortionMeasure LogAreaRatio() {
  return {"areas",
          "log(a / A), areas of total 1",
          -3,
          3,
          {{"log_area_ratio_min", "minimum of log(a / A), areas of total 1"},
           {"log_area_ratio_max", "its maximum"},
           {"log_area_ratio_mean", "its mean by area: BFF's 2u"},
           {"log_area_ratio_l2", "its root mean square by area"}},
          Measure};
}

}  // namespace cirque
