#include "cirque/equivalence/double_surface.h"

#include <utility>
#include <vector>

namespace cirque {
namespace {

/// The mirror image of a halfedge of a surface with that many.
Index MirrorHalfedge(Index h, Index num_halfedges) {
  const Index k = h % 3;
  return num_halfedges + h - k + (k == 0 ? 0 : 3 - k);
}

}  // namespace

DoubledSurface DoubleSurface(const Triangulation& t, const EdgeLengths& lengths) {
  const Index n = t.num_halfedges();
  const std::vector<bool> boundary = BoundaryVertices(t);
  DoubledSurface doubled;
  std::vector<Index> image(t.num_vertices);
  for (Index v = 0; v < t.num_vertices; ++v) doubled.original.push_back(v);
  for (Index v = 0; v < t.num_vertices; ++v) {
    image[v] = boundary[v] ? v : static_cast<Index>(doubled.original.size());
    if (!boundary[v]) doubled.original.push_back(v);
  }
  std::vector<Index> vertex(t.vertex), twin(t.twin);
  vertex.resize(2 * n);
  twin.resize(2 * n);
  for (Index h = 0; h < n; ++h) {
    const Index mirror = MirrorHalfedge(h, n);
    vertex[mirror] = image[t.vertex[h]];
    twin[mirror] = t.twin[h] == kNone ? h : MirrorHalfedge(t.twin[h], n);
    if (t.twin[h] == kNone) twin[h] = mirror;
  }
  doubled.triangulation =
      NumberEdges(static_cast<Index>(doubled.original.size()), std::move(vertex), std::move(twin));
  doubled.lengths.value.resize(doubled.triangulation.num_edges());
  for (Index h = 0; h < n; ++h) {
    const double length = lengths.value[t.edge[h]];
    doubled.lengths.value[doubled.triangulation.edge[h]] = length;
    doubled.lengths.value[doubled.triangulation.edge[MirrorHalfedge(h, n)]] = length;
  }
  return doubled;
}

}  // namespace cirque
