#include "cirque/core/cut.h"

#include <utility>

#include <glog/logging.h>

namespace cirque {
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
  std::vector<Index> twin = t.twin;
  for (Index h = 0; h < t.num_halfedges(); ++h) {
    if (cut.edge[t.edge[h]]) twin[h] = kNone;
  }
  std::vector<Index> fan(t.num_halfedges(), kNone);
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
  std::vector<Index> queue;
  for (Index seed = 0; seed < t.num_faces(); ++seed) {
    if (patches.of_face[seed] != kNone) continue;
    patches.of_face[seed] = patches.count;
    queue.assign(1, seed);
    for (std::size_t head = 0; head < queue.size(); ++head) {
      for (Index h = 3 * queue[head]; h < 3 * queue[head] + 3; ++h) {
        if (t.twin[h] == kNone) continue;
        Index& patch = patches.of_face[Triangulation::Face(t.twin[h])];
        if (patch != kNone) continue;
        patch = patches.count;
        queue.push_back(Triangulation::Face(t.twin[h]));
      }
    }
    ++patches.count;
  }
  return patches;
}

}  // namespace cirque
