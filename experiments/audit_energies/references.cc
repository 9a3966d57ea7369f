#include <algorithm>

#include "experiments/audit_energies/samples.h"

namespace cirque::audit_energies {
namespace {

using high_precision::Pi;
using high_precision::Real;

void Add(const Real& term, ReferenceValue* sum) {
  sum->value += term;
  sum->magnitude += abs(term);
}

/// t - log t - 1.
Real ItakuraSaito(const Real& t) { return t - log(t) - 1; }

}  // namespace

ReferenceValue CirclePatternReference(const EnergyInput& input, const Reals& rho) {
  const Triangulation& t = input.triangulation;
  const Eigen::VectorXd& alpha = input.coherent.value;
  ReferenceValue sum;
  for (const Real& r : rho) Add(2 * Pi() * r, &sum);
  for (const Index h : t.edge_halfedge) {
    const Index g = t.twin[h];
    const Real& rho_i = rho[Triangulation::Face(h)];
    if (g == kNone) {
      Add(-2 * Real(alpha[h]) * rho_i, &sum);
      continue;
    }
    const Real& rho_j = rho[Triangulation::Face(g)];
    const Real star = Real(alpha[h]) + Real(alpha[g]);
    Add(high_precision::EdgePotential(rho_i - rho_j, Pi() - star), &sum);
    Add(-star * (rho_i + rho_j), &sum);
  }
  return sum;
}

ReferenceValue CoherentAngleBarrierReference(const EnergyInput& input, const Reals& angles) {
  const Triangulation& t = input.triangulation;
  ReferenceValue sum;
  const auto add = [&](const Real& angle, const Real& reference) {
    Add(ItakuraSaito(angle / std::max(reference, Real(input.epsilon))), &sum);
  };
  for (Index h = 0; h < t.num_halfedges(); ++h) add(angles[h], Real(input.reference.value[h]));
  for (const Index h : t.edge_halfedge) {
    const Index g = t.twin[h];
    const Real right = g == kNone ? Real(0) : angles[g];
    const Real right_reference = g == kNone ? Real(0) : Real(input.reference.value[g]);
    add(Pi() - angles[h] - right, Pi() - Real(input.reference.value[h]) - right_reference);
  }
  return sum;
}

ReferenceValue LorentzReference(const EnergyInput& input, const Reals& x) {
  ReferenceValue sum;
  const Real xx = x[0] * x[0] + x[1] * x[1] + x[2] * x[2];
  for (std::size_t i = 0; i < input.points.size(); ++i) {
    const Eigen::Vector3d& v = input.points[i];
    const Real vx = Real(v[0]) * x[0] + Real(v[1]) * x[1] + Real(v[2]) * x[2];
    Add(Real(input.weights[i]) * (log(1 - vx) - log(1 - xx) / 2), &sum);
  }
  return sum;
}

}  // namespace cirque::audit_energies
