#include "cirque/mesh/mirror_symmetry.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace cirque {
namespace {

class MirrorSearch {
 public:
  MirrorSearch(const Surface& disk, const PolygonRings& rings, double tolerance)
      : t_(disk.triangulation),
        lengths_(MeasureEdgeLengths(disk)),
        rings_(rings),
        tolerance_(tolerance),
        loop_(BoundaryLoops(t_).front()),
        edges_(t_.num_vertices, 0) {
    for (Index h = 0; h < t_.num_halfedges(); ++h) {
      if (rings_.HasEdge(h)) ++edges_[t_.Tail(h)];
    }
  }

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
      if (edges_[t_.Tail(h)] != edges_[t_.Tip(other)] || Mismatch(h, other) > tolerance_) {
        return false;
      }
    }
    return true;
  }

  /// The symmetry that takes a halfedge to another, polygon by polygon from there.
  std::optional<MirrorSymmetry> Extend(Index halfedge, Index to) const {
    MirrorSymmetry symmetry;
    symmetry.halfedge.assign(t_.num_halfedges(), kNone);
    std::vector<std::pair<Index, Index>> open = {{halfedge, to}};
    while (!open.empty()) {
      const auto [h, image] = open.back();
      open.pop_back();
      if (symmetry.halfedge[h] == image) continue;
      if (symmetry.halfedge[h] != kNone || !TakePolygon(h, image, &symmetry, &open)) {
        return std::nullopt;
      }
    }
    if (!IsOwnInverse(symmetry) || !MapVertices(&symmetry)) return std::nullopt;
    return symmetry;
  }

  /// Round two polygons opposite ways; what lies across their edges comes next.
  bool TakePolygon(Index h, Index image, MirrorSymmetry* symmetry,
                   std::vector<std::pair<Index, Index>>* open) const {
    Index a = h, b = image;
    do {
      const double mismatch = Mismatch(a, b);
      if (mismatch > tolerance_ || symmetry->halfedge[a] != kNone) return false;
      symmetry->halfedge[a] = b;
      symmetry->length_mismatch = std::max(symmetry->length_mismatch, mismatch);
      if ((t_.twin[a] == kNone) != (t_.twin[b] == kNone)) return false;
      if (t_.twin[a] != kNone) open->emplace_back(t_.twin[a], t_.twin[b]);
      a = rings_.next[a], b = rings_.previous[b];
    } while (a != h && b != image);
    return a == h && b == image;
  }

  bool IsOwnInverse(const MirrorSymmetry& symmetry) const {
    for (Index h = 0; h < t_.num_halfedges(); ++h) {
      if (!rings_.HasEdge(h)) continue;
      if (symmetry.halfedge[h] == kNone || symmetry.halfedge[symmetry.halfedge[h]] != h) {
        return false;
      }
    }
    return true;
  }

  bool MapVertices(MirrorSymmetry* symmetry) const {
    symmetry->vertex.assign(t_.num_vertices, kNone);
    for (Index h = 0; h < t_.num_halfedges(); ++h) {
      if (!rings_.HasEdge(h)) continue;
      Index& to = symmetry->vertex[t_.Tail(h)];
      const Index image = t_.Tip(symmetry->halfedge[h]);
      if (to != kNone && to != image) return false;
      to = image;
    }
    const auto& vertex = symmetry->vertex;
    return std::find(vertex.begin(), vertex.end(), kNone) == vertex.end();
  }

  const Triangulation& t_;
  const EdgeLengths lengths_;
  const PolygonRings& rings_;
  const double tolerance_;
  const std::vector<Index> loop_;
  std::vector<Index> edges_;  ///< per vertex, those that leave it along polygons
};

}  // namespace

PolygonRings RingsOf(const Surface& surface) {
  const Triangulation& t = surface.triangulation;
  const std::vector<bool> inside = EdgesInsidePolygons(surface);
  PolygonRings rings;
  rings.next.assign(t.num_halfedges(), kNone);
  rings.previous.assign(t.num_halfedges(), kNone);
  for (Index h = 0; h < t.num_halfedges(); ++h) {
    if (inside[t.edge[h]]) continue;
    Index next = Triangulation::Next(h);
    while (inside[t.edge[next]]) next = Triangulation::Next(t.twin[next]);
    rings.next[h] = next;
    rings.previous[next] = h;
  }
  return rings;
}

std::optional<MirrorSymmetry> FindMirrorSymmetry(const Surface& disk, const PolygonRings& rings,
                                                 double tolerance) {
  return MirrorSearch(disk, rings, tolerance).Run();
}

}  // namespace cirque
