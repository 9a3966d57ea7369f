#include "cirque/domains/corner_places.h"

#include <fmt/format.h>

#include "cirque/core/solve_summary.h"
#include "cirque/core/text.h"
#include "cirque/metrics/injectivity.h"
#include "cirque/pipeline/finish_layout.h"

namespace cirque {

Status PutCorners(const Surface& surface, const std::vector<std::complex<double>>& place,
                  const char* because, SurfaceMap* map) {
  const Triangulation& t = surface.triangulation;
  map->uv.value.resize(t.num_halfedges());
  for (Index h = 0; h < t.num_halfedges(); ++h) {
    map->uv.value[h] = {place[h].real(), place[h].imag()};
  }
  const std::vector<Index> flipped = FlippedFaces(t, map->uv);
  LayoutSummary& layout = Fill(&map->certificate.layout);
  layout.flipped_triangles = static_cast<int>(flipped.size());
  layout.float32_vanishing_triangles = static_cast<int>(FlippedFacesInFloat32(t, map->uv).size());
  if (!flipped.empty()) {
    return Status(
        StatusCode::kUnrepresentable,
        fmt::format("{}: faces {} (0-based) come out flipped", because, IdList(flipped, 5)));
  }
  MeasureDistortion(t, MeasureEdgeLengths(surface), map->cut, map->uv, &map->certificate);
  return Status();
}

void ForgetCut(const Triangulation& t, SurfaceMap* map) {
  map->cut.edge.assign(t.num_edges(), false);
  map->certificate.seams = SeamSummary();
  LayoutSummary& layout = Fill(&map->certificate.layout);
  layout.cut_length = layout.visible_cut_length = 0;
  layout.cones = 0;
}

}  // namespace cirque
