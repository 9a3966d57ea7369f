// Value, gradient and Hessian against central differences of the energy in 50 digits, whose own
// error is far below a double's.
#include <algorithm>
#include <cmath>

#include "experiments/audit_energies/checks.h"

namespace cirque::audit_energies {
namespace {

using Eigen::VectorXd;
using high_precision::Real;

/// Of the point's step: the differences' truncation error is its square, relatively.
constexpr double kReferenceStep = 1e-8;

/// Few directions, since each costs two energies in 50 digits: single parameters, pairs of which
/// the Hessian has an entry, and a mixture.
std::vector<VectorXd> FewDirections(const Eigen::MatrixXd& hessian) {
  const auto n = static_cast<int>(hessian.rows());
  std::vector<VectorXd> directions;
  for (const int i : {0, n / 3, n - 1}) {
    directions.push_back(VectorXd::Unit(n, i));
    for (int j = 0; j < n; ++j) {
      if (j == i || hessian(i, j) == 0) continue;
      directions.push_back(VectorXd::Unit(n, i) - VectorXd::Unit(n, j));
      break;
    }
  }
  directions.push_back(Directions(n).back());
  return directions;
}

ReferenceValue Along(const Subject& s, const AuditPoint& point, const VectorXd& p, const Real& h) {
  Reals x;
  for (int i = 0; i < p.size(); ++i) x.push_back(Real(point.x[i]) + h * Real(p[i]));
  return s.reference(*s.audit_case.input, x);
}

double RelativeTo(const Real& error, double scale) {
  return static_cast<double>(abs(error)) / scale;
}

void CheckPoint(const Subject& s, const AuditPoint& point, Finding* finding) {
  const auto n = static_cast<int>(point.x.size());
  const double value = ValueAt(s.energy, point.x);
  const VectorXd gradient = GradientAt(s.energy, point.x);
  const Eigen::MatrixXd hessian = HessianAt(s.energy, point.x);
  const ReferenceValue here = Along(s, point, VectorXd::Zero(n), 0);
  finding->Note(RelativeTo(here.value - Real(value), 1 + static_cast<double>(here.magnitude)),
                s.Where(point, "value against 50 digits, relative to its terms"));
  const double gradient_scale = 1 + gradient.lpNorm<Eigen::Infinity>();
  const double hessian_floor = std::max(1e-3 * hessian.lpNorm<Eigen::Infinity>(), 1e-9);
  const Real h = Real(point.step) * Real(kReferenceStep);
  for (const VectorXd& p : FewDirections(hessian)) {
    const Real plus = Along(s, point, p, h).value, minus = Along(s, point, p, -h).value;
    const Real slope = (plus - minus) / (2 * h);
    const Real curvature = (plus - 2 * here.value + minus) / (h * h);
    finding->Note(RelativeTo(slope - Real(gradient.dot(p)), gradient_scale * p.lpNorm<1>()),
                  s.Where(point, "g.p against 50 digits, relative"));
    const double terms = p.cwiseAbs().dot(hessian.cwiseAbs() * p.cwiseAbs());
    finding->Note(RelativeTo(curvature - Real(p.dot(hessian * p)), std::max(terms, hessian_floor)),
                  s.Where(point, "p.Hp against 50 digits, relative to its terms"));
  }
}

}  // namespace

void CheckDigits(const Subject& s, Finding* finding) {
  for (const AuditPoint& point : s.audit_case.inside) CheckPoint(s, point, finding);
}

}  // namespace cirque::audit_energies
