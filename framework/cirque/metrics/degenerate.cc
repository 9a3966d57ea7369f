#include "cirque/metrics/degenerate.h"

namespace cirque {
namespace {

Measurement Measure(const MappedFaces& faces) {
  return {{}, {static_cast<double>(faces.triangulation.num_faces() - faces.num_faces())}};
}

}  // namespace

DistortionMeasure Degenerate() {
  return {.group = "injectivity",
          .figures = {{"degenerate_faces", "faces without area, left out of all other figures"}},
          .measure = Measure};
}

}  // namespace cirque
