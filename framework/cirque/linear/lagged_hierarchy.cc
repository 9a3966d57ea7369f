#include "cirque/linear/lagged_hierarchy.h"

#include <algorithm>
#include <cmath>

namespace cirque {
namespace {

/// A hierarchy costs about as much as this many iterations on it.
constexpr double kSetUpIterations = 10;

}  // namespace

bool LaggedHierarchy::Solve(const Eigen::VectorXd& b, double norm, double target,
                            Eigen::VectorXd* x, SolveSummary* summary) {
  x->setZero(b.size());
  failed_ = false;
  const double digits = std::log10(norm / target);
  if (has_hierarchy_) {
    if (Iterate(b, digits, target, IterationsWorthTrying(digits), x, summary)) return true;
    if (failed_) return false;
  }
  return SetUp(summary) && Iterate(b, digits, target, max_iterations_, x, summary);
}

bool LaggedHierarchy::SetUp(SolveSummary* summary) {
  const Timer timer;
  has_hierarchy_ = system_.SetUp(method_);
  digits_per_iteration_ = 0;
  ++summary->factorizations;
  summary->factorization_seconds += timer.Seconds();
  return has_hierarchy_;
}

/// On a hierarchy that was made for another matrix.
int LaggedHierarchy::IterationsWorthTrying(double digits) const {
  const double expected = digits > 0 ? digits / digits_per_iteration_ : 0;
  return static_cast<int>(std::min<double>(max_iterations_, expected + kSetUpIterations));
}

bool LaggedHierarchy::Iterate(const Eigen::VectorXd& b, double digits, double target, int most,
                              Eigen::VectorXd* x, SolveSummary* summary) {
  const Timer timer;
  MultigridResult result;
  failed_ = !system_.Solve(b.data(), target, most, x->data(), &result);
  summary->cg_iterations += result.iterations;
  summary->linear_solves += result.iterations + 1;
  summary->solve_seconds += timer.Seconds();
  const bool converged = !failed_ && result.converged;
  if (converged && digits_per_iteration_ == 0) {
    digits_per_iteration_ = std::max(digits, 1.0) / std::max(result.iterations, 1);
  }
  return converged;
}

}  // namespace cirque
