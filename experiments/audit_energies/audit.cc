// The library's checks at the samples, and value, gradient and Hessian against central differences
// of the energy in 50 digits, whose own error is far below a double's.
#include "experiments/audit_energies/audit.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "cirque/audit/checks.h"

namespace cirque::audit_energies {
namespace {

using Eigen::VectorXd;
using high_precision::Real;

/// What the digits of one case are checked with.
struct Subject {
  const AuditCase& c;
  const AuditSamples& samples;
  const EnergyInput* input;
};

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
  return s.samples.reference(*s.input, x);
}

double RelativeTo(const Real& error, double scale) {
  return static_cast<double>(abs(error)) / scale;
}

void CheckPoint(const Subject& s, const AuditPoint& point, AuditFinding* finding) {
  const auto n = static_cast<int>(point.x.size());
  const double value = ValueAt(*s.c.energy, point.x);
  const VectorXd gradient = GradientAt(*s.c.energy, point.x);
  const Eigen::MatrixXd hessian = HessianAt(*s.c.energy, point.x);
  const ReferenceValue here = Along(s, point, VectorXd::Zero(n), 0);
  finding->Note(RelativeTo(here.value - Real(value), 1 + static_cast<double>(here.magnitude)),
                s.c.Where(point, "value against 50 digits, relative to its terms"));
  const double gradient_scale = 1 + gradient.lpNorm<Eigen::Infinity>();
  const double hessian_floor = std::max(1e-3 * hessian.lpNorm<Eigen::Infinity>(), 1e-9);
  const Real h = Real(point.step) * Real(kReferenceStep);
  for (const VectorXd& p : FewDirections(hessian)) {
    const Real plus = Along(s, point, p, h).value, minus = Along(s, point, p, -h).value;
    const Real slope = (plus - minus) / (2 * h);
    const Real curvature = (plus - 2 * here.value + minus) / (h * h);
    finding->Note(RelativeTo(slope - Real(gradient.dot(p)), gradient_scale * p.lpNorm<1>()),
                  s.c.Where(point, "g.p against 50 digits, relative"));
    const double terms = p.cwiseAbs().dot(hessian.cwiseAbs() * p.cwiseAbs());
    finding->Note(RelativeTo(curvature - Real(p.dot(hessian * p)), std::max(terms, hessian_floor)),
                  s.c.Where(point, "p.Hp against 50 digits, relative to its terms"));
  }
}

void CheckDigits(const AuditSamples& samples, const AuditCase& c, AuditFinding* finding) {
  const auto sample = std::find_if(samples.cases.begin(), samples.cases.end(),
                                   [&](const SampleCase& s) { return s.name == c.name; });
  for (const AuditPoint& point : c.inside) {
    CheckPoint({c, samples, sample->input.get()}, point, finding);
  }
}

/// The case with its energy, and at every point the magnitude of the energy's terms.
AuditCase CaseOf(const SampleCase& sample, const EnergyFactory& factory,
                 const Reference& reference) {
  AuditCase c{sample.name, factory(*sample.input), sample.inside, sample.outside};
  for (AuditPoint& point : c.inside) {
    const Reals x(point.x.begin(), point.x.end());
    point.magnitude = static_cast<double>(reference(*sample.input, x).magnitude);
  }
  return c;
}

AuditRow AuditOne(const std::string& name, const EnergyFactory& factory,
                  const Registry<SampleMaker>& table) {
  AuditRow row{name, {}, {}};
  const StatusOr<SampleMaker> maker = table.Find(name);
  if (!maker.ok()) {
    row.status = Status::InvalidInput(fmt::format(
        "energy '{}' is registered but has no samples to audit it with: add a line to the table in "
        "experiments/audit_energies/samples.cc",
        name));
    return row;
  }
  const AuditSamples samples = (*maker)();
  const auto has_points = [](const SampleCase& c) { return !c.inside.empty(); };
  if (!std::any_of(samples.cases.begin(), samples.cases.end(), has_points) || !samples.reference) {
    row.status = Status::InvalidInput(
        fmt::format("the samples of energy '{}' have no points or no 50-digit reference", name));
    return row;
  }
  row.findings = AuditSampled(factory, samples);
  return row;
}

}  // namespace

std::vector<AuditCheck> ChecksWithDigits(const AuditSamples& samples) {
  std::vector<AuditCheck> checks = AuditChecks();
  const auto check = [&samples](const AuditCase& c, AuditFinding* finding) {
    CheckDigits(samples, c, finding);
  };
  checks.insert(checks.begin() + 2, {"digits", 1e-11, check});
  return checks;
}

std::vector<AuditFinding> AuditSampled(const EnergyFactory& factory, const AuditSamples& samples) {
  std::vector<AuditCase> cases;
  for (const SampleCase& sample : samples.cases) {
    cases.push_back(CaseOf(sample, factory, samples.reference));
  }
  return AuditEnergy(cases, ChecksWithDigits(samples));
}

std::vector<AuditRow> AuditRegistry(const Registry<EnergyFactory>& energies,
                                    const Registry<SampleMaker>& samples) {
  std::vector<AuditRow> rows;
  for (const std::string& name : energies.Names()) {
    rows.push_back(AuditOne(name, *energies.Find(name), samples));
  }
  return rows;
}

}  // namespace cirque::audit_energies
