#include "cirque/intrinsic/chord_guard.h"

#include <algorithm>
#include <limits>

namespace cirque {
namespace {

constexpr std::size_t kInside = std::numeric_limits<std::size_t>::max();
constexpr double kSpareTurn = 0.01 * kPi;

}  // namespace

ChordGuard::ChordGuard(const Triangulation& t, const ConeTargets& targets)
    : place_(t.num_vertices, kInside) {
  const std::vector<std::vector<Index>> loops = BoundaryLoops(t);
  if (loops.size() != 1 || EulerCharacteristic(t) != 1) return;
  turned_ = {0};
  for (const Index h : loops.front()) {
    const Index v = t.Tail(h);
    place_[v] = turned_.size() - 1;
    turned_.push_back(turned_.back() + kPi - targets.lower[v]);
  }
  for (Index v = 0; v < t.num_vertices; ++v) {
    if (place_[v] == kInside) cone_curvature_ += std::max(0.0, 2 * kPi - targets.lower[v]);
  }
}

bool ChordGuard::Allows(Index u, Index w) const {
  const auto [first, last] = std::minmax(place_[u], place_[w]);
  if (last == kInside) return true;
  if (first == last) return cone_curvature_ > kPi + kSpareTurn;
  const double between = turned_[last] - turned_[first + 1];
  const double outside = turned_.back() - turned_[last + 1] + turned_[first];
  return std::min(between, outside) + cone_curvature_ > kSpareTurn;
}

}  // namespace cirque
