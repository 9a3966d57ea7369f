#include "cirque/intrinsic/triple_flip_complex.h"

#include <cmath>

#include "cirque/core/types.h"

namespace cirque {
namespace {

Index Next(Index h) { return Triangulation::Next(h); }
Index Prev(Index h) { return Triangulation::Prev(h); }

EdgeLengths Rounded(const std::vector<TripleDouble>& lengths) {
  EdgeLengths rounded;
  rounded.value.resize(static_cast<Eigen::Index>(lengths.size()));
  for (Eigen::Index e = 0; e < rounded.value.size(); ++e) rounded.value[e] = lengths[e].Value();
  return rounded;
}

/// b + c - a, the larger of b and c first: the difference to it is exact where cancellation threatens.
TripleDouble Excess(const TripleDouble& a, const TripleDouble& b, const TripleDouble& c) {
  return b < c ? (c - a) + b : (b - a) + c;
}

/// Of the angle between sides b and c of a triangle, opposite a: 4 b c sin^2 and cos^2 of its half.
struct HalfAngle {
  TripleDouble sine, cosine;

  HalfAngle(const TripleDouble& a, const TripleDouble& b, const TripleDouble& c)
      : sine(Excess(b, a, c) * Excess(c, a, b)), cosine((a + b + c) * Excess(a, b, c)) {}

  bool IsProper() const { return sine.high > 0 && cosine.high > 0; }
};

/// Whether all three inequalities hold strictly.
bool HasArea(const TripleDouble& a, const TripleDouble& b, const TripleDouble& c) {
  return Excess(a, b, c).high > 0 && Excess(b, c, a).high > 0 && Excess(c, a, b).high > 0;
}

}  // namespace

void FlipTriple(Index h, const TripleDouble& length, FlipComplex* complex,
                std::vector<LowerDigits>* lower) {
  const Index g = complex->twin(h);
  std::vector<LowerDigits>& of = *lower;
  const LowerDigits moved[4] = {of[Next(h)], of[Prev(h)], of[Next(g)], of[Prev(g)]};
  complex->Flip(h, length.high, kNone);
  of[Prev(g)] = moved[0];
  of[Next(h)] = moved[1];
  of[Prev(h)] = moved[2];
  of[Next(g)] = moved[3];
  of[h] = of[g] = {length.middle, length.low};
}

TripleFlipComplex::TripleFlipComplex(const Triangulation& t,
                                     const std::vector<TripleDouble>& lengths)
    : complex_(t, Rounded(lengths)), lower_(t.num_halfedges()) {
  for (Index h = 0; h < t.num_halfedges(); ++h) {
    const TripleDouble& length = lengths[t.edge[h]];
    lower_[h] = {length.middle, length.low};
  }
}

TripleDouble TripleFlipComplex::Length(Index h) const {
  return lower_[h].Below(complex_.length(h));
}

double TripleFlipComplex::Angle(Index h) const {
  const HalfAngle half(Length(h), Length(Next(h)), Length(Prev(h)));
  return 2 * std::atan2(std::sqrt(half.sine.high), std::sqrt(half.cosine.high));
}

bool TripleFlipComplex::IsConvexAtTail(Index h) const {
  // tan^2(x / 2) tan^2(y / 2) < 1 exactly when x + y < pi.
  const Index g = twin(h);
  const HalfAngle left(Length(Next(h)), Length(h), Length(Prev(h)));
  const HalfAngle right(Length(Prev(g)), Length(g), Length(Next(g)));
  return left.IsProper() && right.IsProper() && left.sine * right.sine < left.cosine * right.cosine;
}

TripleDouble TripleFlipComplex::OtherDiagonal(Index h) const {
  // z^2 = (x - y)^2 + 4 x y sin^2(half the angle at the tail), where x and y come out of the sine.
  const Index g = twin(h);
  const TripleDouble x = Length(Prev(h)), y = Length(Next(g));
  const HalfAngle left(Length(Next(h)), Length(h), x), right(Length(Prev(g)), Length(g), y);
  const TripleDouble across =
      Half(Sqrt(left.sine * right.cosine) + Sqrt(left.cosine * right.sine)) / Length(h);
  return Sqrt((x - y) * (x - y) + across * across);
}

bool TripleFlipComplex::Turn(Index h) {
  const Index g = twin(h);
  if (!IsConvexAtTail(h) || !IsConvexAtTail(g)) return false;
  const TripleDouble length = OtherDiagonal(h);
  const bool has_areas = HasArea(Length(Prev(h)), Length(Next(g)), length) &&
                         HasArea(Length(Next(h)), Length(Prev(g)), length);
  if (!has_areas) return false;
  FlipTriple(h, length, &complex_, &lower_);
  return true;
}

}  // namespace cirque
