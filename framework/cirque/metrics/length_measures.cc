#include <limits>

#include <Eigen/Geometry>

#include "cirque/math/compensated_sum.h"
#include "cirque/metrics/measures.h"

namespace cirque {
namespace {

Measurement MeasureDirichlet(const MappedFaces& faces) {
  const Eigen::ArrayXd s = faces.sigma_max.array().square(), t = faces.sigma_min.array().square();
  const Eigen::VectorXd energy = 0.5 * (s + t + s.inverse() + t.inverse());
  return {energy, {AreaMean(faces.area, energy), Largest(energy)}};
}

Measurement MeasureSmaller(const MappedFaces& faces) {
  return {faces.sigma_min, {Smallest(faces.sigma_min)}};
}

Measurement MeasureLarger(const MappedFaces& faces) {
  return {faces.sigma_max, {Largest(faces.sigma_max)}};
}

/// The larger side of the image's bounding box, where the image has area 1.
double Extent(const MappedFaces& faces) {
  Eigen::AlignedBox2d box;
  for (const Index f : faces.face) {
    for (Index h = 3 * f; h < 3 * f + 3; ++h) box.extend(faces.uv.value[h]);
  }
  return box.isEmpty() ? 0 : box.sizes().maxCoeff() / faces.image_size;
}

Measurement MeasureResolution(const MappedFaces& faces) {
  const Eigen::VectorXd needed = Extent(faces) * faces.sigma_min.cwiseInverse();
  return {needed, {Largest(needed) * faces.surface_size, Largest(needed)}};
}

bool IsTorn(const MappedFaces& faces, Index h, Index twin) {
  const auto& uv = faces.uv.value;
  return uv[Triangulation::Next(h)] != uv[Triangulation::Prev(twin)] ||
         uv[Triangulation::Prev(h)] != uv[Triangulation::Next(twin)];
}

Measurement MeasureCut(const MappedFaces& faces) {
  const Triangulation& t = faces.triangulation;
  if (faces.num_faces() == 0) return {{}, {std::numeric_limits<double>::quiet_NaN()}};
  CompensatedSum length;
  for (Index e = 0; e < t.num_edges(); ++e) {
    const Index h = t.edge_halfedge[e];
    if (t.twin[h] == kNone || !IsTorn(faces, h, t.twin[h])) continue;
    length += faces.lengths.value[e] / faces.surface_size;
  }
  return {{}, {length.Value()}};
}

}  // namespace

DistortionMeasure SymmetricDirichlet() {
  return {"lengths",
          "(s^2 + t^2 + 1/s^2 + 1/t^2) / 2",
          2,
          10,
          {{"symmetric_dirichlet", "mean of (s^2 + t^2 + 1/s^2 + 1/t^2) / 2, least 2"},
           {"symmetric_dirichlet_max", "its maximum"}},
          MeasureDirichlet};
}

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

DistortionMeasure Resolution() {
  return {
      "lengths",
      "pixels for the face, surface of area 1",
      0,
      10,
      {{"resolution", "pixels a side for one per unit of length (Shay, Solomon, Stein)", 1, true},
       {"resolution_unit_area", "the same for the surface scaled to area 1", 0, true}},
      MeasureResolution};
}

DistortionMeasure CutLength() {
  return {
      .group = "lengths",
      .figures = {{"cut_length", "length of the seams, surface of area 1 (Shay, Solomon, Stein)"}},
      .measure = MeasureCut};
}

}  // namespace cirque
