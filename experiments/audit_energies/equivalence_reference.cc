#include <array>
#include <utility>
#include <vector>

#include "cirque/energy/conformal_equivalence_energy.h"

#include "experiments/audit_energies/samples.h"

namespace cirque::audit_energies {
namespace {

using high_precision::Pi;
using high_precision::Real;

struct Side {
  Real length;
  Index opposite, twin;
};

Index Next(Index h) { return Triangulation::Next(h); }
Index Prev(Index h) { return Triangulation::Prev(h); }

/// A surface whose sides have lengths of any size, scaled by exponentials at the vertices.
class ScaledComplex {
 public:
  ScaledComplex(const EnergyInput& input, Reals factor) : factor_(std::move(factor)) {
    const Triangulation& t = input.triangulation;
    for (Index h = 0; h < t.num_halfedges(); ++h) {
      side_.push_back({Real(input.lengths.value[t.edge[h]]), t.vertex[h], t.twin[h]});
    }
  }

  Index num_halfedges() const { return static_cast<Index>(side_.size()); }
  Index opposite(Index h) const { return side_[h].opposite; }

  Real Length(Index h) const {
    return side_[h].length * factor_[opposite(Next(h))] * factor_[opposite(Prev(h))];
  }

  /// Of the corner opposite h, by the law of cosines; beyond [-1, 1] where there is no triangle.
  Real Cosine(Index h) const {
    const Real a = Length(h), b = Length(Next(h)), c = Length(Prev(h));
    return (b * b + c * c - a * a) / (2 * b * c);
  }

  Real Angle(Index h) const {
    const Real cosine = Cosine(h);
    if (cosine <= -1) return Pi();
    return cosine >= 1 || Cosine(Next(h)) <= -1 || Cosine(Prev(h)) <= -1 ? Real(0) : acos(cosine);
  }

  void MakeDelaunay() {
    bool flipped = true;
    while (flipped) {
      flipped = false;
      for (Index h = 0; h < num_halfedges(); ++h) {
        const Index g = side_[h].twin;
        const bool inner = g != kNone && g / 3 != h / 3;
        if (!inner || Cosine(h) + Cosine(g) >= Real("-1e-40")) continue;
        Flip(h, g);
        flipped = true;
      }
    }
  }

 private:
  /// The other diagonal takes the edge's two slots, the four sides move on by one.
  void Flip(Index h, Index g) {
    const std::array<Index, 4> from = {Next(h), Prev(h), Next(g), Prev(g)};
    const std::array<Index, 4> to = {Prev(g), Next(h), Prev(h), Next(g)};
    const Real length = (side_[Next(h)].length * side_[Next(g)].length +
                         side_[Prev(h)].length * side_[Prev(g)].length) /
                        side_[h].length;
    const Index tail = opposite(Next(h)), tip = opposite(Prev(h));
    const Index left = opposite(h), right = opposite(g);
    std::array<Side, 4> moved;
    for (int i = 0; i < 4; ++i) moved[i] = side_[from[i]];
    for (Side& side : moved) {
      for (int j = 0; j < 4; ++j) {
        if (side.twin != from[j]) continue;
        side.twin = to[j];
        break;
      }
    }
    for (int i = 0; i < 4; ++i) {
      side_[to[i]] = moved[i];
      if (moved[i].twin != kNone) side_[moved[i].twin].twin = to[i];
    }
    side_[h].length = side_[g].length = length;
    side_[h].opposite = tail;
    side_[g].opposite = tip;
    side_[Next(h)].opposite = side_[Prev(g)].opposite = right;
    side_[Prev(h)].opposite = side_[Next(g)].opposite = left;
  }

  const Reals factor_;
  std::vector<Side> side_;
};

void Add(const Real& term, ReferenceValue* sum) {
  sum->value += term;
  sum->magnitude += abs(term);
}

}  // namespace

Reference EquivalenceReference(bool delaunay) {
  return [delaunay](const EnergyInput& input, const Reals& u) {
    const ScaleTargets targets = TargetsOfScales(input.targets);
    ReferenceValue sum;
    Reals factor;
    for (const int p : targets.parameter) factor.push_back(p == kNone ? Real(1) : exp(u[p] / 2));
    for (std::size_t p = 0; p < u.size(); ++p) Add(Real(targets.angle_sum[p]) * u[p], &sum);
    ScaledComplex complex(input, std::move(factor));
    if (delaunay) complex.MakeDelaunay();
    for (Index h = 0; h < complex.num_halfedges(); ++h) {
      const Real angle = complex.Angle(h), log_length = log(complex.Length(h));
      Add((2 * angle - Pi()) * log_length, &sum);
      Add(high_precision::Clausen(2 * angle), &sum);
    }
    return sum;
  };
}

}  // namespace cirque::audit_energies
