#include "tests/metrics/example/l2_stretch.h"

#include <cmath>

namespace cirque {
namespace {

Measurement Measure(const MappedFaces& faces) {
  const Eigen::VectorXd squares =
      (faces.sigma_max.array().square() + faces.sigma_min.array().square()) / 2;
  return {squares.cwiseSqrt(), {std::sqrt(AreaMean(faces.area, squares))}};
}

}  // namespace

DistortionMeasure L2Stretch() {
  return {"lengths",
          "sqrt((s^2 + t^2) / 2)",
          1,
          2,
          {{"l2_stretch", "root mean square of sqrt((s^2 + t^2) / 2)"}},
          Measure};
}

}  // namespace cirque
