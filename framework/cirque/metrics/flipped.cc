#include "cirque/metrics/flipped.h"

#include <algorithm>

namespace cirque {
namespace {

Measurement Measure(const MappedFaces& faces) {
  Eigen::VectorXd flipped(faces.num_faces());
  for (Index i = 0; i < faces.num_faces(); ++i) flipped[i] = faces.flipped[i] ? 1 : 0;
  const double share = flipped.sum() / faces.num_faces();  // NaN without a face
  return {flipped, {std::min(share, 1 - share)}};
}

}  // namespace

DistortionMeasure Flipped() {
  return {"injectivity",
          "1 where flipped, else 0",
          0,
          1,
          {{"flipped_share", "min(p, 1 - p), p the share of flipped faces (Shay, Solomon, Stein)"}},
          Measure};
}

}  // namespace cirque
