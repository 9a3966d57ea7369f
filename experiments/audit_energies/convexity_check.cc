#include <algorithm>
#include <cmath>

#include <Eigen/Eigenvalues>

#include "experiments/audit_energies/checks.h"

namespace cirque::audit_energies {
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

}  // namespace

void CheckConvexity(const Subject& s, Finding* finding) {
  finding->applies = s.energy.IsConvex();
  if (!finding->applies) return;
  for (const AuditPoint& point : s.audit_case.inside) {
    const Eigen::MatrixXd hessian = HessianAt(s.energy, point.x);
    if (!hessian.allFinite()) {
      finding->Note(std::nan(""), s.Where(point, "the Hessian is not finite"));
      continue;
    }
    finding->Note(-SmallestOverLargest(hessian), s.Where(point, "-lambda_min / lambda_max"));
    const std::vector<int> gauge = s.energy.GaugeParameters();
    if (gauge.empty()) continue;
    finding->Note(-SmallestOverLargest(WithoutGauge(hessian, gauge)),
                  s.Where(point, "-lambda_min / lambda_max without the gauge"));
    // The gradient sees nothing of the kernel, so its Hessian must be singular there.
    finding->Note(SmallestOverLargest(hessian), s.Where(point, "lambda_min of a gauged energy"));
  }
}

}  // namespace cirque::audit_energies
