#include "cirque/energy/array_objective.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

#include "cirque/core/types.h"

namespace cirque {
namespace {

constexpr int kMostSteps = 100;

/// An increasing function's value and slope at points, one function a point.
using Evaluation = std::function<void(const std::vector<std::size_t>& which,
                                      const std::vector<double>& x, std::vector<ScalarJet>* jets)>;

/// Where increasing functions are zero: in [low, high], of one without a zero there the nearer end.
struct Brackets {
  std::vector<double> low, high, x;  ///< x: where to begin, then the zeros
  std::vector<bool> inside;          ///< whether it is no end
};

/// Of jets of functions: `value` is the function's, `slope` its derivative.
std::vector<std::size_t> WithoutZeroAtEnds(const Evaluation& evaluate, Brackets* at) {
  std::vector<std::size_t> all(at->x.size()), open;
  for (std::size_t i = 0; i < all.size(); ++i) all[i] = i;
  std::vector<ScalarJet> low(all.size()), high(all.size());
  evaluate(all, at->low, &low);
  evaluate(all, at->high, &high);
  at->inside.assign(all.size(), false);
  for (const std::size_t i : all) {
    if (!(low[i].value < 0)) {
      at->x[i] = at->low[i];
    } else if (!(high[i].value > 0)) {
      at->x[i] = at->high[i];
    } else {
      at->inside[i] = true;
      open.push_back(i);
    }
  }
  return open;
}

/// Newton's method on all of them at once, each kept in an interval that bisection halves.
void FindZeros(const Evaluation& evaluate, Brackets* at) {
  std::vector<std::size_t> open = WithoutZeroAtEnds(evaluate, at);
  for (int step = 0; step < kMostSteps && !open.empty(); ++step) {
    std::vector<double> x;
    for (const std::size_t i : open) x.push_back(at->x[i]);
    std::vector<ScalarJet> jets(open.size());
    evaluate(open, x, &jets);
    std::vector<std::size_t> still;
    for (std::size_t k = 0; k < open.size(); ++k) {
      const std::size_t i = open[k];
      (jets[k].value < 0 ? at->low : at->high)[i] = x[k];
      double next = x[k] - jets[k].value / jets[k].slope;
      if (!(next > at->low[i] && next < at->high[i])) next = 0.5 * (at->low[i] + at->high[i]);
      if (std::abs(next - x[k]) <= 1e-16 * x[k]) continue;
      at->x[i] = next;
      still.push_back(i);
    }
    open = std::move(still);
  }
}

/// The conjugates of edges, step by step.
class EdgesAtOnce {
 public:
  EdgesAtOnce(const ArrayObjective& objective, std::span<const EdgeSlopes> edges, double epsilon,
              std::span<EdgeConjugate> conjugates)
      : objective_(objective), edges_(edges), conjugates_(conjugates) {
    for (std::size_t e = 0; e < edges.size(); ++e) AddEdge(e, epsilon);
  }

  void Find() {
    FindFree();
    FindOnSums();
    FillIn();
  }

 private:
  /// A corner of an edge: the left one, or the right one.
  struct Corner {
    std::size_t edge;
    bool is_left;
    double reference, slope;
    double x = 0;
    bool is_free = true;  ///< x is where the distance has the slope
  };

  void AddEdge(std::size_t e, double epsilon) {
    const EdgeSlopes& edge = edges_[e];
    const auto clamped = [&](double raw) { return objective_.ClampReference(raw, epsilon); };
    margins_.push_back(edge.is_boundary ? objective_.Margins(edge.ref_l, epsilon)
                                        : objective_.Margins(edge.ref_l, edge.ref_r, epsilon));
    first_.push_back(corners_.size());
    corners_.push_back({e, true, clamped(edge.ref_l), edge.s_l});
    if (!edge.is_boundary) corners_.push_back({e, false, clamped(edge.ref_r), edge.s_r});
  }

  /// The distances of these corners at x.
  void Ask(const std::vector<std::size_t>& which, const std::vector<double>& x,
           std::vector<ScalarJet>* jets) const {
    std::vector<double> references;
    for (const std::size_t c : which) references.push_back(corners_[c].reference);
    objective_.Distances(references, x, *jets);
  }

  /// Every corner's angle for itself, then no less than its margin. Beyond the interval that is
  /// searched an angle is clamped anyway.
  void FindFree() {
    Brackets at;
    at.low.assign(corners_.size(), kLeastCornerMargin / 2);
    at.high.assign(corners_.size(), 2 * kPi);
    for (const Corner& c : corners_) {
      at.x.push_back(std::clamp(c.reference, kLeastCornerMargin / 2, 2 * kPi));
    }
    FindZeros(
        [&](const auto& which, const auto& x, std::vector<ScalarJet>* jets) {
          Ask(which, x, jets);
          for (std::size_t k = 0; k < which.size(); ++k) {
            ScalarJet& jet = (*jets)[k];
            jet = {jet.slope - corners_[which[k]].slope, jet.curvature, 0};
          }
        },
        &at);
    for (std::size_t c = 0; c < corners_.size(); ++c) ClampFree(at.x[c], &corners_[c]);
  }

  void ClampFree(double free, Corner* corner) const {
    const EdgeMargins& margin = margins_[corner->edge];
    corner->x = free;
    if (margin.theta < 0) return;
    corner->x = std::max(free, corner->is_left ? margin.l : margin.r);
    if (edges_[corner->edge].is_boundary) corner->x = std::min(corner->x, kPi - margin.theta);
    corner->is_free = corner->x == free;
  }

  /// Where the two of an edge exceed pi less its margin: the maximum on that side of Q_e.
  void FindOnSums() {
    Brackets at;
    for (std::size_t e = 0; e < edges_.size(); ++e) {
      const EdgeMargins& margin = margins_[e];
      if (edges_[e].is_boundary || margin.theta < 0) continue;
      const double sum = kPi - margin.theta;
      if (!(corners_[first_[e]].x + corners_[first_[e] + 1].x > sum)) continue;
      on_sum_.push_back(e);
      at.low.push_back(margin.l);
      at.high.push_back(sum - margin.r);
      at.x.push_back(0.5 * sum);
    }
    if (on_sum_.empty()) return;
    FindZeros([&](const auto& which, const auto& x,
                  std::vector<ScalarJet>* jets) { SlopesAlongSum(which, x, jets); },
              &at);
    is_inside_sum_ = at.inside;
    for (std::size_t k = 0; k < on_sum_.size(); ++k) {
      const std::size_t c = first_[on_sum_[k]];
      corners_[c].x = at.x[k];
      corners_[c + 1].x = kPi - margins_[on_sum_[k]].theta - at.x[k];
      corners_[c].is_free = corners_[c + 1].is_free = false;
    }
  }

  /// (delta'(x) - s_l) - (delta'(m - x) - s_r), which increases in x; m = pi - theta's margin.
  void SlopesAlongSum(const std::vector<std::size_t>& which, const std::vector<double>& x,
                      std::vector<ScalarJet>* jets) const {
    std::vector<std::size_t> corners;
    std::vector<double> at;
    for (std::size_t k = 0; k < which.size(); ++k) {
      const std::size_t e = on_sum_[which[k]];
      corners.insert(corners.end(), {first_[e], first_[e] + 1});
      at.insert(at.end(), {x[k], kPi - margins_[e].theta - x[k]});
    }
    std::vector<ScalarJet> both(corners.size());
    Ask(corners, at, &both);
    for (std::size_t k = 0; k < which.size(); ++k) {
      const EdgeSlopes& edge = edges_[on_sum_[which[k]]];
      const ScalarJet &l = both[2 * k], &r = both[2 * k + 1];
      (*jets)[k] = {(l.slope - edge.s_l) - (r.slope - edge.s_r), l.curvature + r.curvature, 0};
    }
  }

  void FillIn() {
    std::vector<std::size_t> all(corners_.size());
    std::vector<double> x;
    for (std::size_t c = 0; c < all.size(); ++c) {
      all[c] = c;
      x.push_back(corners_[c].x);
    }
    std::vector<ScalarJet> jets(all.size());
    Ask(all, x, &jets);
    std::fill(conjugates_.begin(), conjugates_.end(), EdgeConjugate());
    for (std::size_t c = 0; c < all.size(); ++c) {
      const Corner& corner = corners_[c];
      EdgeConjugate& g = conjugates_[corner.edge];
      g.value += corner.slope * corner.x - jets[c].value;
      (corner.is_left ? g.alpha_l : g.alpha_r) = corner.x;
      if (corner.is_free) (corner.is_left ? g.h_ll : g.h_rr) = 1 / jets[c].curvature;
    }
    for (std::size_t k = 0; k < on_sum_.size(); ++k) {
      if (!is_inside_sum_[k]) continue;
      EdgeConjugate& g = conjugates_[on_sum_[k]];
      const std::size_t c = first_[on_sum_[k]];
      g.h_ll = g.h_rr = 1 / (jets[c].curvature + jets[c + 1].curvature);
      g.h_lr = -g.h_ll;
    }
  }

  const ArrayObjective& objective_;
  std::span<const EdgeSlopes> edges_;
  std::span<EdgeConjugate> conjugates_;
  std::vector<EdgeMargins> margins_;
  std::vector<std::size_t> first_;  ///< per edge its left corner; the right one follows
  std::vector<Corner> corners_;
  std::vector<std::size_t> on_sum_;
  std::vector<bool> is_inside_sum_;
};

}  // namespace

ScalarJet ArrayObjective::Distance(double reference, double x) const {
  ScalarJet jet = {};
  Distances({&reference, 1}, {&x, 1}, {&jet, 1});
  return jet;
}

ResidualJet ArrayObjective::Residual(double reference, double x) const {
  const ScalarJet delta = Distance(reference, x);
  if (!(delta.value > 0)) return {0, std::sqrt(delta.curvature)};
  const double size = std::sqrt(2 * delta.value);
  return {std::copysign(size, delta.slope), std::abs(delta.slope) / size};
}

double ArrayObjective::ClampReference(double reference, double /*epsilon*/) const {
  return std::max(reference, kLeastCornerMargin);
}

EdgeConjugate ArrayObjective::InteriorConjugate(double ref_l, double ref_r, double epsilon,
                                                double s_l, double s_r) const {
  const EdgeSlopes edge = {ref_l, ref_r, s_l, s_r, false};
  EdgeConjugate conjugate;
  Conjugates({&edge, 1}, epsilon, {&conjugate, 1});
  return conjugate;
}

EdgeConjugate ArrayObjective::BoundaryConjugate(double ref, double epsilon, double s) const {
  const EdgeSlopes edge = {ref, 0, s, 0, true};
  EdgeConjugate conjugate;
  Conjugates({&edge, 1}, epsilon, {&conjugate, 1});
  return conjugate;
}

void ArrayObjective::Conjugates(std::span<const EdgeSlopes> edges, double epsilon,
                                std::span<EdgeConjugate> conjugates) const {
  EdgesAtOnce(*this, edges, epsilon, conjugates).Find();
}

}  // namespace cirque
