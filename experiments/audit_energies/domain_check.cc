#include <algorithm>
#include <limits>

#include <ceres/problem.h>
#include <fmt/format.h>

#include "experiments/audit_energies/checks.h"

namespace cirque::audit_energies {
namespace {

bool ResidualsRefuse(const Energy& energy, Eigen::VectorXd x) {
  if (energy.residual_form() == ResidualForm::kAbsent) return true;
  ceres::Problem problem;
  energy.AddResidualBlocks(x.data(), &problem);
  double cost;
  return !problem.Evaluate({}, &cost, nullptr, nullptr, nullptr);
}

void CheckOutside(const Subject& s, const AuditPoint& point, Finding* finding) {
  const double* x = point.x.data();
  Eigen::VectorXd gradient(point.x.size());
  double value;
  SparseMatrix lower;
  std::string accepting;
  if (s.energy.Evaluate(x, &value, nullptr)) accepting += " value";
  if (s.energy.Evaluate(x, &value, gradient.data())) accepting += " value-and-gradient";
  if (s.energy.Gradient(x, gradient.data())) accepting += " Gradient()";
  if (s.energy.Hessian(x, &lower)) accepting += " Hessian()";
  if (!ResidualsRefuse(s.energy, point.x)) accepting += " residuals";
  const auto count = static_cast<double>(std::count(accepting.begin(), accepting.end(), ' '));
  finding->Note(count, s.Where(point, "outside the domain, yet not refused by:" + accepting));
}

}  // namespace

void CheckDomain(const Subject& s, Finding* finding) {
  for (const AuditPoint& point : s.audit_case.outside) CheckOutside(s, point, finding);
  if (s.audit_case.inside.empty()) return;
  // These lie outside every domain. A parameter that residuals do not touch has nobody to refuse
  // it, so all are made bad.
  for (const double bad :
       {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity(),
        -std::numeric_limits<double>::infinity()}) {
    AuditPoint point = s.audit_case.inside.front();
    point.name = fmt::format("all parameters {}", bad);
    point.x.setConstant(bad);
    CheckOutside(s, point, finding);
    // One bad parameter must be seen by the forms that see all of them.
    point = s.audit_case.inside.front();
    point.x[point.x.size() / 2] = bad;
    double value;
    SparseMatrix lower;
    Eigen::VectorXd gradient(point.x.size());
    const int accepted = s.energy.Evaluate(point.x.data(), &value, gradient.data()) +
                         s.energy.Gradient(point.x.data(), gradient.data()) +
                         s.energy.Hessian(point.x.data(), &lower);
    finding->Note(accepted, s.Where(point, fmt::format("one parameter {}, not refused", bad)));
  }
}

}  // namespace cirque::audit_energies
