#include "cirque/solver/reused_factor.h"

#include "cirque/core/timer.h"
#include "cirque/solver/conjugate_gradients.h"

namespace cirque {

bool ReusedFactor::Solve(const SparseMatrix& lower, const Eigen::VectorXd& right_side,
                         double tolerance, Eigen::VectorXd* x, SolveSummary* summary) {
  if (IterateOnFactor(lower, right_side, tolerance, x, summary)) return true;
  if (!Factorize(lower, summary)) return false;
  // With its own factor a system may fall short of the tolerance by rounding only.
  IterateOnFactor(lower, right_side, tolerance, x, summary);
  return x->allFinite();
}

bool ReusedFactor::IterateOnFactor(const SparseMatrix& lower, const Eigen::VectorXd& right_side,
                                   double tolerance, Eigen::VectorXd* x, SolveSummary* summary) {
  if (!has_factor_) return false;
  const Timer timer;
  const CgResult cg = ConjugateGradients(
      lower, right_side, [this](const Eigen::VectorXd& b) { return cholesky_->Solve(b); },
      tolerance, max_cg_iterations_, x);
  summary->cg_iterations += cg.iterations;
  summary->linear_solves += cg.iterations + 1;
  summary->solve_seconds += timer.Seconds();
  return cg.converged && x->allFinite();
}

bool ReusedFactor::Factorize(const SparseMatrix& lower, SolveSummary* summary) {
  const Timer timer;
  const int analyses_before = cholesky_->symbolic_analyses();
  has_factor_ = cholesky_->Factorize(lower);
  summary->symbolic_analyses += cholesky_->symbolic_analyses() - analyses_before;
  ++summary->factorizations;
  summary->factorization_seconds += timer.Seconds();
  return has_factor_;
}

}  // namespace cirque
