#include "cirque/metrics/area_distortion.h"

#include "cirque/metrics/statistics.h"

namespace cirque {
namespace {

/// a/A + A/a - 2 = (a - A)^2 / (a A), without cancellation near a = A.
Measurement Measure(const MappedFaces& faces) {
  const Eigen::ArrayXd area = faces.area.array(), image = faces.image_area.array();
  const Eigen::VectorXd distortion = (image - area).square() / (image * area);
  return {distortion, {Largest(distortion)}};
}

}  // namespace

DistortionMeasure AreaDistortion() {
  return {"areas",
          "a/A + A/a - 2, areas of total 1",
          0,
          10,
          {{"area_distortion_max", "maximum of a/A + A/a - 2 (Shay, Solomon, Stein)"}},
          Measure};
}

}  // namespace cirque
