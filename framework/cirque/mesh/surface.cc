#include "cirque/mesh/surface.h"

#include <algorithm>
#include <cmath>
#include <tuple>

#include <glog/logging.h>

#include "cirque/core/grouping.h"

namespace cirque {

EdgeLengths MeasureEdgeLengths(const Surface& surface) {
  const Triangulation& t = surface.triangulation;
  EdgeLengths lengths;
  lengths.value.resize(t.num_edges());
  for (Index e = 0; e < t.num_edges(); ++e) {
    const Index h = t.edge_halfedge[e];
    const Eigen::Vector3d edge = surface.position[t.Tip(h)] - surface.position[t.Tail(h)];
    lengths.value[e] = std::hypot(edge.x(), edge.y(), edge.z());
  }
  return lengths;
}

namespace {

/// Gives the corners [first, last) of one vertex their texture coordinates, one for each different
/// UV.
void AttachAtVertex(const CornerUv& uv, std::vector<Index>::iterator first,
                    std::vector<Index>::iterator last, PolygonSoup* soup) {
  const auto key = [&](Index corner) {
    return std::tuple(uv.value[corner].x(), uv.value[corner].y(), corner);
  };
  std::sort(first, last, [&](Index a, Index b) { return key(a) < key(b); });
  for (auto corner = first; corner != last; ++corner) {
    if (corner == first || uv.value[*corner] != uv.value[*(corner - 1)]) {
      soup->texture.push_back(uv.value[*corner]);
    }
    soup->corner_texture[*corner] = static_cast<Index>(soup->texture.size()) - 1;
  }
}

}  // namespace

PolygonSoup AttachUv(const PolygonSoup& input, const Surface& surface, const CornerUv& uv) {
  const Triangulation& t = surface.triangulation;
  CHECK_EQ(uv.value.size(), t.vertex.size());
  PolygonSoup soup;
  soup.position = input.position;
  soup.first_corner.resize(t.num_faces() + 1);
  for (Index f = 0; f <= t.num_faces(); ++f) soup.first_corner[f] = 3 * f;
  soup.corner.reserve(t.vertex.size());
  for (const Index v : t.vertex) soup.corner.push_back(surface.soup_vertex[v]);
  soup.corner_texture.resize(t.vertex.size());
  Buckets corners_at = SortIntoBuckets(t.vertex, t.num_vertices);
  for (Index v = 0; v < t.num_vertices; ++v) {
    AttachAtVertex(uv, corners_at.item.begin() + corners_at.first[v],
                   corners_at.item.begin() + corners_at.first[v + 1], &soup);
  }
  return soup;
}

PolygonSoup TrianglesOf(const Surface& surface) {
  PolygonSoup soup;
  soup.position = surface.position;
  soup.corner = surface.triangulation.vertex;
  for (Index f = 1; f <= surface.triangulation.num_faces(); ++f) {
    soup.first_corner.push_back(3 * f);
  }
  return soup;
}

}  // namespace cirque
