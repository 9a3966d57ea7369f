#include "cirque/intrinsic/intrinsic_delaunay.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <compare>
#include <cstdint>
#include <limits>
#include <optional>
#include <queue>
#include <utility>

#include <glog/logging.h>

#include "cirque/core/parallel.h"
#include "cirque/intrinsic/flip_complex.h"
#include "cirque/intrinsic/intrinsic_surface.h"

namespace cirque {
namespace {

constexpr std::size_t kInside = std::numeric_limits<std::size_t>::max();
constexpr double kSpareTurn = 0.01 * kPi;

}  // namespace

ChordGuard::ChordGuard(const Triangulation& t, const ConeTargets& targets)
    : position_(t.num_vertices, kInside) {
  const std::vector<std::vector<Index>> loops = BoundaryLoops(t);
  if (loops.size() != 1 || EulerCharacteristic(t) != 1) return;
  turned_ = {0};
  for (const Index h : loops.front()) {
    const Index v = t.Tail(h);
    position_[v] = turned_.size() - 1;
    turned_.push_back(turned_.back() + kPi - targets.lower[v]);
  }
  for (Index v = 0; v < t.num_vertices; ++v) {
    if (position_[v] == kInside) cone_curvature_ += std::max(0.0, 2 * kPi - targets.lower[v]);
  }
}

bool ChordGuard::Allows(Index u, Index w) const {
  const auto [first, last] = std::minmax(position_[u], position_[w]);
  if (last == kInside) return true;
  if (first == last) return cone_curvature_ > kPi + kSpareTurn;
  const double between = turned_[last] - turned_[first + 1];
  const double outside = turned_.back() - turned_[last + 1] + turned_[first];
  return std::min(between, outside) + cone_curvature_ > kSpareTurn;
}

namespace {

constexpr std::int64_t kMaxFlipsPerEdge = 100;
constexpr double kSpareCorner = 0.01;  // of a corner's pi
constexpr double kJagged = 0.25;       // [rad]: mean distance of angle sums from straight

/// Whether the boundary vertices that are to be straight or reflex are far from it on average.
bool IsJagged(const Triangulation& t, const EdgeLengths& lengths, const ConeTargets& targets,
              const std::vector<bool>& boundary) {
  std::vector<Index> straight;
  for (Index v = 0; v < t.num_vertices; ++v) {
    if (boundary[v] && targets.lower[v] >= kPi) straight.push_back(v);
  }
  if (straight.empty()) return false;
  const std::vector<double> sum = VertexAngleSums(t, MeasureCornerAngles(t, lengths));
  double bend = 0;
  for (const Index v : straight) bend += std::abs(sum[v] - targets.lower[v]);
  return bend > kJagged * static_cast<double>(straight.size());
}

/// The least number of corners with which each vertex can reach its target, lower_v < corners * pi
/// with a little to spare; where a jagged boundary is to be straight one more.
std::vector<Index> LeastCorners(const Triangulation& t, const EdgeLengths& lengths,
                                const ConeTargets& targets) {
  const std::vector<bool> boundary = BoundaryVertices(t);
  const bool jagged = IsJagged(t, lengths, targets, boundary);
  std::vector<Index> least;
  for (Index v = 0; v < t.num_vertices; ++v) {
    const auto full = static_cast<Index>(std::floor(targets.lower[v] / kPi + kSpareCorner));
    least.push_back(full + (jagged && boundary[v] && full > 0 ? 2 : 1));
  }
  return least;
}

/// The least angle sum of every inner vertex; 0 on the boundary.
std::vector<double> NeededInside(const Triangulation& t, const ConeTargets& targets) {
  std::vector<double> needed(targets.lower.begin(), targets.lower.end());
  const std::vector<bool> boundary = BoundaryVertices(t);
  for (Index v = 0; v < t.num_vertices; ++v) {
    if (boundary[v]) needed[v] = 0;
  }
  return needed;
}

bool ViolatesDelaunay(double ratio) { return ratio > 1 + kDelaunayTolerance; }

/// An edge that waits to be flipped, and what says when: the worst violation first, then the
/// longest edge. Single precision, so that rounding (of a rotated surface) does not decide between
/// two; the slot does where all else is equal, as on a symmetric surface.
struct Violation {
  Violation(double ratio, double length, Index h)
      : order(std::uint64_t{BitsOf(ratio)} << 32 | BitsOf(length)), halfedge(h) {}

  /// Positive numbers are in the order of their bits, which are compared at once.
  static std::uint32_t BitsOf(double positive) {
    return std::bit_cast<std::uint32_t>(static_cast<float>(positive));
  }

  std::uint64_t order;
  Index halfedge;

  auto operator<=>(const Violation&) const = default;
};

class DelaunayFlipper {
 public:
  DelaunayFlipper(const Triangulation& t, const EdgeLengths& lengths, const ConeTargets& targets,
                  const std::vector<bool>& locked)
      : complex_(t, lengths),
        tangent_(t.num_halfedges()),
        locked_(locked),
        corners_(CornersPerVertex(t)),
        least_corners_(LeastCorners(t, lengths, targets)),
        needed_(NeededInside(t, targets)),
        chords_(t, targets),
        flips_left_(kMaxFlipsPerEdge * t.num_edges()) {
    ParallelFor(t.num_halfedges(), [&](Index h) { tangent_[h] = complex_.SquaredHalfTangent(h); });
  }

  void Run() {
    for (Index h = 0; h < complex_.num_halfedges(); ++h) {
      if (complex_.twin(h) > h) Await(h);
    }
    FlipAwaiting();
    // A vertex at its least number of corners may have gained some since.
    std::size_t flips_before = 0;
    while (!guarded_.empty() && flips_before != flips_.size()) {
      flips_before = flips_.size();
      for (const Index h : std::exchange(guarded_, {})) Await(h);
      FlipAwaiting();
    }
  }

  const FlipComplex& complex() const { return complex_; }
  std::vector<Index> TakeFlips() && { return std::move(flips_); }

 private:
  std::optional<Violation> ViolationAt(Index h) const {
    const Index g = complex_.twin(h);
    if (g == kNone || Triangulation::Face(g) == Triangulation::Face(h)) return std::nullopt;
    const double ratio = tangent_[h] * tangent_[g];
    if (!ViolatesDelaunay(ratio) || IsLocked(h)) return std::nullopt;
    return Violation(ratio, complex_.length(h), h);
  }

  void Await(Index h) {
    if (const auto violation = ViolationAt(h)) awaiting_.push(*violation);
  }

  /// The order follows the geometry, so that a surface is flipped alike however it is numbered.
  void FlipAwaiting() {
    while (!awaiting_.empty()) {
      const Violation violation = awaiting_.top();
      awaiting_.pop();
      // What another flip has changed since waits at its new place.
      if (ViolationAt(violation.halfedge) == violation) TryFlip(violation.halfedge);
    }
  }

  bool IsLocked(Index h) const {
    return !locked_.empty() && complex_.label(h) != kNone && locked_[complex_.label(h)];
  }

  void TryFlip(Index h) {
    const Index g = complex_.twin(h);
    const std::optional<double> length = complex_.OtherDiagonal(
        h, {tangent_[Triangulation::Next(h)], tangent_[Triangulation::Prev(g)],
            tangent_[Triangulation::Prev(h)], tangent_[Triangulation::Next(g)]});
    if (!length) return;
    const auto [of_h, of_twin] = complex_.TangentsAfterFlip(h, *length);
    if (ViolatesDelaunay(of_h * of_twin) || flips_left_ == 0) return;
    if (!MoveCorners(h)) {
      guarded_.push_back(h);
      return;
    }
    complex_.Flip(h, *length, kNone);
    flips_.push_back(h);
    --flips_left_;
    tangent_[h] = of_h;
    tangent_[g] = of_twin;
    const Index sides[] = {Triangulation::Next(h), Triangulation::Prev(h), Triangulation::Next(g),
                           Triangulation::Prev(g)};
    for (const Index side : sides) tangent_[side] = complex_.SquaredHalfTangent(side);
    for (const Index side : sides) Await(side);
  }

  /// Counts the corners after the flip; leaves the counts alone when it must not happen. The four
  /// vertices need not be different.
  bool MoveCorners(Index h) {
    const Index g = complex_.twin(h);
    const Index tail = complex_.vertex(Triangulation::Next(h));
    const Index tip = complex_.vertex(Triangulation::Prev(h));
    const auto add = [&](Index to_ends, Index to_apexes) {
      corners_[tail] += to_ends;
      corners_[tip] += to_ends;
      corners_[complex_.vertex(h)] += to_apexes;
      corners_[complex_.vertex(g)] += to_apexes;
    };
    if (!chords_.Allows(complex_.vertex(h), complex_.vertex(g))) return false;
    add(-1, 1);
    const bool enough =
        corners_[tail] >= least_corners_[tail] && corners_[tip] >= least_corners_[tip] &&
        HasRoomInPair(tail, Triangulation::Prev(h)) && HasRoomInPair(tip, Triangulation::Next(h));
    if (!enough) add(1, -1);
    return enough;
  }

  /// Two inner neighbours of three corners each fill four faces between two edges with the same ends,
  /// and must leave an angle to these. `side` joins the vertex, which keeps three corners, to one of
  /// the flipped edge's apexes: only beyond it can the other one lie, as apexes gain a corner.
  bool HasRoomInPair(Index v, Index side) const {
    if (corners_[v] != 3 || needed_[v] == 0) return true;
    const Index other = complex_.vertex(complex_.twin(side));
    return corners_[other] != 3 || needed_[v] + needed_[other] < 4 * kPi - kSpareTurn;
  }

  FlipComplex complex_;          // labels: the input's edges, kNone for later ones
  std::vector<double> tangent_;  // per halfedge SquaredHalfTangent as it stands: a flip changes six
  const std::vector<bool>& locked_;
  std::vector<Index> corners_, least_corners_;
  const std::vector<double> needed_;
  const ChordGuard chords_;
  std::priority_queue<Violation> awaiting_;
  std::vector<Index> guarded_;
  std::vector<Index> flips_;
  std::int64_t flips_left_;
};

}  // namespace

IntrinsicTriangulation MakeIntrinsicDelaunay(const Triangulation& t, const EdgeLengths& lengths,
                                             const IntrinsicDelaunayOptions& options) {
  CHECK_EQ(lengths.value.size(), t.num_edges());
  CHECK(options.locked.empty() || options.locked.size() == t.edge_halfedge.size());
  const ConeTargets targets = options.targets ? *options.targets : FreeBoundaryTargets(t);
  DelaunayFlipper flipper(t, lengths, targets, options.locked);
  flipper.Run();
  IntrinsicTriangulation result;
  const FlipComplex& complex = flipper.complex();
  result.triangulation = complex.MakeTriangulation(t.num_vertices);
  result.lengths = complex.MakeLengths(result.triangulation);
  result.edge_of_input.assign(t.num_edges(), kNone);
  for (Index h = 0; h < complex.num_halfedges(); ++h) {
    if (complex.label(h) != kNone) {
      result.edge_of_input[complex.label(h)] = result.triangulation.edge[h];
    }
  }
  result.flips = std::move(flipper).TakeFlips();
  return result;
}

ConeTargets TransferTargets(const IntrinsicSurface& input, const ConeTargets& targets,
                            const IntrinsicSurface& other) {
  CHECK_EQ(input.corners.size(), other.corners.size());
  ConeTargets transferred = targets;
  for (std::size_t v = 0; v < input.corners.size(); ++v) {
    const bool is_free = targets.lower[v] <= 0 && targets.upper[v] >= kPi * input.corners[v];
    if (is_free) transferred.upper[v] = kPi * other.corners[v];
  }
  return transferred;
}

std::vector<Index> NonDelaunayEdges(const Triangulation& t, const EdgeLengths& lengths) {
  const FlipComplex complex(t, lengths);
  std::vector<Index> edges;
  for (Index e = 0; e < t.num_edges(); ++e) {
    if (!t.IsBoundaryEdge(e) && ViolatesDelaunay(complex.DelaunayRatio(t.edge_halfedge[e]))) {
      edges.push_back(e);
    }
  }
  return edges;
}

}  // namespace cirque
