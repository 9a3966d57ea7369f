#include "cirque/metrics/log_scale.h"

#include <cmath>

#include "cirque/metrics/statistics.h"

namespace cirque {
namespace {

Measurement Measure(const MappedFaces& faces) {
  Eigen::VectorXd u = 0.5 * (faces.image_area.array() / faces.area.array()).log();
  u.array() -= AreaMean(faces.area, u);
  return {u, {Largest(u.cwiseAbs()), std::sqrt(AreaMean(faces.area, u.cwiseAbs2()))}};
}

}  // namespace

DistortionMeasure LogScale() {
  return {"areas",
          "u = 1/2 log(a / A), of mean 0",
          -1.5,
          1.5,
          {{"log_scale_max", "maximum of |u|, u = 1/2 log(a / A) of mean 0"},
           {"log_scale_l2", "L2 norm of u by area"}},
          Measure};
}

}  // namespace cirque
