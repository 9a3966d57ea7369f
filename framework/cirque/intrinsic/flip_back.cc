#include "cirque/intrinsic/flip_back.h"

#include <optional>

#include <glog/logging.h>

#include "cirque/intrinsic/flip_complex.h"

namespace cirque {
namespace {

/// Whether face f has the same edges in the same slots: labels are never used twice.
bool SameFace(const FlipComplex& a, const FlipComplex& b, Index f) {
  for (Index h = 3 * f; h < 3 * f + 3; ++h) {
    if (a.label(h) != b.label(h)) return false;
  }
  return true;
}

/// Undoes all flips in `ideal` (its lengths do not matter) and those that can be in `actual`.
void UndoFlips(const std::vector<Index>& flips, Index fresh_label, FlipComplex* ideal,
               FlipComplex* actual) {
  for (auto flip = flips.rbegin(); flip != flips.rend(); ++flip, ++fresh_label) {
    const Index h = *flip, g = ideal->twin(h);
    std::optional<double> length;
    if (SameFace(*ideal, *actual, Triangulation::Face(h)) &&
        SameFace(*ideal, *actual, Triangulation::Face(g))) {
      length = actual->OtherDiagonal(h);
    }
    ideal->Unflip(h, length.value_or(0), fresh_label);
    if (length) actual->Unflip(h, *length, fresh_label);
  }
}

}  // namespace

FlippedBack FlipBack(const IntrinsicTriangulation& intrinsic, const EdgeLengths& flat) {
  const Triangulation& t = intrinsic.triangulation;
  CHECK_EQ(flat.value.size(), t.num_edges());
  FlipComplex actual(t, flat), ideal = actual;
  UndoFlips(intrinsic.flips, t.num_edges(), &ideal, &actual);

  std::vector<bool> of_input(t.num_edges() + intrinsic.flips.size(), false);
  for (Index h = 0; h < ideal.num_halfedges(); ++h) of_input[ideal.label(h)] = true;
  FlippedBack result;
  result.triangulation = actual.MakeTriangulation(t.num_vertices);
  result.lengths = actual.MakeLengths(result.triangulation);
  for (Index e = 0; e < result.triangulation.num_edges(); ++e) {
    if (!of_input[actual.label(result.triangulation.edge_halfedge[e])]) result.stuck.push_back(e);
  }
  return result;
}

}  // namespace cirque
