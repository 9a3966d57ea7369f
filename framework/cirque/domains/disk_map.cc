#include "cirque/domains/disk_map.h"

#include <algorithm>
#include <utility>

#include "cirque/core/solve_summary.h"
#include "cirque/metrics/injectivity.h"
#include "cirque/pipeline/finish_layout.h"

namespace cirque {

Status DiskUnrepresentable(const std::string& what) {
  return Status(StatusCode::kUnrepresentable, "the map exists but " + what +
                                                  " of double coordinates do not tell its vertices "
                                                  "apart; a rectangle or the plane may hold it");
}

Index FileNumber(const Surface& surface, Index v) {
  return v == kNone ? kNone : surface.soup_vertex[v];
}

Index CountFalse(const std::vector<bool>& flags) {
  return static_cast<Index>(std::count(flags.begin(), flags.end(), false));
}

void DeliverDisk(const Triangulation& t, const EdgeLengths& lengths, CornerUv uv, SurfaceMap* map) {
  const Timer timer;
  map->uv = std::move(uv);
  map->cut.edge.assign(t.num_edges(), false);
  const std::size_t flipped = map->exact_map ? FlippedFaces(t, map->uv).size() : 0;
  Fill(&map->certificate.layout).flipped_triangles = static_cast<int>(flipped);
  MeasureDistortion(t, lengths, map->cut, map->uv, &map->certificate);
  map->certificate.seconds.measures = timer.Seconds();
}

}  // namespace cirque
