#include "cirque/linear/lagged_factorization.h"

#include <algorithm>
#include <cmath>

#include "cirque/core/solve_summary.h"
#include "cirque/linear/conjugate_gradients.h"
#include "cirque/linear/patch_smoother.h"
#include "cirque/linear/sparse_matrix.h"

namespace cirque {
namespace {

constexpr double kWithNewFactor = 2;  ///< iterations a decade, as the matrix goes on to change
constexpr double kLeastDecades = 0.1;

}  // namespace

bool LaggedFactorization::Solve(const SparseMatrix& lower, const Eigen::VectorXd& right_side,
                                const SolveAccuracy& accuracy, Eigen::VectorXd* x,
                                SolveSummary* summary) {
  if (!PaysToFactor(accuracy.goal) &&
      IterateOnFactor(lower, right_side, accuracy.tolerance, x, summary)) {
    return true;
  }
  return SolveOnOwnFactor(lower, right_side, accuracy.tolerance, x, summary);
}

bool LaggedFactorization::SolveOnOwnFactor(const SparseMatrix& lower,
                                           const Eigen::VectorXd& right_side, double tolerance,
                                           Eigen::VectorXd* x, SolveSummary* summary) {
  if (!Factorize(lower, summary)) return false;
  const Timer timer;
  *x = cholesky_->Solve(right_side);
  ++summary->linear_solves;
  cholesky_->KeepInSinglePrecision();
  const Eigen::VectorXd rest = right_side - lower.selfadjointView<Eigen::Lower>() * *x;
  const double target = tolerance * right_side.norm(), left = rest.norm();
  summary->solve_seconds += timer.Seconds();
  if (left > target) {
    // Only rounding can be the reason, so whatever this reaches is as near as it gets.
    Eigen::VectorXd correction;
    IterateOnFactor(lower, rest, target / left, &correction, summary);
    *x += correction;
  }
  iterations_a_decade_ = 0;
  return x->allFinite();
}

bool LaggedFactorization::PaysToFactor(double goal) const {
  const double decades = std::max(0.0, -std::log10(goal));
  return (iterations_a_decade_ - kWithNewFactor) * decades > max_cg_iterations_;
}

bool LaggedFactorization::IterateOnFactor(const SparseMatrix& lower,
                                          const Eigen::VectorXd& right_side, double tolerance,
                                          Eigen::VectorXd* x, SolveSummary* summary) {
  if (!has_factor_) return false;
  const Timer timer;
  PatchSmoother smoother(lower, factored_diagonal_);
  const auto solve = [this](const Eigen::VectorXd& b, Eigen::VectorXd* of_b) {
    cholesky_->Solve(b, of_b);
  };
  const CgResult cg = ConjugateGradients(lower, right_side, smoother.Around(solve), tolerance,
                                         max_cg_iterations_, x);
  iterations_a_decade_ = cg.iterations / std::max(kLeastDecades, -std::log10(tolerance));
  summary->cg_iterations += cg.iterations;
  summary->linear_solves += cg.iterations;
  summary->solve_seconds += timer.Seconds();
  return cg.converged && x->allFinite();
}

bool LaggedFactorization::Factorize(const SparseMatrix& lower, SolveSummary* summary) {
  const Timer timer;
  const int analyses_before = cholesky_->symbolic_analyses();
  has_factor_ = cholesky_->Factorize(lower);
  factored_diagonal_ = Diagonal(lower);
  summary->symbolic_analyses += cholesky_->symbolic_analyses() - analyses_before;
  ++summary->factorizations;
  summary->factorization_seconds += timer.Seconds();
  return has_factor_;
}

}  // namespace cirque
