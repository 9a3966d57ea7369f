#include "cirque/metrics/injectivity.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>

#include "cirque/math/compensated_sum.h"
#include "cirque/math/predicates.h"

namespace cirque {
namespace {

using Eigen::Vector3d;

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

/// How two closed segments lie to each other.
BoundaryContact Contact(const Segment& s, const Segment& t) {
  if (!BoxesMeet(s, t)) return BoundaryContact::kApart;
  const int of_t = OrientationSign(s.a, s.b, t.a) * OrientationSign(s.a, s.b, t.b);
  if (of_t > 0) return BoundaryContact::kApart;
  const int of_s = OrientationSign(t.a, t.b, s.a) * OrientationSign(t.a, t.b, s.b);
  if (of_s > 0) return BoundaryContact::kApart;
  return of_t < 0 && of_s < 0 ? BoundaryContact::kCrossing : BoundaryContact::kTouch;
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

std::vector<Index> FlippedFacesInFloat32(const Triangulation& t, const CornerUv& uv) {
  CornerUv rounded = uv;
  for (Eigen::Vector2d& x : rounded.value) x = x.cast<float>().cast<double>();
  return FlippedFaces(t, rounded);
}

BoundaryContact FindBoundaryContact(const Triangulation& t, const CornerUv& uv) {
  BoundaryContact strongest = BoundaryContact::kApart;
  std::vector<const Segment*> active;
  const std::vector<Segment> segments = BoundarySegments(t, uv);
  for (const Segment& segment : segments) {
    std::erase_if(active, [&](const Segment* s) { return s->MaxX() < segment.MinX(); });
    for (const Segment* other : active) {
      if (ShareVertex(*other, segment)) continue;
      strongest = std::max(strongest, Contact(*other, segment));
      if (strongest == BoundaryContact::kCrossing) return strongest;
    }
    active.push_back(&segment);
  }
  return strongest;
}

std::vector<Index> FlippedSphericalFaces(const Triangulation& t,
                                         const std::vector<Vector3d>& position) {
  std::vector<Index> flipped;
  for (Index h = 0; h < t.num_halfedges(); h += 3) {
    // From the origin, which is inside, the triangle must turn clockwise.
    const int sign = OrientationSign3(position[t.vertex[h]], position[t.vertex[h + 1]],
                                      position[t.vertex[h + 2]], Vector3d::Zero());
    if (sign >= 0) flipped.push_back(Triangulation::Face(h));
  }
  return flipped;
}

double SphericalDegree(const Triangulation& t, const std::vector<Vector3d>& position) {
  CompensatedSum area;
  for (Index h = 0; h < t.num_halfedges(); h += 3) {
    const Vector3d &a = position[t.vertex[h]], &b = position[t.vertex[h + 1]],
                   &c = position[t.vertex[h + 2]];
    area += 2 * std::atan2(a.dot((b - a).cross(c - a)), 1 + a.dot(b) + b.dot(c) + c.dot(a));
  }
  return area.Value() / (4 * kPi);
}

}  // namespace cirque
