#include "cirque/intrinsic/loop_rotations.h"

#include <algorithm>
#include <array>
#include <utility>

#include "cirque/core/metric.h"
#include "cirque/intrinsic/flip_complex.h"

namespace cirque {
namespace {

Index Next(Index h) { return Triangulation::Next(h); }
Index Prev(Index h) { return Triangulation::Prev(h); }
Index Face(Index h) { return Triangulation::Face(h); }

/// Closed paths while edges of their complex are flipped.
class CarriedPaths {
 public:
  CarriedPaths(Index num_faces, std::vector<DualPath> paths)
      : paths_(std::move(paths)), passes_(num_faces, 0) {
    for (const DualPath& path : paths_) {
      for (const Index h : path.entered) ++passes_[Face(h)];
    }
  }

  /// After the flip of h, whose other side is g.
  void Follow(const FlipComplex& flipped, Index h, Index g) {
    if (passes_[Face(h)] == 0 && passes_[Face(g)] == 0) return;
    for (DualPath& path : paths_) {
      const bool passes = std::any_of(path.entered.begin(), path.entered.end(), [&](Index k) {
        return Face(k) == Face(h) || Face(k) == Face(g);
      });
      if (passes) Reroute(flipped, h, g, &path.entered);
    }
  }

  std::vector<DualPath> Take() { return std::move(paths_); }

 private:
  /// The four sides have moved on by a slot; the diagonal is crossed where the path leads on from the
  /// other face.
  void Reroute(const FlipComplex& flipped, Index h, Index g, std::vector<Index>* entered) {
    const std::array<Index, 4> from = {Next(h), Prev(h), Next(g), Prev(g)},
                               to = {Prev(g), Next(h), Prev(h), Next(g)};
    for (const Index k : *entered) --passes_[Face(k)];
    std::erase_if(*entered, [&](Index k) { return k == h || k == g; });
    for (Index& k : *entered) {
      const auto moved = std::find(from.begin(), from.end(), k);
      if (moved != from.end()) k = to[static_cast<std::size_t>(moved - from.begin())];
    }
    std::vector<Index> rerouted;
    for (std::size_t i = 0; i < entered->size(); ++i) {
      const Index here = (*entered)[i], next = (*entered)[(i + 1) % entered->size()];
      rerouted.push_back(here);
      const Index left = Face(flipped.twin(next));
      if (left != Face(here)) rerouted.push_back(left == Face(h) ? h : g);
    }
    *entered = std::move(rerouted);
    for (const Index k : *entered) ++passes_[Face(k)];
  }

  std::vector<DualPath> paths_;
  std::vector<int> passes_;  ///< of every face, by all paths
};

}  // namespace

std::vector<DualPath> PathsAfterFlips(const Triangulation& input, const std::vector<Index>& flips,
                                      std::vector<DualPath> paths) {
  if (flips.empty() || paths.empty()) return paths;
  const EdgeLengths unused{Eigen::VectorXd::Ones(input.num_edges())};
  FlipComplex complex(input, unused);
  CarriedPaths carried(input.num_faces(), std::move(paths));
  for (const Index h : flips) {
    const Index g = complex.twin(h);
    complex.Flip(h, 1, kNone);
    carried.Follow(complex, h, g);
  }
  return carried.Take();
}

}  // namespace cirque
