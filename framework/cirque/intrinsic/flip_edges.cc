#include "cirque/intrinsic/flip_edges.h"

#include <cmath>
#include <optional>

#include "cirque/intrinsic/flip_complex.h"

namespace cirque {
namespace {

constexpr double kSpareCorner = 0.01;  ///< of a corner's pi

class Flipper {
 public:
  Flipper(const IntrinsicTriangulation& from, const ConeTargets& targets, const KeepFlip& keep)
      : t_(from.triangulation),
        targets_(targets),
        keep_(keep),
        complex_(from.triangulation, from.lengths),
        corners_(CornersPerVertex(from.triangulation)),
        touched_(from.triangulation.num_faces(), false) {}

  bool TryFlip(Index h) {
    const Index g = complex_.twin(h);
    if (g == kNone) return false;
    const Index left = Triangulation::Face(h), right = Triangulation::Face(g);
    if (left == right || touched_[left] || touched_[right]) return false;
    const std::optional<double> length = complex_.OtherDiagonal(h);
    if (!length || !MoveCorners(h, g)) return false;
    const double own_length = complex_.length(h);
    const Index own_label = complex_.label(h);
    complex_.Flip(h, *length, kNone);
    if (!keep_(complex_, h)) {
      complex_.Unflip(h, own_length, own_label);
      AddCorners(h, g, 1);
      return false;
    }
    touched_[left] = touched_[right] = true;
    return true;
  }

  const FlipComplex& complex() const { return complex_; }

 private:
  bool HasEnough(Index v) const {
    return corners_[v] > std::floor(targets_.lower[v] / kPi + kSpareCorner);
  }

  /// Of the edge's two ends; the vertices opposite lose as many. They need not be different.
  void AddCorners(Index h, Index g, Index of_ends) {
    corners_[t_.Tail(h)] += of_ends;
    corners_[t_.Tip(h)] += of_ends;
    corners_[complex_.vertex(h)] -= of_ends;
    corners_[complex_.vertex(g)] -= of_ends;
  }

  /// As the flip does, unless it must not happen.
  bool MoveCorners(Index h, Index g) {
    AddCorners(h, g, -1);
    const bool enough = HasEnough(t_.Tail(h)) && HasEnough(t_.Tip(h));
    if (!enough) AddCorners(h, g, 1);
    return enough;
  }

  const Triangulation& t_;
  const ConeTargets& targets_;
  const KeepFlip& keep_;
  FlipComplex complex_;  ///< labels: the edges of t_, kNone for flipped ones
  std::vector<Index> corners_;
  std::vector<bool> touched_;
};

}  // namespace

IntrinsicTriangulation FlipEdges(const IntrinsicTriangulation& from,
                                 const std::vector<Index>& edges, const ConeTargets& targets,
                                 const KeepFlip& keep) {
  Flipper flipper(from, targets, keep);
  IntrinsicTriangulation result;
  result.flips = from.flips;
  for (const Index e : edges) {
    const Index h = from.triangulation.edge_halfedge[e];
    if (flipper.TryFlip(h)) result.flips.push_back(h);
  }
  const FlipComplex& complex = flipper.complex();
  result.triangulation = complex.MakeTriangulation(from.triangulation.num_vertices);
  result.lengths = complex.MakeLengths(result.triangulation);
  std::vector<Index> now(from.triangulation.num_edges(), kNone);
  for (Index h = 0; h < complex.num_halfedges(); ++h) {
    if (complex.label(h) != kNone) now[complex.label(h)] = result.triangulation.edge[h];
  }
  for (const Index e : from.edge_of_input) {
    result.edge_of_input.push_back(e == kNone ? kNone : now[e]);
  }
  return result;
}

}  // namespace cirque
