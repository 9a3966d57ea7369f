#include "cirque/audit/checks.h"

#include <algorithm>
#include <cmath>
#include <random>

#include "cirque/audit/audit_energy.h"

namespace cirque {

std::vector<Eigen::VectorXd> Directions(int n) {
  constexpr int kAxes = 6, kRandom = 4;
  std::vector<Eigen::VectorXd> directions;
  for (int i = 0; i < std::min(n, kAxes); ++i) {
    directions.push_back(Eigen::VectorXd::Unit(n, n <= kAxes ? i : i * (n - 1) / (kAxes - 1)));
  }
  std::mt19937 random(17);
  for (int k = 0; k < kRandom; ++k) {
    Eigen::VectorXd p(n);
    for (double& entry : p) entry = std::ldexp(static_cast<double>(random()), -31) - 1;
    directions.push_back(p / p.lpNorm<Eigen::Infinity>());
  }
  return directions;
}

double ValueAt(const Energy& energy, const Eigen::VectorXd& x) {
  double value;
  return energy.Evaluate(x.data(), &value, nullptr) ? value : std::nan("");
}

Eigen::VectorXd GradientAt(const Energy& energy, const Eigen::VectorXd& x) {
  Eigen::VectorXd gradient(x.size());
  double value;
  if (!energy.Evaluate(x.data(), &value, gradient.data())) gradient.setConstant(std::nan(""));
  return gradient;
}

Eigen::MatrixXd HessianAt(const Energy& energy, const Eigen::VectorXd& x) {
  SparseMatrix lower;
  if (!energy.Hessian(x.data(), &lower)) {
    return Eigen::MatrixXd::Constant(x.size(), x.size(), std::nan(""));
  }
  return Eigen::MatrixXd(lower).selfadjointView<Eigen::Lower>();
}

const std::vector<AuditCheck>& AuditChecks() {
  static const std::vector<AuditCheck> kTable = {
      {"gradient", 0.2, CheckGradient},  {"hessian", 0.2, CheckHessian},
      {"symmetry", 1e-6, CheckSymmetry}, {"convexity", 1e-12, CheckConvexity},
      {"forms", 1e-9, CheckForms},       {"domain", 0, CheckDomain},
  };
  return kTable;
}

}  // namespace cirque
