#include "cirque/mesh/puncture.h"

#include <algorithm>
#include <utility>

#include <fmt/format.h>
#include <glog/logging.h>

namespace cirque {
namespace {

Index FirstCorner(const Triangulation& t, Index v) {
  const auto found = std::find(t.vertex.begin(), t.vertex.end(), v);
  CHECK(found != t.vertex.end()) << "vertex " << v << " has no corner";
  return static_cast<Index>(found - t.vertex.begin());
}

/// The vertices that are left get new numbers in their old order; kNone for the pole.
std::vector<Index> NumberVertices(const Triangulation& t, PuncturedSurface* punctured) {
  std::vector<Index> number(t.num_vertices, kNone);
  for (const Index f : punctured->face) {
    for (Index h = 3 * f; h < 3 * f + 3; ++h) number[t.vertex[h]] = 0;
  }
  for (Index v = 0; v < t.num_vertices; ++v) {
    if (number[v] == kNone) continue;
    number[v] = static_cast<Index>(punctured->vertex.size());
    punctured->vertex.push_back(v);
  }
  return number;
}

}  // namespace

std::vector<Index> CornersAround(const Triangulation& t, Index corner) {
  std::vector<Index> corners;
  Index c = corner;
  do {
    corners.push_back(c);
    c = Triangulation::Next(t.twin[Triangulation::Next(c)]);
  } while (c != corner);
  return corners;
}

bool HasDiskStar(const Triangulation& t, Index corner) {
  std::vector<Index> closed = {t.vertex[corner]};
  for (const Index c : CornersAround(t, corner)) closed.push_back(t.Tail(c));
  std::sort(closed.begin(), closed.end());
  return closed.size() > 3 && std::adjacent_find(closed.begin(), closed.end()) == closed.end();
}

StatusOr<PuncturedSurface> Puncture(const Triangulation& t, Index pole) {
  const Index corner = FirstCorner(t, pole);
  if (!HasDiskStar(t, corner)) {
    return Status::InvalidInput(
        fmt::format("the triangles around vertex {} (0-based) form no disk; take another", pole));
  }
  PuncturedSurface punctured;
  punctured.pole = pole;
  std::vector<bool> removed(t.num_faces(), false);
  for (const Index c : CornersAround(t, corner)) {
    removed[Triangulation::Face(c)] = true;
    punctured.link.push_back(t.Tail(c));
  }
  std::vector<Index> face_number(t.num_faces(), kNone);
  for (Index f = 0; f < t.num_faces(); ++f) {
    if (removed[f]) continue;
    face_number[f] = static_cast<Index>(punctured.face.size());
    punctured.face.push_back(f);
  }
  if (punctured.face.empty()) {
    return Status::InvalidInput("all triangles meet in one vertex; there is nothing to map");
  }
  const std::vector<Index> number = NumberVertices(t, &punctured);
  std::vector<Index> vertex, twin;
  for (const Index f : punctured.face) {
    for (Index h = 3 * f; h < 3 * f + 3; ++h) {
      vertex.push_back(number[t.vertex[h]]);
      const Index other = face_number[Triangulation::Face(t.twin[h])];
      twin.push_back(other == kNone ? kNone : 3 * other + t.twin[h] % 3);
    }
  }
  const auto num_vertices = static_cast<Index>(punctured.vertex.size());
  punctured.triangulation = NumberEdges(num_vertices, std::move(vertex), std::move(twin));
  return punctured;
}

}  // namespace cirque
