#include "cirque/lattice/flat_domain.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "cirque/intrinsic/intrinsic_surface.h"

namespace cirque {
namespace {

using Point = Eigen::Vector2d;

constexpr double kRounding = 1e-11;  ///< by which a point may lie outside its face, relatively
constexpr int kMostFaces = 1 << 14;  ///< that a way may cross; more is rounding going in circles

/// A straight way through the faces of a domain, in the frame of the face where it is.
class Way {
 public:
  Way(const FlatDomain& domain, const FlatPoint& from, const Point& target)
      : domain_(domain), face_(from.face), from_(from.at), target_(target) {}

  std::optional<FlatDomain::Arrival> Follow() {
    if (!LeaveVertex()) return std::nullopt;
    for (int i = 0; i < kMostFaces; ++i) {
      if (IsHere()) return FlatDomain::Arrival{{face_, target_}, back_};
      if (!Cross(Exit())) return std::nullopt;
    }
    return std::nullopt;
  }

 private:
  /// Which side of the way a corner is on: positive on its left.
  double Side(Index corner) const { return cirque::Cross(from_, target_, domain_.Corner(corner)); }

  /// Where it begins at a vertex: to the face there that it leads into.
  bool LeaveVertex() {
    for (Index c = 3 * face_; c < 3 * face_ + 3; ++c) {
      if (domain_.Corner(c) == from_) return TurnAround(c);
    }
    return true;
  }

  bool TurnAround(Index corner) {
    const Index first = corner;
    do {
      from_ = domain_.Corner(corner);
      if (IsInWedge(corner)) {
        entered_ = kNone;
        start_ = corner;
        return true;
      }
      if (!Cross(Triangulation::Next(corner))) return false;
      corner = Triangulation::Next(entered_);
    } while (corner != first);
    return from_ == target_;
  }

  bool IsInWedge(Index corner) const {
    const Index right = Triangulation::Next(corner), left = Triangulation::Prev(corner);
    const double step = kRounding * (target_ - from_).norm();
    return Side(right) <= step * (domain_.Corner(right) - from_).norm() &&
           Side(left) >= -step * (domain_.Corner(left) - from_).norm();
  }

  bool IsHere() const {
    const Index a = 3 * face_;
    const double least =
        -kRounding * cirque::Cross(domain_.Corner(a), domain_.Corner(a + 1), domain_.Corner(a + 2));
    return Outside(a) <= -least && Outside(a + 1) <= -least && Outside(a + 2) <= -least;
  }

  /// The side by which it leaves the face.
  Index Exit() const {
    if (entered_ != kNone) {
      return Side(entered_) >= 0 ? Triangulation::Next(entered_) : Triangulation::Prev(entered_);
    }
    if (start_ != kNone) return start_;
    for (Index h = 3 * face_; h < 3 * face_ + 3; ++h) {
      if (Side(Triangulation::Next(h)) <= 0 && Side(Triangulation::Prev(h)) > 0 && Outside(h) > 0)
        return h;
    }
    return Farthest();
  }

  /// How far the target is beyond a side, as twice an area.
  double Outside(Index h) const {
    return -cirque::Cross(domain_.Corner(Triangulation::Next(h)),
                          domain_.Corner(Triangulation::Prev(h)), target_);
  }

  Index Farthest() const {
    Index best = 3 * face_;
    for (Index h = best + 1; h < 3 * face_ + 3; ++h) {
      if (Outside(h) > Outside(best)) best = h;
    }
    return best;
  }

  bool Cross(Index h) {
    const Index twin = domain_.triangulation().twin[h];
    if (twin == kNone) return false;
    const RigidMotion& into = domain_.Across(twin);  // from this frame to that one
    from_ = into(from_);
    target_ = into(target_);
    back_ = back_ * domain_.Across(h);
    face_ = Triangulation::Face(twin);
    entered_ = twin;
    start_ = kNone;
    return true;
  }

  const FlatDomain& domain_;
  Index face_;
  Point from_, target_;
  RigidMotion back_;
  Index entered_ = kNone, start_ = kNone;
};

}  // namespace

FlatDomain::FlatDomain(Triangulation triangulation, const EdgeLengths& lengths)
    : triangulation_(std::move(triangulation)) {
  PlaceCorners(lengths);
  FindKinds();
  TraceLoops();
}

void FlatDomain::PlaceCorners(const EdgeLengths& lengths) {
  const Triangulation& t = triangulation_;
  corner_.resize(t.vertex.size());
  for (Index h = 0; h < t.num_halfedges(); h += 3) {
    const double a = lengths.value[t.edge[h]], b = lengths.value[t.edge[h + 1]],
                 c = lengths.value[t.edge[h + 2]];
    const double x = (b * b + c * c - a * a) / (2 * c);
    corner_[h] = Point(0, 0);
    corner_[h + 1] = Point(c, 0);
    corner_[h + 2] = Point(x, std::sqrt(std::max(0., (b - x) * (b + x))));
    area_ += c * corner_[h + 2].y() / 2;
  }
  across_.resize(t.vertex.size());
  for (Index h = 0; h < t.num_halfedges(); ++h) {
    const Index twin = t.twin[h];
    if (twin == kNone) continue;
    across_[h] = RigidMotion::Aligning(
        corner_[Triangulation::Next(twin)], corner_[Triangulation::Prev(twin)],
        corner_[Triangulation::Prev(h)], corner_[Triangulation::Next(h)]);
  }
  for (Index h = 0; h < t.num_halfedges(); ++h) {  // inverse to each other to the last digit
    if (t.twin[h] > h) across_[t.twin[h]] = across_[h].Inverse();
  }
}

void FlatDomain::FindKinds() {
  on_boundary_ = BoundaryVertices(triangulation_);
  is_cone_.assign(triangulation_.num_vertices, false);
  std::vector<double> sum(triangulation_.num_vertices, 0);
  for (Index c = 0; c < triangulation_.num_halfedges(); ++c) {
    const Point a = corner_[Triangulation::Next(c)] - corner_[c];
    const Point b = corner_[Triangulation::Prev(c)] - corner_[c];
    sum[triangulation_.vertex[c]] += std::atan2(a.x() * b.y() - a.y() * b.x(), a.dot(b));
  }
  for (Index v = 0; v < triangulation_.num_vertices; ++v) {
    is_cone_[v] = !on_boundary_[v] && std::abs(sum[v] - 2 * kPi) > kFlatAngle;
  }
}

void FlatDomain::TraceLoops() {
  const Triangulation& t = triangulation_;
  for (std::vector<Index>& halfedges : BoundaryLoops(t)) {
    Loop loop{std::move(halfedges), {0}, {RigidMotion()}};
    for (const Index h : loop.halfedges) {
      const double length =
          (corner_[Triangulation::Next(h)] - corner_[Triangulation::Prev(h)]).norm();
      loop.begin.push_back(loop.begin.back() + length);
      RigidMotion to_first = loop.to_first.back();
      for (Index side = Triangulation::Prev(Triangulation::Prev(h)); t.twin[side] != kNone;) {
        to_first = to_first * across_[side];
        side = Triangulation::Prev(Triangulation::Prev(t.twin[side]));
      }
      loop.to_first.push_back(to_first);
    }
    loops_.push_back(std::move(loop));
  }
}

Eigen::Vector3d FlatDomain::Barycentric(const FlatPoint& point) const {
  const Point& a = corner_[3 * point.face];
  const Point& b = corner_[3 * point.face + 1];
  const Point& c = corner_[3 * point.face + 2];
  const Eigen::Vector3d areas(cirque::Cross(b, c, point.at), cirque::Cross(c, a, point.at),
                              cirque::Cross(a, b, point.at));
  return areas / cirque::Cross(a, b, c);
}

std::optional<FlatDomain::Arrival> FlatDomain::Trace(const FlatPoint& from,
                                                     const Point& target) const {
  return Way(*this, from, target).Follow();
}

std::size_t FlatDomain::PieceAt(const Loop& loop, double distance) const {
  const auto above = std::upper_bound(loop.begin.begin(), loop.begin.end(), distance);
  const auto piece = std::max<std::ptrdiff_t>(above - loop.begin.begin() - 1, 0);
  return std::min(static_cast<std::size_t>(piece), loop.halfedges.size() - 1);
}

FlatPoint FlatDomain::OnLoop(Index index, double distance) const {
  const Loop& loop = loops_[index];
  distance -= std::floor(distance / loop.length()) * loop.length();
  const std::size_t i = PieceAt(loop, distance);
  const Index h = loop.halfedges[i];
  const double along =
      std::clamp((distance - loop.begin[i]) / (loop.begin[i + 1] - loop.begin[i]), 0., 1.);
  const Point& tail = corner_[Triangulation::Next(h)];
  if (along == 0) return {Triangulation::Face(h), tail};
  return {Triangulation::Face(h), (1 - along) * tail + along * corner_[Triangulation::Prev(h)]};
}

FlatDomain::Arrival FlatDomain::AlongLoop(Index index, double from, double to) const {
  const Loop& loop = loops_[index];
  // The frame at a distance, as seen from the first halfedge: once round is the last of to_first.
  const auto frame = [&](double distance) {
    const double turns = std::floor(distance / loop.length());
    RigidMotion whole;
    for (int i = 0; i < std::abs(turns); ++i) {
      whole = whole * (turns > 0 ? loop.to_first.back() : loop.to_first.back().Inverse());
    }
    return whole * loop.to_first[PieceAt(loop, distance - turns * loop.length())];
  };
  return {OnLoop(index, to), frame(from).Inverse() * frame(to)};
}

FlatDomain DomainOf(const Triangulation& t, const CornerUv& uv) {
  EdgeLengths lengths{Eigen::VectorXd(t.num_edges())};
  for (Index e = 0; e < t.num_edges(); ++e) {
    const Index h = t.edge_halfedge[e];
    lengths.value[e] = (uv.value[Triangulation::Next(h)] - uv.value[Triangulation::Prev(h)]).norm();
  }
  return {t, lengths};
}

}  // namespace cirque
