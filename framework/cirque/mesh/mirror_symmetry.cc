#include "cirque/mesh/mirror_symmetry.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace cirque {
namespace {

class MirrorSearch {
 public:
  MirrorSearch(const Triangulation& disk, const EdgeLengths& lengths, double tolerance)
      : t_(disk),
        lengths_(lengths),
        tolerance_(tolerance),
        loop_(BoundaryLoops(disk).front()),
        corners_(CornersPerVertex(disk)) {}

  std::optional<MirrorSymmetry> Run() const {
    for (std::size_t image = 0; image < loop_.size(); ++image) {
      if (!BoundaryAgrees(image)) continue;
      std::optional<MirrorSymmetry> symmetry = Extend(loop_[0], loop_[image]);
      if (symmetry) return symmetry;
    }
    return std::nullopt;
  }

 private:
  double Mismatch(Index h, Index image) const {
    const double a = lengths_.value[t_.edge[h]], b = lengths_.value[t_.edge[image]];
    return std::abs(a - b) / std::max(a, b);
  }

  /// Whether the boundary looks alike from its first edge on and, backwards, from another one.
  bool BoundaryAgrees(std::size_t image) const {
    const std::size_t n = loop_.size();
    for (std::size_t k = 0; k < n; ++k) {
      const Index h = loop_[k], other = loop_[(image + n - k) % n];
      if (corners_[t_.Tail(h)] != corners_[t_.Tip(other)] || Mismatch(h, other) > tolerance_) {
        return false;
      }
    }
    return true;
  }

  /// The symmetry that takes a corner to another, face by face from there.
  std::optional<MirrorSymmetry> Extend(Index corner, Index to) const {
    MirrorSymmetry symmetry;
    symmetry.corner.assign(t_.num_halfedges(), kNone);
    std::vector<std::pair<Index, Index>> open = {{corner, to}};
    while (!open.empty()) {
      const auto [c, image] = open.back();
      open.pop_back();
      if (symmetry.corner[c] == image) continue;
      if (symmetry.corner[c] != kNone || !TakeFace(c, image, &symmetry)) return std::nullopt;
      for (Index k = 0, h = c, i = image; k < 3; ++k) {
        if ((t_.twin[h] == kNone) != (t_.twin[i] == kNone)) return std::nullopt;
        if (t_.twin[h] != kNone) open.emplace_back(t_.twin[h], t_.twin[i]);
        h = Triangulation::Next(h), i = Triangulation::Prev(i);
      }
    }
    if (!IsOwnInverse(symmetry) || !MapVertices(&symmetry)) return std::nullopt;
    return symmetry;
  }

  bool TakeFace(Index c, Index image, MirrorSymmetry* symmetry) const {
    for (Index k = 0, h = c, i = image; k < 3; ++k) {
      const double mismatch = Mismatch(h, i);
      if (mismatch > tolerance_ || symmetry->corner[h] != kNone) return false;
      symmetry->corner[h] = i;
      symmetry->length_mismatch = std::max(symmetry->length_mismatch, mismatch);
      h = Triangulation::Next(h), i = Triangulation::Prev(i);
    }
    return true;
  }

  bool IsOwnInverse(const MirrorSymmetry& symmetry) const {
    for (Index h = 0; h < t_.num_halfedges(); ++h) {
      if (symmetry.corner[h] == kNone || symmetry.corner[symmetry.corner[h]] != h) return false;
    }
    return true;
  }

  bool MapVertices(MirrorSymmetry* symmetry) const {
    symmetry->vertex.assign(t_.num_vertices, kNone);
    for (Index h = 0; h < t_.num_halfedges(); ++h) {
      Index& to = symmetry->vertex[t_.vertex[h]];
      const Index image = t_.vertex[symmetry->corner[h]];
      if (to != kNone && to != image) return false;
      to = image;
    }
    return true;
  }

  const Triangulation& t_;
  const EdgeLengths& lengths_;
  const double tolerance_;
  const std::vector<Index> loop_, corners_;
};

}  // namespace

std::optional<MirrorSymmetry> FindMirrorSymmetry(const Triangulation& disk,
                                                 const EdgeLengths& lengths, double tolerance) {
  return MirrorSearch(disk, lengths, tolerance).Run();
}

}  // namespace cirque
