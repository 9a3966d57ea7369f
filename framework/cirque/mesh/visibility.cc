#include "cirque/mesh/visibility.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <Eigen/Geometry>
#include <glog/logging.h>

namespace cirque {
namespace {

using Point = Eigen::Vector3d;

/// Of barycentric weights: a ray along the edge between two triangles meets one of them.
constexpr double kRounding = 1e-12;

std::vector<Eigen::AlignedBox3d> BoxesOf(const Triangulation& t,
                                         const std::vector<Point>& position) {
  std::vector<Eigen::AlignedBox3d> boxes(t.num_faces());
  for (Index h = 0; h < t.num_halfedges(); ++h) {
    boxes[Triangulation::Face(h)].extend(position[t.vertex[h]]);
  }
  return boxes;
}

/// Six times the volume inside a closed surface, negative where it is inside out.
double SignedVolume(const Triangulation& t, const std::vector<Point>& position) {
  const Point& origin = position[t.vertex[0]];
  double volume = 0;
  for (Index h = 0; h < t.num_halfedges(); h += 3) {
    const auto at = [&](Index c) -> Point { return position[t.vertex[c]] - origin; };
    volume += at(h).dot(at(h + 1).cross(at(h + 2)));
  }
  return volume;
}

/// Whether a ray meets boxes (slabs: T. Kay, J. Kajiya, "Ray tracing complex scenes", 1986).
class Ray {
 public:
  Ray(const Point& from, const Point& direction)
      : from_(from), inverse_(direction.cwiseInverse()) {}

  bool Meets(const Eigen::AlignedBox3d& box) const {
    double enters = 0, leaves = std::numeric_limits<double>::infinity();
    for (int k = 0; k < 3; ++k) {
      const double a = (box.min()[k] - from_[k]) * inverse_[k];
      const double b = (box.max()[k] - from_[k]) * inverse_[k];
      enters = std::max(enters, std::min(a, b));
      leaves = std::min(leaves, std::max(a, b));
    }
    return enters <= leaves;
  }

 private:
  Point from_, inverse_;
};

}  // namespace

std::vector<Point> SpreadDirections(int count) {
  const double golden_angle = kPi * (3 - std::sqrt(5.0));
  std::vector<Point> directions;
  for (int i = 0; i < count; ++i) {
    const double z = 1 - (2 * i + 1.) / count, r = std::sqrt(1 - z * z), phi = i * golden_angle;
    directions.emplace_back(r * std::cos(phi), r * std::sin(phi), z);
  }
  return directions;
}

Visibility::Visibility(const Triangulation& triangulation, const std::vector<Point>& position,
                       int directions)
    : t_(triangulation),
      position_(position),
      directions_(SpreadDirections(directions)),
      tree_(BoxesOf(triangulation, position)) {
  CHECK_GT(directions, 0);
  const bool closed = std::find(t_.twin.begin(), t_.twin.end(), kNone) == t_.twin.end();
  if (closed && SignedVolume(t_, position_) < 0) side_ = -1;
}

Point Visibility::Normal(Index face) const {
  const Index h = 3 * face;
  return side_ * (At(h + 1) - At(h)).cross(At(h + 2) - At(h));
}

bool Visibility::FacesOutward(Index edge, const Point& direction) const {
  const Index h = t_.edge_halfedge[edge], twin = t_.twin[h];
  const Point normal = Normal(Triangulation::Face(h));
  const bool faces = normal.dot(direction) > 0;
  if (twin == kNone) return faces;
  const bool other = Normal(Triangulation::Face(twin)).dot(direction) > 0;
  const bool concave = normal.dot(At(twin) - At(h)) > 0;
  return concave ? faces && other : faces || other;
}

/// T. Möller, B. Trumbore, "Fast, minimum storage ray-triangle intersection", 1997.
bool Visibility::IsHit(Index face, const Point& from, const Point& direction) const {
  const Index h = 3 * face;
  const Point a = At(h + 1) - At(h), b = At(h + 2) - At(h), p = direction.cross(b);
  const double determinant = a.dot(p);
  if (determinant == 0) return false;
  const Point s = from - At(h), q = s.cross(a);
  const double u = s.dot(p) / determinant, v = direction.dot(q) / determinant;
  return u >= -kRounding && v >= -kRounding && u + v <= 1 + kRounding && b.dot(q) / determinant > 0;
}

bool Visibility::IsHidden(Index edge, const Point& from, const Point& direction) const {
  const Index h = t_.edge_halfedge[edge], twin = t_.twin[h];
  const Index own = Triangulation::Face(h);
  const Index other = twin == kNone ? own : Triangulation::Face(twin);
  const Ray ray(from, direction);
  bool hidden = false;
  tree_.VisitWhere([&](const Eigen::AlignedBox3d& box) { return !hidden && ray.Meets(box); },
                   [&](Index f) {
                     if (f != own && f != other && IsHit(f, from, direction)) hidden = true;
                   });
  return hidden;
}

double Visibility::Of(Index edge, int part, int parts) const {
  const Index h = t_.edge_halfedge[edge];
  const Point middle = 0.5 * (position_[t_.Tail(h)] + position_[t_.Tip(h)]);
  int seen = 0, looked = 0;
  for (std::size_t i = part; i < directions_.size(); i += parts, ++looked) {
    if (FacesOutward(edge, directions_[i]) && !IsHidden(edge, middle, directions_[i])) ++seen;
  }
  return static_cast<double>(seen) / looked;
}

}  // namespace cirque
