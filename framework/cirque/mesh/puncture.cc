#include "cirque/mesh/puncture.h"

#include <algorithm>

#include <fmt/format.h>
#include <glog/logging.h>

namespace cirque {
namespace {

Index FirstCorner(const Triangulation& t, Index v) {
  const auto found = std::find(t.vertex.begin(), t.vertex.end(), v);
  CHECK(found != t.vertex.end()) << "vertex " << v << " has no corner";
  return static_cast<Index>(found - t.vertex.begin());
}

}  // namespace

bool HasDiskStar(const Triangulation& t, Index corner) {
  std::vector<Index> closed = {t.vertex[corner]};
  t.ForEachCornerAround(corner, [&](Index c) { closed.push_back(t.Tail(c)); });
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
  std::vector<bool> keep(t.num_faces(), true);
  t.ForEachCornerAround(corner, [&](Index c) {
    keep[Triangulation::Face(c)] = false;
    punctured.link.push_back(t.Tail(c));
  });
  if (std::find(keep.begin(), keep.end(), true) == keep.end()) {
    return Status::InvalidInput("all triangles meet in one vertex; there is nothing to map");
  }
  static_cast<SubTriangulation&>(punctured) = KeepFaces(t, keep);
  return punctured;
}

}  // namespace cirque
