#include "cirque/metrics/injectivity.h"

#include <algorithm>

#include "cirque/math/predicates.h"

namespace cirque {
namespace {

struct Segment {
  Index halfedge, tail, tip;
  Eigen::Vector2d a, b;

  double MinX() const { return std::min(a.x(), b.x()); }
  double MaxX() const { return std::max(a.x(), b.x()); }
  double MinY() const { return std::min(a.y(), b.y()); }
  double MaxY() const { return std::max(a.y(), b.y()); }
};

bool BoxesMeet(const Segment& s, const Segment& t) {
  return s.MinX() <= t.MaxX() && t.MinX() <= s.MaxX() && s.MinY() <= t.MaxY() &&
         t.MinY() <= s.MaxY();
}

/// Whether two closed segments have a point in common.
bool Meet(const Segment& s, const Segment& t) {
  return BoxesMeet(s, t) && OrientationSign(s.a, s.b, t.a) * OrientationSign(s.a, s.b, t.b) <= 0 &&
         OrientationSign(t.a, t.b, s.a) * OrientationSign(t.a, t.b, s.b) <= 0;
}

bool ShareVertex(const Segment& s, const Segment& t) {
  return s.tail == t.tail || s.tail == t.tip || s.tip == t.tail || s.tip == t.tip;
}

std::vector<Segment> BoundarySegments(const Triangulation& t, const CornerUv& uv) {
  std::vector<Segment> segments;
  for (Index h = 0; h < t.num_halfedges(); ++h) {
    if (t.twin[h] != kNone) continue;
    segments.push_back({h, t.Tail(h), t.Tip(h), uv.value[Triangulation::Next(h)],
                        uv.value[Triangulation::Prev(h)]});
  }
  std::sort(segments.begin(), segments.end(), [](const Segment& s, const Segment& r) {
    return std::pair(s.MinX(), s.halfedge) < std::pair(r.MinX(), r.halfedge);
  });
  return segments;
}

}  // namespace

std::vector<Index> FlippedFaces(const Triangulation& t, const CornerUv& uv) {
  std::vector<Index> flipped;
  for (Index f = 0; f < t.num_faces(); ++f) {
    if (OrientationSign(uv.value[3 * f], uv.value[3 * f + 1], uv.value[3 * f + 2]) <= 0) {
      flipped.push_back(f);
    }
  }
  return flipped;
}

std::vector<std::pair<Index, Index>> BoundaryCrossings(const Triangulation& t, const CornerUv& uv,
                                                       int limit) {
  std::vector<std::pair<Index, Index>> crossings;
  std::vector<const Segment*> active;
  const std::vector<Segment> segments = BoundarySegments(t, uv);
  for (const Segment& segment : segments) {
    std::erase_if(active, [&](const Segment* s) { return s->MaxX() < segment.MinX(); });
    for (const Segment* other : active) {
      if (ShareVertex(*other, segment) || !Meet(*other, segment)) continue;
      crossings.emplace_back(other->halfedge, segment.halfedge);
      if (static_cast<int>(crossings.size()) == limit) return crossings;
    }
    active.push_back(&segment);
  }
  return crossings;
}

}  // namespace cirque
