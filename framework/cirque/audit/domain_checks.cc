// Where an energy is defined, and that it is convex there if it says so.
#include <algorithm>
#include <cmath>
#include <limits>

#include <Eigen/Eigenvalues>
#include <ceres/problem.h>
#include <fmt/format.h>

#include "cirque/audit/checks.h"

namespace cirque {
namespace {

/// The matrix without the rows and columns of the gauge parameters.
Eigen::MatrixXd WithoutGauge(const Eigen::MatrixXd& matrix, const std::vector<int>& gauge) {
  std::vector<int> kept;
  for (int i = 0; i < matrix.rows(); ++i) {
    if (std::find(gauge.begin(), gauge.end(), i) == gauge.end()) kept.push_back(i);
  }
  return matrix(kept, kept);
}

double SmallestOverLargest(const Eigen::MatrixXd& matrix) {
  const Eigen::VectorXd eigenvalues =
      Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(matrix, Eigen::EigenvaluesOnly).eigenvalues();
  const double largest = eigenvalues.cwiseAbs().maxCoeff();
  return largest == 0 ? 0 : eigenvalues[0] / largest;
}

bool ResidualsRefuse(const Energy& energy, Eigen::VectorXd x) {
  if (energy.residual_form() == ResidualForm::kAbsent) return true;
  ceres::Problem problem;
  energy.AddResidualBlocks(x.data(), &problem);
  double cost;
  return !problem.Evaluate({}, &cost, nullptr, nullptr, nullptr);
}

void CheckOutside(const AuditCase& c, const AuditPoint& point, AuditFinding* finding) {
  const double* x = point.x.data();
  Eigen::VectorXd gradient(point.x.size());
  double value;
  SparseMatrix lower;
  std::string accepting;
  if (c.energy->Evaluate(x, &value, nullptr)) accepting += " value";
  if (c.energy->Evaluate(x, &value, gradient.data())) accepting += " value-and-gradient";
  if (c.energy->Gradient(x, gradient.data())) accepting += " Gradient()";
  if (c.energy->Hessian(x, &lower)) accepting += " Hessian()";
  if (!ResidualsRefuse(*c.energy, point.x)) accepting += " residuals";
  const auto count = static_cast<double>(std::count(accepting.begin(), accepting.end(), ' '));
  finding->Note(count, c.Where(point, "outside the domain, yet not refused by:" + accepting));
}

}  // namespace

void CheckConvexity(const AuditCase& c, AuditFinding* finding) {
  finding->applies = c.energy->IsConvex();
  if (!finding->applies) return;
  for (const AuditPoint& point : c.inside) {
    const Eigen::MatrixXd hessian = HessianAt(*c.energy, point.x);
    if (!hessian.allFinite()) {
      finding->Note(std::nan(""), c.Where(point, "the Hessian is not finite"));
      continue;
    }
    finding->Note(-SmallestOverLargest(hessian), c.Where(point, "-lambda_min / lambda_max"));
    const std::vector<int> gauge = c.energy->GaugeParameters();
    if (gauge.empty()) continue;
    finding->Note(-SmallestOverLargest(WithoutGauge(hessian, gauge)),
                  c.Where(point, "-lambda_min / lambda_max without the gauge"));
    // The gradient sees nothing of the kernel, so its Hessian must be singular there.
    finding->Note(SmallestOverLargest(hessian), c.Where(point, "lambda_min of a gauged energy"));
  }
}

void CheckDomain(const AuditCase& c, AuditFinding* finding) {
  for (const AuditPoint& point : c.outside) CheckOutside(c, point, finding);
  if (c.inside.empty()) return;
  // These lie outside every domain. A parameter that residuals do not touch has nobody to refuse
  // it, so all are made bad.
  for (const double bad :
       {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity(),
        -std::numeric_limits<double>::infinity()}) {
    AuditPoint point = c.inside.front();
    point.name = fmt::format("all parameters {}", bad);
    point.x.setConstant(bad);
    CheckOutside(c, point, finding);
    // One bad parameter must be seen by the forms that see all of them.
    point = c.inside.front();
    point.x[point.x.size() / 2] = bad;
    double value;
    SparseMatrix lower;
    Eigen::VectorXd gradient(point.x.size());
    const int accepted = c.energy->Evaluate(point.x.data(), &value, gradient.data()) +
                         c.energy->Gradient(point.x.data(), gradient.data()) +
                         c.energy->Hessian(point.x.data(), &lower);
    finding->Note(accepted, c.Where(point, fmt::format("one parameter {}, not refused", bad)));
  }
}

}  // namespace cirque
