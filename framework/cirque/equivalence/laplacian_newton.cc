#include "cirque/equivalence/laplacian_newton.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "cirque/solver/newton_loop.h"
#include "cirque/solver/solve_run.h"

namespace cirque {
namespace {

/// A row's sum below this share of its diagonal is what rounding of the diagonal leaves.
constexpr double kRoundedSum = 1e-13;
constexpr double kAngleRounding = 1e-14;  ///< [rad]: of angle sums in doubles

class LaplacianDirection {
 public:
  explicit LaplacianDirection(SolveRun* run) : run_(*run) {}

  bool operator()(const Eigen::VectorXd& x, const Eigen::VectorXd& gradient,
                  LevenbergMarquardtDamping* /*damping*/, Eigen::VectorXd* direction) {
    if (!run_.Hessian(x, &hessian_)) return false;
    const auto n = hessian_.cols();
    Eigen::MatrixXd weight = Eigen::MatrixXd::Zero(n, n);
    Eigen::VectorXd diagonal = Eigen::VectorXd::Zero(n);
    for (Eigen::Index j = 0; j < n; ++j) {
      for (SparseMatrix::InnerIterator entry(hessian_, static_cast<int>(j)); entry; ++entry) {
        if (entry.row() == j) {
          diagonal[j] = entry.value();
        } else {
          weight(entry.row(), j) = weight(j, entry.row()) = std::max(0.0, -entry.value());
        }
      }
    }
    Eigen::VectorXd held = diagonal - weight.rowwise().sum();
    for (Eigen::Index j = 0; j < n; ++j) {
      if (held[j] < kRoundedSum * diagonal[j]) held[j] = 0;
    }
    *direction = -SolveLaplacian(std::move(weight), std::move(held), gradient, kAngleRounding);
    ++run_.summary().factorizations;
    return direction->allFinite() && direction->dot(gradient) < 0;
  }

 private:
  SolveRun& run_;
  SparseMatrix hessian_;
};

}  // namespace

Eigen::VectorXd SolveLaplacian(Eigen::MatrixXd weight, Eigen::VectorXd held, Eigen::VectorXd b,
                               double rounding) {
  const auto n = b.size();
  Eigen::VectorXd sum = Eigen::VectorXd::Zero(n);
  for (Eigen::Index k = n - 1; k >= 0; --k) {
    sum[k] = held[k] + weight.col(k).head(k).sum();
    if (!(sum[k] > 0)) continue;
    if (std::abs(b[k]) <= rounding) b[k] = 0;
    for (Eigen::Index i = 0; i < k; ++i) {
      if (weight(i, k) == 0) continue;
      const double share = weight(i, k) / sum[k];
      b[i] += share * b[k];
      held[i] += share * held[k];
      weight.col(i).head(k) += share * weight.col(k).head(k);
    }
  }
  for (Eigen::Index k = 0; k < n; ++k) {
    const double known = weight.col(k).head(k).dot(b.head(k));
    b[k] = sum[k] > 0 ? (b[k] + known) / sum[k] : 0;
  }
  return b;
}

SolveSummary MinimizeByLaplacians(const Energy& energy, const SolverLimits& limits,
                                  const SolveControl& control, Eigen::VectorXd* x) {
  SolveRun run("newton", limits, control, energy);
  LaplacianDirection direction(&run);
  IterateNewton(direction, &run, x, SearchToRest);
  return run.Finish(*x);
}

}  // namespace cirque
