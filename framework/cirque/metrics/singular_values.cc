#include "cirque/metrics/singular_values.h"

#include "cirque/metrics/statistics.h"

namespace cirque {
namespace {

Measurement MeasureSmaller(const MappedFaces& faces) {
  return {faces.sigma_min, {Smallest(faces.sigma_min)}};
}

Measurement MeasureLarger(const MappedFaces& faces) {
  return {faces.sigma_max, {Largest(faces.sigma_max)}};
}

}  // namespace

DistortionMeasure SmallerSingularValue() {
  return {"lengths",
          "smaller singular value, areas of total 1",
          0,
          2,
          {{"singular_value_min", "least singular value, areas of total 1"}},
          MeasureSmaller};
}

DistortionMeasure LargerSingularValue() {
  return {"lengths",
          "larger singular value, areas of total 1",
          0,
          2,
          {{"singular_value_max", "greatest singular value, areas of total 1"}},
          MeasureLarger};
}

}  // namespace cirque
