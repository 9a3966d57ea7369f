#include "cirque/core/triangulation.h"

#include <utility>

#include <glog/logging.h>

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

namespace {

/// The corner next to `corner` about its vertex, counter-clockwise or clockwise; kNone at an open
/// edge.
Index Turn(const std::vector<Index>& twin, Index corner, bool counter_clockwise) {
  if (counter_clockwise) {
    const Index across = twin[Triangulation::Next(corner)];
    return across == kNone ? kNone : Triangulation::Next(across);
  }
  const Index across = twin[Triangulation::Prev(corner)];
  return across == kNone ? kNone : Triangulation::Prev(across);
}

/// Names all corners of one fan.
void NameFan(const std::vector<Index>& twin, Index corner, Index name, std::vector<Index>* fan) {
  for (const bool counter_clockwise : {true, false}) {
    for (Index c = corner; c != kNone; c = Turn(twin, c, counter_clockwise)) {
      (*fan)[c] = name;
      if (Turn(twin, c, counter_clockwise) == corner) return;
    }
  }
}

}  // namespace

Triangulation CutOpen(const Triangulation& t, const Cut& cut) {
  CHECK_EQ(static_cast<Index>(cut.edge.size()), t.num_edges());
  if (cut.IsEmpty()) return t;
  std::vector<Index> twin = t.twin, fan = t.vertex;
  std::vector<bool> opened(t.num_vertices, false);
  for (Index h = 0; h < t.num_halfedges(); ++h) {
    if (!cut.edge[t.edge[h]]) continue;
    twin[h] = kNone;
    opened[t.Tail(h)] = opened[t.Tip(h)] = true;
  }
  // The corners of all other vertices are one fan as they were.
  for (Index& v : fan) {
    if (opened[v]) v = kNone;
  }
  std::vector<bool> named(t.num_vertices, false);
  Index num_fans = t.num_vertices;
  for (Index c = 0; c < t.num_halfedges(); ++c) {
    if (fan[c] != kNone) continue;
    const Index v = t.vertex[c];
    NameFan(twin, c, named[v] ? num_fans++ : v, &fan);
    named[v] = true;
  }
  return NumberEdges(num_fans, std::move(fan), std::move(twin));
}

Patches ConnectedPatches(const Triangulation& t) {
  Patches patches;
  patches.of_face.assign(t.num_faces(), kNone);
  std::vector<Index> stack;
  for (Index seed = 0; seed < t.num_faces(); ++seed) {
    if (patches.of_face[seed] != kNone) continue;
    patches.of_face[seed] = patches.count;
    stack.assign(1, seed);
    while (!stack.empty()) {
      const Index face = stack.back();
      stack.pop_back();
      for (Index h = 3 * face; h < 3 * face + 3; ++h) {
        if (t.twin[h] == kNone) continue;
        const Index other = Triangulation::Face(t.twin[h]);
        if (patches.of_face[other] != kNone) continue;
        patches.of_face[other] = patches.count;
        stack.push_back(other);
      }
    }
    ++patches.count;
  }
  return patches;
}

}  // namespace cirque
