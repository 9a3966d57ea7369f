#include "cirque/verify/overlap_check.h"

#include <algorithm>
#include <numeric>
#include <tuple>
#include <utility>

#include <Eigen/Geometry>

namespace cirque::verify {

SegmentTree::SegmentTree(std::vector<Segment> segments)
    : segments_(std::move(segments)), order_(segments_.size()) {
  boxes_.reserve(segments_.size());
  for (const Segment& s : segments_) {
    boxes_.emplace_back(s.tail.cwiseMin(s.tip), s.tail.cwiseMax(s.tip));
  }
  std::iota(order_.begin(), order_.end(), 0);
  if (!order_.empty()) Build(0, static_cast<int>(order_.size()));
}

int SegmentTree::Build(int begin, int end) {
  constexpr int kLeafSize = 4;
  const int node = static_cast<int>(nodes_.size());
  nodes_.emplace_back();
  Eigen::AlignedBox2d box;
  for (int i = begin; i < end; ++i) box.extend(boxes_[order_[i]]);
  nodes_[node].box = box;
  nodes_[node].begin = begin;
  nodes_[node].end = end;
  if (end - begin <= kLeafSize) return node;
  const int axis = box.sizes().x() >= box.sizes().y() ? 0 : 1;
  const auto key = [&](int s) { return boxes_[s].min()[axis] / 2 + boxes_[s].max()[axis] / 2; };
  const int middle = begin + (end - begin) / 2;
  std::nth_element(order_.begin() + begin, order_.begin() + middle, order_.begin() + end,
                   [&](int a, int b) { return std::pair(key(a), a) < std::pair(key(b), b); });
  Build(begin, middle);
  const int right = Build(middle, end);
  nodes_[node].right = right;
  return node;
}

void SegmentTree::VisitTouchingBoxes(const std::function<bool(int, int)>& visit) const {
  if (!nodes_.empty()) VisitWithin(0, visit);
}

bool SegmentTree::VisitWithin(int node, const std::function<bool(int, int)>& visit) const {
  const Node& n = nodes_[node];
  if (n.right != 0) {
    return VisitWithin(node + 1, visit) && VisitWithin(n.right, visit) &&
           VisitBetween(node + 1, n.right, visit);
  }
  for (int i = n.begin; i < n.end; ++i) {
    for (int j = i + 1; j < n.end; ++j) {
      if (!VisitPair(order_[i], order_[j], visit)) return false;
    }
  }
  return true;
}

bool SegmentTree::VisitBetween(int a, int b, const std::function<bool(int, int)>& visit) const {
  const Node &m = nodes_[a], &n = nodes_[b];
  if (!m.box.intersects(n.box)) return true;
  const bool split_a = m.right != 0 && (n.right == 0 || m.end - m.begin >= n.end - n.begin);
  if (split_a) return VisitBetween(a + 1, b, visit) && VisitBetween(m.right, b, visit);
  if (n.right != 0) return VisitBetween(a, b + 1, visit) && VisitBetween(a, n.right, visit);
  for (int i = m.begin; i < m.end; ++i) {
    for (int j = n.begin; j < n.end; ++j) {
      if (!VisitPair(order_[i], order_[j], visit)) return false;
    }
  }
  return true;
}

bool SegmentTree::VisitPair(int i, int j, const std::function<bool(int, int)>& visit) const {
  if (!boxes_[i].intersects(boxes_[j])) return true;
  return visit(std::min(i, j), std::max(i, j));
}

namespace {

/// A boundary edge of the UV complex, the map on its left, and the edge before it on its loop.
struct BoundaryEdge {
  Index halfedge = kNone;
  Point tail, tip;
  Point before;  ///< the tail of the edge before

  Sector AtTail() const { return {tail, tip, before}; }
};

/// Turns counterclockwise round the tail of a boundary edge from corner to corner, calling
/// visit(corner) for each, and returns the last one.
template <class Visit>
Index ForEachCornerAtTail(const UvComplex& complex, Index boundary_halfedge, Visit visit) {
  Index corner = boundary_halfedge;
  visit(corner);
  while (complex.uv_twin[FanMesh::Prev(corner)] != kNone) {
    corner = complex.uv_twin[FanMesh::Prev(corner)];
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
    const Sector sector{apex, from, complex.uv[FanMesh::Prev(c)]};
    wraps = wraps || OnSameRay(apex, from, start) || Contains(sector, start);
  });
  return wraps;
}

std::vector<BoundaryEdge> CollectBoundary(const UvComplex& complex, OverlapResult* result) {
  std::vector<BoundaryEdge> edges;
  std::vector<Index> previous(complex.uv.size(), kNone);
  for (Index h = 0; h < static_cast<Index>(complex.uv.size()); ++h) {
    if (complex.uv_twin[h] != kNone) continue;
    const Index last = ForEachCornerAtTail(complex, h, [](Index) {});
    previous[h] = FanMesh::Prev(last);
    edges.push_back({h, complex.Tail(h), complex.Tip(h), complex.Tail(previous[h])});
    if (WrapsAtTail(complex, h)) result->wrapped_boundary.push_back(complex.mesh().Tail(h));
  }
  result->num_boundary_edges = static_cast<Index>(edges.size());
  for (const BoundaryEdge& edge : edges) {
    if (previous[edge.halfedge] == kNone) continue;
    ++result->num_boundary_loops;
    for (Index h = edge.halfedge; previous[h] != kNone;) h = std::exchange(previous[h], kNone);
  }
  return edges;
}

bool LexicographicallyLess(const Point& a, const Point& b) {
  return a.x() < b.x() || (a.x() == b.x() && a.y() < b.y());
}

/// Collinear edges that run the same way along a common piece: both have the map on their left.
bool RunTogether(const BoundaryEdge& s, const BoundaryEdge& t) {
  const auto ends = [](const BoundaryEdge& e) {
    const bool rising = LexicographicallyLess(e.tail, e.tip);
    return std::tuple(rising ? e.tail : e.tip, rising ? e.tip : e.tail, rising);
  };
  const auto [s_low, s_high, s_rising] = ends(s);
  const auto [t_low, t_high, t_rising] = ends(t);
  return s_rising == t_rising && LexicographicallyLess(s_low, t_high) &&
         LexicographicallyLess(t_low, s_high);
}

/// Whether the map overlaps itself where the tail of t lies on s (not at its tip: then the edge
/// after s has its tail there too).
bool OverlapAtTail(const BoundaryEdge& s, const BoundaryEdge& t) {
  if (t.tail == s.tail) return Overlap(s.AtTail(), t.AtTail());
  if (!OnOpenSegment(t.tail, s.tail, s.tip)) return false;
  return Overlap({t.tail, s.tip, s.tail}, t.AtTail());
}

bool Cross(const BoundaryEdge& s, const BoundaryEdge& t) {
  const int t_tail = Orientation(s.tail, s.tip, t.tail);
  const int t_tip = Orientation(s.tail, s.tip, t.tip);
  if (t_tail * t_tip > 0) return false;
  const int s_tail = Orientation(t.tail, t.tip, s.tail);
  const int s_tip = Orientation(t.tail, t.tip, s.tip);
  if (s_tail * s_tip > 0) return false;
  if (t_tail * t_tip < 0 && s_tail * s_tip < 0) return true;
  if (t_tail == 0 && t_tip == 0 && RunTogether(s, t)) return true;
  return OverlapAtTail(s, t) || OverlapAtTail(t, s);
}

void FindCrossings(const std::vector<BoundaryEdge>& edges, OverlapResult* result) {
  std::vector<SegmentTree::Segment> segments;
  segments.reserve(edges.size());
  for (const BoundaryEdge& e : edges) segments.push_back({e.tail, e.tip});
  SegmentTree(std::move(segments)).VisitTouchingBoxes([&](int i, int j) {
    if (!Cross(edges[i], edges[j])) return true;
    const std::pair found(edges[i].halfedge, edges[j].halfedge);
    if (result->num_crossings++ == 0 || found < result->first_crossing) {
      result->first_crossing = found;
    }
    return result->num_crossings < OverlapResult::kMaxCrossings;
  });
}

/// A patch's boundary, its bounding box and one of its triangles.
struct PatchOutline {
  std::vector<BoundaryEdge> edges;
  Eigen::AlignedBox2d box;
  Index triangle = kNone;
};

std::vector<PatchOutline> Outlines(const UvComplex& complex,
                                   const std::vector<BoundaryEdge>& edges) {
  std::vector<PatchOutline> outlines(complex.num_patches);
  for (const BoundaryEdge& e : edges) {
    PatchOutline& outline = outlines[complex.patch[e.halfedge / 3]];
    outline.edges.push_back(e);
    outline.box.extend(e.tail);
    outline.triangle = e.halfedge / 3;
  }
  return outlines;
}

bool Encloses(const UvComplex& complex, const PatchOutline& outer, const PatchOutline& inner) {
  if (inner.triangle == kNone || !outer.box.contains(inner.box)) return false;
  const Point triangle[3] = {complex.uv[3 * inner.triangle], complex.uv[3 * inner.triangle + 1],
                             complex.uv[3 * inner.triangle + 2]};
  int winding = 0;
  for (const BoundaryEdge& e : outer.edges) winding += RayCrossing(triangle, e.tail, e.tip);
  return winding != 0;
}

void FindNestedPatches(const UvComplex& complex, const std::vector<BoundaryEdge>& edges,
                       OverlapResult* result) {
  const std::vector<PatchOutline> outlines = Outlines(complex, edges);
  for (Index a = 0; a < complex.num_patches; ++a) {
    for (Index b = 0; b < complex.num_patches; ++b) {
      if (a == b || !Encloses(complex, outlines[a], outlines[b])) continue;
      result->nested_patches = {a, b};
      return;
    }
  }
}

}  // namespace

OverlapResult CheckOverlap(const UvComplex& complex) {
  OverlapResult result;
  const std::vector<BoundaryEdge> edges = CollectBoundary(complex, &result);
  FindCrossings(edges, &result);
  if (result.num_crossings == 0) FindNestedPatches(complex, edges, &result);
  return result;
}

}  // namespace cirque::verify
