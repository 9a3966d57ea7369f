#include "cirque/domains/corner_places.h"

#include <fmt/format.h>

#include "cirque/core/solve_summary.h"
#include "cirque/core/text.h"
#include "cirque/metrics/injectivity.h"
#include "cirque/pipeline/finish_layout.h"

namespace cirque {

std::vector<std::complex<double>> PlacesOfVertices(const Triangulation& t, const CornerUv& uv) {
  std::vector<std::complex<double>> place(t.num_vertices);
  for (Index h = 0; h < t.num_halfedges(); ++h) {
    place[t.vertex[h]] = {uv.value[h].x(), uv.value[h].y()};
  }
  return place;
}

Status MeasurePlaced(const Surface& surface, const char* because, SurfaceMap* map) {
  const Triangulation& t = surface.triangulation;
  const std::vector<Index> flipped = FlippedFaces(t, map->uv);
  LayoutSummary& layout = Fill(&map->certificate.layout);
  layout.flipped_triangles = static_cast<int>(flipped.size());
  layout.float32_vanishing_triangles = static_cast<int>(FlippedFacesInFloat32(t, map->uv).size());
  if (!flipped.empty() && !map->exact_map) {
    return Status(
        StatusCode::kUnrepresentable,
        fmt::format("{}: faces {} (0-based) come out flipped", because, IdList(flipped, 5)));
  }
  MeasureDistortion(t, MeasureEdgeLengths(surface), map->cut, map->uv, &map->certificate);
  return Status();
}

Status PutCorners(const Surface& surface, const std::vector<std::complex<double>>& place,
                  const char* because, SurfaceMap* map) {
  map->uv.value.clear();
  for (const std::complex<double> z : place) map->uv.value.emplace_back(z.real(), z.imag());
  return MeasurePlaced(surface, because, map);
}

void ForgetProof(SurfaceMap* map) {
  map->flat.infeasibility = {};
  map->certificate.infeasibility = {};
}

void ForgetCut(const Triangulation& t, SurfaceMap* map) {
  map->cut.edge.assign(t.num_edges(), false);
  map->certificate.seams = SeamSummary();
  LayoutSummary& layout = Fill(&map->certificate.layout);
  layout.cut_length = layout.visible_cut_length = 0;
  layout.cones = 0;
}

}  // namespace cirque
