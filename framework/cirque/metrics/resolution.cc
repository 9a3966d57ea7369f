#include "cirque/metrics/resolution.h"

#include <Eigen/Geometry>

#include "cirque/metrics/statistics.h"

namespace cirque {
namespace {

/// The larger side of the image's bounding box, where the image has area 1.
double Extent(const MappedFaces& faces) {
  Eigen::AlignedBox2d box;
  for (const Index f : faces.face) {
    for (Index h = 3 * f; h < 3 * f + 3; ++h) box.extend(faces.uv.value[h]);
  }
  return box.isEmpty() ? 0 : box.sizes().maxCoeff() / faces.image_size;
}

Measurement Measure(const MappedFaces& faces) {
  const Eigen::VectorXd needed = Extent(faces) * faces.sigma_min.cwiseInverse();
  return {needed, {Largest(needed) * faces.surface_size, Largest(needed)}};
}

}  // namespace

DistortionMeasure Resolution() {
  return {
      "lengths",
      "pixels for the face, surface of area 1",
      0,
      10,
      {{"resolution", "pixels a side for one per unit of length (Shay, Solomon, Stein)", 1, true},
       {"resolution_unit_area", "the same for the surface scaled to area 1", 0, true}},
      Measure};
}

}  // namespace cirque
