#include <cmath>

#include "cirque/metrics/measures.h"

namespace cirque {
namespace {

Measurement MeasureLogRatio(const MappedFaces& faces) {
  const Eigen::VectorXd ratio = (faces.image_area.array() / faces.area.array()).log();
  return {ratio,
          {Smallest(ratio), Largest(ratio), AreaMean(faces.area, ratio),
           std::sqrt(AreaMean(faces.area, ratio.cwiseAbs2()))}};
}

Measurement MeasureLogScale(const MappedFaces& faces) {
  Eigen::VectorXd u = 0.5 * (faces.image_area.array() / faces.area.array()).log();
  u.array() -= AreaMean(faces.area, u);
  return {u, {Largest(u.cwiseAbs()), std::sqrt(AreaMean(faces.area, u.cwiseAbs2()))}};
}

/// a/A + A/a - 2 = (a - A)^2 / (a A), without cancellation near a = A.
Measurement MeasureDistortion(const MappedFaces& faces) {
  const Eigen::ArrayXd area = faces.area.array(), image = faces.image_area.array();
  const Eigen::VectorXd distortion = (image - area).square() / (image * area);
  return {distortion, {Largest(distortion)}};
}

Measurement MeasureDiscrepancy(const MappedFaces& faces) {
  const Eigen::VectorXd discrepancy =
      (faces.image_area - faces.area).cwiseAbs().cwiseQuotient(faces.area);
  return {discrepancy, {AreaMean(faces.area, discrepancy)}};
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
          MeasureLogRatio};
}

DistortionMeasure LogScale() {
  return {"areas",
          "u = 1/2 log(a / A), of mean 0",
          -1.5,
          1.5,
          {{"log_scale_max", "maximum of |u|, u = 1/2 log(a / A) of mean 0"},
           {"log_scale_l2", "L2 norm of u by area"}},
          MeasureLogScale};
}

DistortionMeasure AreaDistortion() {
  return {"areas",
          "a/A + A/a - 2, areas of total 1",
          0,
          10,
          {{"area_distortion_max", "maximum of a/A + A/a - 2 (Shay, Solomon, Stein)"}},
          MeasureDistortion};
}

DistortionMeasure AreaDiscrepancy() {
  return {"areas",
          "|a - A| / A, areas of total 1",
          0,
          2,
          {{"area_discrepancy", "sum |a - A|, areas of total 1 (Shay, Solomon, Stein)"}},
          MeasureDiscrepancy};
}

}  // namespace cirque
