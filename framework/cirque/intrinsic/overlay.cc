#include "cirque/intrinsic/overlay.h"

#include <algorithm>
#include <limits>
#include <utility>

#include <fmt/format.h>
#include <glog/logging.h>

#include "cirque/intrinsic/normal_coordinates.h"

namespace cirque {
namespace {

Index Next(Index h) { return Triangulation::Next(h); }
Index Prev(Index h) { return Triangulation::Prev(h); }

NormalCoordinates Replay(const Triangulation& input, const std::vector<Index>& flips) {
  NormalCoordinates normal(input);
  for (const Index h : flips) normal.Flip(h);
  return normal;
}

/// Every arc cuts a face in two.
std::int64_t CountFaces(const NormalCoordinates& normal) {
  const Index halfedges = normal.complex().num_halfedges();
  std::int64_t faces = halfedges / 3;
  for (Index c = 0; c < halfedges; ++c) faces += normal.Cutting(c) + normal.Emanating(c);
  return faces;
}

/// Follows the input edges over the other triangulation.
class Tracer {
 public:
  Tracer(const Triangulation& input, const Triangulation& other, const NormalCoordinates& normal)
      : input_(input), other_(other), normal_(normal), slot_(other.num_edges() + 1, 0) {
    for (Index e = 0; e < other.num_edges(); ++e) {
      slot_[e + 1] = slot_[e] + static_cast<Index>(normal.Crossings(other.edge_halfedge[e]));
    }
    at_.assign(slot_.back(), kNone);
  }

  std::vector<Crossing> Trace(const PositionRule& rule) {
    for (Index c = 0; c < other_.num_halfedges(); ++c) {
      for (std::int64_t i = 0; i < normal_.Emanating(c); ++i) {
        const Index edge = Prev(normal_.InputCorner(c, i));
        if (input_.edge_halfedge[input_.edge[edge]] == edge) TraceEdge(edge, c, i, rule);
      }
    }
    return std::move(crossing_);
  }

  /// The crossings on the edge, from the tail of its halfedge on.
  std::span<const Index> OnEdge(Index e) const {
    return {at_.data() + slot_[e], static_cast<std::size_t>(slot_[e + 1] - slot_[e])};
  }

 private:
  void TraceEdge(Index edge, Index corner, std::int64_t i, const PositionRule& rule) {
    path_.clear();
    Index out = corner;
    std::int64_t at = normal_.Cutting(Next(corner)) + i;
    while (out != kNone) {
      const Index mine = other_.edge_halfedge[other_.edge[out]];
      const std::int64_t n = normal_.Crossings(out), back = n - 1 - at;
      at_[slot_[other_.edge[out]] + static_cast<Index>(mine == out ? at : back)] =
          static_cast<Index>(crossing_.size());
      crossing_.push_back({edge, mine});
      path_.push_back(out);
      at = back;
      out = normal_.Across(other_.twin[out], &at);
    }
    Place(rule({corner, path_, edge}));
  }

  void Place(const PathPositions& positions) {
    const std::size_t first = crossing_.size() - path_.size();
    for (std::size_t i = 0; i < path_.size(); ++i) {
      Crossing& crossing = crossing_[first + i];
      const double along = positions.along_crossed[i];
      crossing.along_input = positions.along_input[i];
      crossing.along_other = path_[i] == crossing.other ? along : 1 - along;
      if (!positions.log_weight.empty()) crossing.log_weight = positions.log_weight[i];
    }
  }

  const Triangulation &input_, &other_;
  const NormalCoordinates& normal_;
  std::vector<Index> slot_, at_;  // the crossings of every edge of the other triangulation
  std::vector<Crossing> crossing_;
  std::vector<Index> path_;
};

/// Cuts the faces of the other triangulation along the input edges in them. A face's perimeter is a
/// sequence of points, its vertices and the crossings; pieces of input edges are chords between
/// them. As no two cross, they open and close like parentheses.
class FaceCutter {
 public:
  FaceCutter(const Triangulation& input, const Triangulation& other,
             const NormalCoordinates& normal, const Tracer& tracer, Overlay* overlay)
      : input_(input), other_(other), normal_(normal), tracer_(tracer), overlay_(*overlay) {}

  void Cut() {
    overlay_.first_corner.assign(1, 0);
    for (Index f = 0; f < other_.num_faces(); ++f) CutFace(f);
  }

 private:
  struct Point {
    Overlay::Corner
        corner;       // `input`: of a vertex where a face begins at a side that is not shared
    std::int64_t at;  // of a crossing: its place on the side from the tail; -1: a vertex
    Index side;       // the halfedge of the face that it lies on or is the tail of
    Index forward;    // the input's halfedge from here to the next point of the sequence, or kNone
  };

  void CutFace(Index f) {
    points_.clear();
    for (Index side = 3 * f; side < 3 * f + 3; ++side) AddSide(side);
    stack_.clear();
    for (std::size_t p = 0; p < points_.size(); ++p) {
      stack_.push_back(points_[p]);
      CloseChords(p);
    }
    Emit(0);
  }

  void AddSide(Index side) {
    begin_[side % 3] = points_.size();
    const Index corner = Next(side);
    const Index shared = normal_.IsShared(side) ? normal_.SharedHalfedge(side) : kNone;
    const Index before = shared == kNone ? normal_.InputCorner(corner, -1) : Next(shared);
    points_.push_back({{other_.vertex[corner], before, corner}, -1, side, shared});
    const std::span<const Index> on_edge = tracer_.OnEdge(other_.edge[side]);
    const bool mine = other_.edge_halfedge[other_.edge[side]] == side;
    for (std::size_t i = 0; i < on_edge.size(); ++i) {
      const Index crossing = mine ? on_edge[i] : on_edge[on_edge.size() - 1 - i];
      points_.push_back({{other_.num_vertices + crossing, kNone, side},
                         static_cast<std::int64_t>(i),
                         side,
                         kNone});
    }
  }

  /// Closes all chords between the point and earlier ones, the innermost first. From the vertex
  /// before the last side they go to the first; from the others to later points.
  void CloseChords(std::size_t p) {
    const Point& point = points_[p];
    if (point.at >= 0) {
      const std::size_t partner = Partner(point);
      if (partner < p) Close(point, points_[partner]);
    } else if (point.side % 3 == 2) {
      const Index first_side = Next(point.side);
      const std::int64_t before = normal_.Cutting(Next(first_side));
      for (std::int64_t i = normal_.Emanating(first_side) - 1; i >= 0; --i) {
        Close(point, points_[begin_[0] + 1 + static_cast<std::size_t>(before + i)]);
      }
    }
  }

  /// The other end of the chord at a crossing.
  std::size_t Partner(const Point& point) const {
    const Index x = point.side;
    const std::int64_t round_tail = normal_.Cutting(Next(x)), ending = normal_.Emanating(x);
    const auto on = [&](Index side, std::int64_t at) {
      return begin_[side % 3] + static_cast<std::size_t>(1 + at);
    };
    if (point.at < round_tail) return on(Prev(x), normal_.Crossings(Prev(x)) - 1 - point.at);
    if (point.at < round_tail + ending) return on(Prev(x), -1);
    return on(Next(x), normal_.Crossings(x) - 1 - point.at);
  }

  /// The input's halfedge that leaves the vertex for a crossing on the side opposite.
  Index Leaving(const Point& crossing) const {
    const Index corner = crossing.side;
    const std::int64_t i = crossing.at - normal_.Cutting(Next(corner));
    return Prev(normal_.InputCorner(corner, i));
  }

  /// The input's halfedge along the chord from one point to another.
  Index Along(const Point& from, const Point& to) const {
    if (from.at < 0) return Leaving(to);
    if (to.at < 0) return input_.twin[Leaving(from)];
    const Index edge = overlay_.crossing[from.corner.vertex - overlay_.num_vertices].input;
    return from.corner.vertex < to.corner.vertex ? edge : input_.twin[edge];
  }

  /// Emits what the chord from the top of the stack back to a point of it cuts off.
  void Close(const Point& from, const Point& to) {
    std::size_t at = stack_.size() - 1;
    while (stack_[at].corner.other != to.corner.other || stack_[at].at != to.at) --at;
    stack_.back().forward = Along(from, to);
    Emit(at);
    stack_.resize(at + 1);
    stack_.back().forward = Along(to, from);
    stack_.push_back(from);
  }

  /// The face whose corners are those on the stack from `begin` on.
  void Emit(std::size_t begin) {
    Index before = stack_.back().forward, along = kNone;
    for (std::size_t i = begin; i < stack_.size(); ++i) {
      const Point& point = stack_[i];
      Overlay::Corner corner = point.corner;
      if (point.at >= 0) {
        corner.input = point.forward != kNone ? point.forward : before;
      } else if (point.forward != kNone) {
        corner.input = Next(point.forward);
      }
      overlay_.corner.push_back(corner);
      if (point.forward != kNone) along = point.forward;
      before = point.forward;
    }
    overlay_.first_corner.push_back(static_cast<Index>(overlay_.corner.size()));
    overlay_.input_face.push_back(Triangulation::Face(along));
    overlay_.other_face.push_back(Triangulation::Face(stack_.front().side));
  }

  const Triangulation &input_, &other_;
  const NormalCoordinates& normal_;
  const Tracer& tracer_;
  Overlay& overlay_;
  std::vector<Point> points_, stack_;
  std::size_t begin_[3] = {0, 0, 0};  // of every side's points
};

/// Separates the crossings on every edge of either triangulation.
void SeparateCrossings(const Triangulation& other, const Tracer& tracer,
                       std::vector<Crossing>* crossing) {
  std::vector<double> along;
  const auto separate = [&](std::size_t count, const auto& value) {
    along.clear();
    for (std::size_t i = 0; i < count; ++i) along.push_back(value(i));
    Separate(kCrossingSeparation, &along);
    for (std::size_t i = 0; i < count; ++i) value(i) = along[i];
  };
  for (Index e = 0; e < other.num_edges(); ++e) {
    const auto on_edge = tracer.OnEdge(e);
    separate(on_edge.size(),
             [&](std::size_t i) -> double& { return (*crossing)[on_edge[i]].along_other; });
  }
  for (std::size_t i = 0, end = 0; i < crossing->size(); i = end) {
    while (end < crossing->size() && (*crossing)[end].input == (*crossing)[i].input) ++end;
    separate(end - i, [&](std::size_t k) -> double& { return (*crossing)[i + k].along_input; });
  }
}

}  // namespace

void Separate(double separation, std::vector<double>* fractions) {
  std::vector<double>& x = *fractions;
  const double apart = std::min(separation, 1 / static_cast<double>(x.size() + 1));
  double least = 0, most = 1;
  for (double& value : x) least = value = std::max(value, least + apart);
  for (auto value = x.rbegin(); value != x.rend(); ++value) {
    most = *value = std::min(*value, most - apart);
  }
}

StatusOr<Overlay> MakeOverlay(const Triangulation& input, const std::vector<Index>& flips,
                              const PositionRule& rule, std::int64_t most_faces) {
  const NormalCoordinates normal = Replay(input, flips);
  const std::int64_t faces = CountFaces(normal);
  // Halfedges are numbered in 32 bits, also when faces have been cut into triangles.
  most_faces = std::min<std::int64_t>(most_faces, std::numeric_limits<Index>::max() / 16);
  if (faces > most_faces) {
    return Status::InvalidInput(
        fmt::format("the overlay of input and solved triangulation would have {} faces, {:.1f} for "
                    "one of the input, which is more than {}",
                    faces, static_cast<double>(faces) / input.num_faces(), most_faces));
  }
  const Triangulation other = normal.complex().MakeTriangulation(input.num_vertices);
  Overlay overlay;
  overlay.num_vertices = input.num_vertices;
  Tracer tracer(input, other, normal);
  overlay.crossing = tracer.Trace(rule);
  SeparateCrossings(other, tracer, &overlay.crossing);
  FaceCutter(input, other, normal, tracer, &overlay).Cut();
  CHECK_EQ(overlay.num_faces(), faces);
  return overlay;
}

}  // namespace cirque
