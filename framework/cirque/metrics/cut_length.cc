#include "cirque/metrics/cut_length.h"

#include <limits>

#include "cirque/math/compensated_sum.h"

namespace cirque {
namespace {

bool IsTorn(const MappedFaces& faces, Index h, Index twin) {
  const auto& uv = faces.uv.value;
  return uv[Triangulation::Next(h)] != uv[Triangulation::Prev(twin)] ||
         uv[Triangulation::Prev(h)] != uv[Triangulation::Next(twin)];
}

Measurement Measure(const MappedFaces& faces) {
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

DistortionMeasure CutLength() {
  return {
      .group = "lengths",
      .figures = {{"cut_length", "length of the seams, surface of area 1 (Shay, Solomon, Stein)"}},
      .measure = Measure};
}

}  // namespace cirque
