#include "cirque/intrinsic/input_chart.h"

#include <cmath>
#include <complex>
#include <optional>

#include <glog/logging.h>

#include "cirque/core/parallel.h"
#include "cirque/intrinsic/flip_complex.h"
#include "cirque/math/arctangent.h"

namespace cirque {
namespace {

using Vector = std::complex<double>;

double Cross(Vector a, Vector b) { return a.real() * b.imag() - a.imag() * b.real(); }

/// The sides of every face as vectors that add up to zero, each face in a frame of its own.
std::vector<Vector> SideVectors(const Triangulation& t, const CornerAngles& angles,
                                const EdgeLengths& lengths) {
  std::vector<Vector> side(t.num_halfedges());
  ParallelFor(t.num_faces(), [&](Index f) {
    const Index h = 3 * f;
    side[h] = lengths.value[t.edge[h]];
    side[h + 1] = std::polar(lengths.value[t.edge[h + 1]], kPi - angles.value[h + 2]);
    side[h + 2] = -(side[h] + side[h + 1]);
  });
  return side;
}

/// Undoes FlipComplex::Flip of h on the vectors; g is the twin of h. False: h has come to nothing,
/// which tells no frame from another; the frames are put together as they are.
bool UnflipVectors(Index h, Index g, std::vector<Vector>* side) {
  constexpr auto kNext = Triangulation::Next;
  constexpr auto kPrev = Triangulation::Prev;
  std::vector<Vector>& v = *side;
  Vector turn = -v[h] / v[g];  // from the frame of g's face to that of h's
  turn /= std::abs(turn);
  const bool turns = std::isfinite(turn.real()) && std::isfinite(turn.imag());
  if (!turns) turn = 1;
  const Vector next_h = turn * v[kPrev(g)], prev_h = v[kNext(h)];
  const Vector next_g = v[kPrev(h)], prev_g = turn * v[kNext(g)];
  v[kNext(h)] = next_h;
  v[kPrev(h)] = prev_h;
  v[h] = -(next_h + prev_h);
  v[kNext(g)] = next_g;
  v[kPrev(g)] = prev_g;
  v[g] = -(next_g + prev_g);
  return turns;
}

/// `lost`: faces that count as flipped whatever their sides are.
InputChart MeasureFaces(const Triangulation& t, const std::vector<Vector>& side,
                        const std::vector<bool>& lost) {
  InputChart flat;
  flat.angles.value.resize(t.num_halfedges());
  flat.lengths.value.resize(t.num_edges());
  ParallelFor(t.num_halfedges(), [&](Index h) {
    const Vector out = side[Triangulation::Prev(h)], back = -side[Triangulation::Next(h)];
    flat.angles.value[h] = Arctangent(Cross(out, back), (std::conj(out) * back).real());
  });
  ParallelFor(t.num_edges(),
              [&](Index e) { flat.lengths.value[e] = std::abs(side[t.edge_halfedge[e]]); });
  for (Index f = 0; f < t.num_faces(); ++f) {
    if (lost[f] || !(Cross(side[3 * f], side[3 * f + 1]) > 0)) flat.flipped.push_back(f);
  }
  return flat;
}

}  // namespace

InputChart ReadOnInput(const Triangulation& input, const IntrinsicTriangulation& intrinsic,
                       const CornerAngles& flat_angles, const EdgeLengths& flat_lengths) {
  const Triangulation& t = intrinsic.triangulation;
  std::vector<Vector> side = SideVectors(t, flat_angles, flat_lengths);
  FlipComplex complex(t, flat_lengths);
  std::vector<bool> lost(t.num_faces(), false);
  for (auto flip = intrinsic.flips.rbegin(); flip != intrinsic.flips.rend(); ++flip) {
    const Index g = complex.twin(*flip);
    const Index left = Triangulation::Face(*flip), right = Triangulation::Face(g);
    const bool turns = UnflipVectors(*flip, g, &side);
    if (!turns || lost[left] || lost[right]) lost[left] = lost[right] = true;
    complex.Unflip(*flip, 0, kNone);
  }
  return MeasureFaces(input, side, lost);
}

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
