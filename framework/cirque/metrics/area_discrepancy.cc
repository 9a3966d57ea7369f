#include "cirque/metrics/area_discrepancy.h"

#include "cirque/metrics/statistics.h"

namespace cirque {
namespace {

Measurement Measure(const MappedFaces& faces) {
  const Eigen::VectorXd discrepancy =
      (faces.image_area - faces.area).cwiseAbs().cwiseQuotient(faces.area);
  return {discrepancy, {AreaMean(faces.area, discrepancy)}};
}

}  // namespace

DistortionMeasure AreaDiscrepancy() {
  return {"areas",
          "|a - A| / A, areas of total 1",
          0,
          2,
          {{"area_discrepancy", "sum |a - A|, areas of total 1 (Shay, Solomon, Stein)"}},
          Measure};
}

}  // namespace cirque
