#include "cirque/core/triangulation.h"

#include <utility>

namespace cirque {

Triangulation NumberEdges(Index num_vertices, std::vector<Index> vertex, std::vector<Index> twin) {
  Triangulation t;
  t.num_vertices = num_vertices;
  t.vertex = std::move(vertex);
  t.twin = std::move(twin);
  t.edge.resize(t.vertex.size());
  for (Index h = 0; h < t.num_halfedges(); ++h) {
    const bool first_of_edge = t.twin[h] == kNone || t.twin[h] > h;
    t.edge[h] = first_of_edge ? t.num_edges() : t.edge[t.twin[h]];
    if (first_of_edge) t.edge_halfedge.push_back(h);
  }
  return t;
}

std::vector<bool> BoundaryVertices(const Triangulation& t) {
  std::vector<bool> on_boundary(t.num_vertices, false);
  for (Index h = 0; h < t.num_halfedges(); ++h) {
    if (t.twin[h] == kNone) on_boundary[t.Tail(h)] = on_boundary[t.Tip(h)] = true;
  }
  return on_boundary;
}

std::vector<Index> CornersPerVertex(const Triangulation& t) {
  std::vector<Index> corners(t.num_vertices, 0);
  for (const Index v : t.vertex) ++corners[v];
  return corners;
}

namespace {

/// The boundary halfedge that starts where the boundary halfedge h ends: turn about the tip of h.
Index NextOnBoundary(const Triangulation& t, Index h) {
  Index g = Triangulation::Next(h);
  while (t.twin[g] != kNone) g = Triangulation::Next(t.twin[g]);
  return g;
}

}  // namespace

std::vector<std::vector<Index>> BoundaryLoops(const Triangulation& t) {
  std::vector<std::vector<Index>> loops;
  std::vector<bool> seen(t.num_halfedges(), false);
  for (Index start = 0; start < t.num_halfedges(); ++start) {
    if (t.twin[start] != kNone || seen[start]) continue;
    std::vector<Index>& loop = loops.emplace_back();
    for (Index h = start; !seen[h]; h = NextOnBoundary(t, h)) {
      seen[h] = true;
      loop.push_back(h);
    }
  }
  return loops;
}

Index EulerCharacteristic(const Triangulation& t) {
  return t.num_vertices - t.num_edges() + t.num_faces();
}

}  // namespace cirque
