#include "cirque/math/image_overlap.h"

#include <utility>

#include "cirque/math/boundary_sweep.h"
#include "cirque/math/plane_order.h"

namespace cirque {
namespace {

Index Next(Index h) { return h % 3 == 2 ? h - 2 : h + 1; }
Index Prev(Index h) { return h % 3 == 0 ? h + 2 : h - 1; }

/// Turns counterclockwise round the tail of a boundary side from corner to corner, calling
/// visit(corner) for each, and returns the last one.
template <class Visit>
Index ForEachCornerAtTail(const ImageTriangles& image, Index side, Visit visit) {
  Index corner = side;
  visit(corner);
  while (image.twin[Prev(corner)] != kNone) {
    corner = image.twin[Prev(corner)];
    visit(corner);
  }
  return corner;
}

/// Whether the corners at the tail of a boundary side go round by more than 2 pi.
bool WrapsAtTail(const ImageTriangles& image, Index side) {
  const Eigen::Vector2d& apex = image.uv[side];
  const Eigen::Vector2d& start = image.uv[Next(side)];
  bool wraps = false;
  ForEachCornerAtTail(image, side, [&](Index c) {
    if (c == side) return;
    const Eigen::Vector2d& from = image.uv[Next(c)];
    const Sector sector{apex, from, image.uv[Prev(c)]};
    wraps = wraps || OnSameRay(apex, from, start) || IsInSector(sector, start);
  });
  return wraps;
}

/// The boundary sides; on the way their loops are counted.
std::vector<Index> CollectBoundary(const ImageTriangles& image, ImageOverlap* result) {
  std::vector<Index> boundary, previous(image.uv.size(), kNone);
  for (Index h = 0; h < static_cast<Index>(image.uv.size()); ++h) {
    if (image.twin[h] != kNone) continue;
    boundary.push_back(h);
    previous[h] = Prev(ForEachCornerAtTail(image, h, [](Index) {}));
    if (WrapsAtTail(image, h)) result->wrapped.push_back(h);
  }
  result->num_boundary_edges = static_cast<Index>(boundary.size());
  for (const Index first : boundary) {
    if (previous[first] == kNone) continue;
    ++result->num_boundary_loops;
    for (Index h = first; previous[h] != kNone;) h = std::exchange(previous[h], kNone);
  }
  return boundary;
}

}  // namespace

ImageOverlap FindImageOverlap(const ImageTriangles& image) {
  ImageOverlap result;
  const std::vector<Index> boundary = CollectBoundary(image, &result);
  std::vector<DirectedSegment> segments;
  segments.reserve(boundary.size());
  for (const Index h : boundary) segments.push_back({image.uv[h], image.uv[Next(h)]});
  if (const auto found = FindOverlap(segments)) {
    const auto [a, b] = *found;
    result.overlap = std::pair(boundary[a], boundary[b]);
    result.crosses = Intersect(segments[a], segments[b]);
  }
  return result;
}

}  // namespace cirque
