#include <algorithm>
#include <cmath>

#include <glog/logging.h>

#include "cirque/energy/angle_constraints.h"
#include "cirque/energy/angle_objective.h"

#include "experiments/audit_energies/samples.h"

namespace cirque::audit_energies {
namespace {

using high_precision::Pi;
using high_precision::Real;

/// The slack for points built to lie on a side of Q_e.
const char kTiny[] = "1e-45";
constexpr int kBisections = 170;

struct Corner {
  Real reference, slope;
};

/// Those of Q_e.
struct Margins {
  Real l, r, theta;
};

/// epsilon, but at corners half of a reference that is less than twice that, as far as the least
/// margin.
Margins MarginsOf(const Real& raw_l, const Real& raw_r, const Real& epsilon) {
  const auto of_corner = [&](const Real& reference) -> Real {
    return std::min(epsilon, std::max(Real(kLeastCornerMargin), Real(reference / 2)));
  };
  return {of_corner(raw_l), of_corner(raw_r), epsilon};
}

/// An objective of corner angles: its distance, where its slope is given, and where on x_l + x_r =
/// sum the slopes of both corners agree; each in closed form.
class SeparableReference {
 public:
  explicit SeparableReference(std::string objective) : objective_(std::move(objective)) {}

  Real Distance(const Real& ref, const Real& x) const {
    if (objective_ == "entropy") return x > 0 ? Real(x * log(x / ref) - x + ref) : ref;
    return Weight(ref) * (x - ref) * (x - ref) / 2;
  }

  Real WithSlope(const Corner& c) const {
    if (objective_ == "entropy") return c.reference * exp(c.slope);
    return c.reference + c.slope / Weight(c.reference);
  }

  Real OnSum(const Corner& l, const Corner& r, const Real& sum) const {
    if (objective_ == "entropy") {
      const Real ratio = l.reference / r.reference * exp(l.slope - r.slope);
      return sum * ratio / (1 + ratio);
    }
    const Real w = Weight(l.reference), v = Weight(r.reference);
    return (l.slope - r.slope + w * l.reference + v * (sum - r.reference)) / (w + v);
  }

  bool IsBounded() const { return objective_ != "least_squares"; }

  Real Clamp(double reference, double epsilon) const {
    if (objective_ == "entropy") return std::max(reference, std::min(epsilon, kLeastCornerMargin));
    return objective_ == "weighted_quadratic" ? std::max(reference, epsilon) : reference;
  }

 private:
  Real Weight(const Real& ref) const {
    return objective_ == "weighted_quadratic" ? Real(1 / (ref * ref)) : Real(1);
  }

  std::string objective_;
};

/// max over Q_e of s.a - phi(a): the best of the stationary points of the inside, the sides and of
/// the corners that lie in Q_e.
Real SeparableInterior(const SeparableReference& o, const Corner& l, const Corner& r,
                       const Margins& m) {
  const auto value = [&](const Real& a, const Real& b) -> Real {
    return l.slope * a - o.Distance(l.reference, a) + r.slope * b - o.Distance(r.reference, b);
  };
  const Real free_l = o.WithSlope(l), free_r = o.WithSlope(r);
  if (!o.IsBounded()) return value(free_l, free_r);
  const Real sum = Pi() - m.theta, along = o.OnSum(l, r, sum);
  const Real candidates[][2] = {{free_l, free_r}, {m.l, free_r},    {free_l, m.r},       {m.l, m.r},
                                {m.l, sum - m.l}, {sum - m.r, m.r}, {along, sum - along}};
  const Real slack(kTiny);
  Real best = value(m.l, m.r);
  for (const auto& [a, b] : candidates) {
    if (a >= m.l - slack && b >= m.r - slack && a + b <= sum + slack)
      best = std::max(best, value(a, b));
  }
  return best;
}

Real SeparableBoundary(const SeparableReference& o, const Corner& c, const Margins& m) {
  Real a = o.WithSlope(c);
  if (o.IsBounded()) a = std::min(std::max(a, m.l), Real(Pi() - m.theta));
  return c.slope * a - o.Distance(c.reference, a);
}

/// t - log t - 1 with t = x / ref.
Real BarrierDistance(const Real& ref, const Real& x) { return x / ref - log(x / ref) - 1; }

/// The theta at which the corners' stationarity 1/alpha = 1/ref - 1/theta0 - s + 1/theta closes the
/// sum alpha + theta = pi, by bisection: the sum grows with theta.
Real BarrierTheta(const std::vector<Real>& offsets) {
  Real low = 0, high = Pi();
  for (int i = 0; i < kBisections; ++i) {
    const Real theta = (low + high) / 2;
    Real sum = theta;
    bool beyond_pole = false;
    for (const Real& p : offsets) {
      const Real inverse = p + 1 / theta;
      beyond_pole = beyond_pole || inverse <= 0;
      sum += 1 / inverse;
    }
    (beyond_pole || sum > Pi() ? high : low) = theta;
  }
  return (low + high) / 2;
}

Real BarrierConjugate(const std::vector<Corner>& corners, const Real& theta_reference) {
  std::vector<Real> offsets;
  for (const Corner& c : corners) {
    offsets.push_back(1 / c.reference - 1 / theta_reference - c.slope);
  }
  const Real theta = BarrierTheta(offsets);
  Real value = -BarrierDistance(theta_reference, theta);
  for (std::size_t k = 0; k < corners.size(); ++k) {
    const Real alpha = 1 / (offsets[k] + 1 / theta);
    value += corners[k].slope * alpha - BarrierDistance(corners[k].reference, alpha);
  }
  return value;
}

/// The conjugate of edge e; `slope` gives (A'y)_h.
template <class Slope>
Real EdgeConjugateOf(const std::string& objective, const EnergyInput& input, Index e,
                     const Slope& slope) {
  const Triangulation& t = input.triangulation;
  const Index l = t.edge_halfedge[e], r = t.twin[l];
  const Eigen::VectorXd& reference = input.reference.value;
  if (objective == "barrier") {
    const auto clamp = [&](const Real& x) { return std::max(x, Real(input.epsilon)); };
    std::vector<Corner> corners = {{clamp(reference[l]), slope(l)}};
    if (r != kNone) corners.push_back({clamp(reference[r]), slope(r)});
    const Real right = r == kNone ? Real(0) : Real(reference[r]);
    return BarrierConjugate(corners, clamp(Pi() - Real(reference[l]) - right));
  }
  const SeparableReference separable(objective);
  const Margins margins =
      MarginsOf(Real(reference[l]), r == kNone ? Real(0) : Real(reference[r]), Real(input.epsilon));
  const auto corner = [&](Index h) {
    return Corner{separable.Clamp(reference[h], input.epsilon), slope(h)};
  };
  return r == kNone ? SeparableBoundary(separable, corner(l), margins)
                    : SeparableInterior(separable, corner(l), corner(r), margins);
}

}  // namespace

Reference DualReference(const std::string& objective) {
  CHECK(AngleObjectives().Find(objective).ok()) << objective;
  return [objective](const EnergyInput& input, const Reals& y) {
    const AngleConstraints constraints(input.triangulation, input.targets);
    ReferenceValue sum;
    for (int row = 0; row < constraints.num_rows(); ++row) {
      const double target = y[row] > 0 ? constraints.Lower(row) : constraints.Upper(row);
      const Real term = Real(target) * y[row];
      sum.value -= term;
      sum.magnitude += abs(term);
    }
    const auto slope = [&](Index h) -> Real {
      const int row = constraints.VertexRow(h);
      return row == kNone ? y[Triangulation::Face(h)] : Real(y[Triangulation::Face(h)] + y[row]);
    };
    for (Index e = 0; e < input.triangulation.num_edges(); ++e) {
      const Real g = EdgeConjugateOf(objective, input, e, slope);
      sum.value += g;
      sum.magnitude += abs(g);
    }
    return sum;
  };
}

}  // namespace cirque::audit_energies
