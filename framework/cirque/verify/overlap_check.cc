#include "cirque/verify/overlap_check.h"

#include <utility>

#include "cirque/verify/boundary_sweep.h"

namespace cirque::verify {
namespace {

/// Turns counterclockwise round the tail of a boundary edge from corner to corner, calling
/// visit(corner) for each, and returns the last one.
template <class Visit>
Index ForEachCornerAtTail(const UvComplex& complex, Index boundary_halfedge, Visit visit) {
  Index corner = boundary_halfedge;
  visit(corner);
  while (complex.uv_twin[TriangleMesh::Prev(corner)] != kNone) {
    corner = complex.uv_twin[TriangleMesh::Prev(corner)];
    visit(corner);
  }
  return corner;
}

/// Whether the corners at the tail of a boundary edge go round by more than 2 pi.
bool WrapsAtTail(const UvComplex& complex, Index boundary_halfedge) {
  const Point& apex = complex.Tail(boundary_halfedge);
  const Point& start = complex.Tip(boundary_halfedge);
  bool wraps = false;
  ForEachCornerAtTail(complex, boundary_halfedge, [&](Index c) {
    if (c == boundary_halfedge) return;
    const Point& from = complex.Tip(c);
    const Sector sector{apex, from, complex.uv[TriangleMesh::Prev(c)]};
    wraps = wraps || OnSameRay(apex, from, start) || Contains(sector, start);
  });
  return wraps;
}

/// The boundary halfedges; on the way their loops are counted.
std::vector<Index> CollectBoundary(const UvComplex& complex, OverlapResult* result) {
  std::vector<Index> boundary, previous(complex.uv.size(), kNone);
  for (Index h = 0; h < static_cast<Index>(complex.uv.size()); ++h) {
    if (complex.uv_twin[h] != kNone) continue;
    boundary.push_back(h);
    previous[h] = TriangleMesh::Prev(ForEachCornerAtTail(complex, h, [](Index) {}));
    if (WrapsAtTail(complex, h)) result->wrapped_boundary.push_back(complex.mesh().Tail(h));
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

OverlapResult CheckOverlap(const UvComplex& complex) {
  OverlapResult result;
  const std::vector<Index> boundary = CollectBoundary(complex, &result);
  std::vector<DirectedSegment> segments;
  segments.reserve(boundary.size());
  for (const Index h : boundary) segments.push_back({complex.Tail(h), complex.Tip(h)});
  if (const auto found = FindOverlap(segments)) {
    const auto [a, b] = *found;
    result.overlap = std::pair(boundary[a], boundary[b]);
    result.crosses = Intersect(segments[a], segments[b]);
  }
  return result;
}

}  // namespace cirque::verify
