#include "cirque/linear/rank_solver.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "cirque/linear/conjugate_gradients.h"

namespace cirque {

RankSolver::RankSolver(const Halo* halo, std::string method, int max_cg_iterations)
    : halo_(*halo),
      max_cg_iterations_(max_cg_iterations),
      system_(halo->ranks().MakeSystem()),
      hierarchy_(system_.get(), std::move(method), max_cg_iterations) {}

void RankSolver::SetRows(LocalRows rows, std::vector<int> gauge) {
  rows_ = std::move(rows);
  gauge_ = std::move(gauge);
  diagonal_.resize(rows_.num_rows());
  border_.clear();
  for (int i = 0; i < rows_.num_rows(); ++i) {
    diagonal_[i] = rows_.Diagonal(i);
    for (int k = rows_.start[i]; k < rows_.start[i + 1]; ++k) {
      if (rows_.column[k] < rows_.num_rows()) continue;
      border_.push_back({i, rows_.column[k], rows_.value[k]});
    }
  }
}

void RankSolver::Damp(double damping) {
  for (int i = 0; i < rows_.num_rows(); ++i) rows_.Diagonal(i) = diagonal_[i] + damping;
  for (const int g : gauge_) rows_.Diagonal(g) *= 2;
}

double RankSolver::MeanDiagonal() const {
  const double count = halo_.ranks().Sum(static_cast<double>(diagonal_.size()));
  return halo_.ranks().Sum(diagonal_.sum()) / count;
}

bool RankSolver::PrepareForSystemsNear(SolveSummary* summary) {
  if (!Eliminate(summary)) return false;
  near_diagonal_.resize(rows_.num_rows());
  for (int i = 0; i < rows_.num_rows(); ++i) near_diagonal_[i] = rows_.Diagonal(i);
  return true;
}

bool RankSolver::Eliminate(SolveSummary* summary) {
  const Timer timer;
  LocalElimination elimination(rows_, halo_);
  const bool as_before = elimination_ && elimination_->HasSameKept(elimination);
  if (!halo_.ranks().All(as_before)) {
    hierarchy_.Forget();
    ++summary->symbolic_analyses;
  }
  elimination_ = std::move(elimination);
  const bool positive = halo_.ranks().All(elimination_->SetValues(rows_, halo_));
  const bool done = positive && system_->SetRows(elimination_->Complement(rows_));
  summary->factorization_seconds += timer.Seconds();
  return done;
}

bool RankSolver::SolveReduced(const Eigen::VectorXd& b, double target, Eigen::VectorXd* x,
                              SolveSummary* summary) {
  const Eigen::VectorXd reduced = elimination_->Reduce(b);
  Eigen::VectorXd of_kept;
  if (!hierarchy_.Solve(reduced, Norm(reduced), target, &of_kept, summary)) return false;
  elimination_->Expand(of_kept, b, x);
  return true;
}

bool RankSolver::Solve(const Eigen::VectorXd& b, double tolerance, Eigen::VectorXd* x,
                       SolveSummary* summary) {
  if (near_diagonal_.size() > 0) return SolveNear(b, tolerance, x, summary);
  return Eliminate(summary) && SolveReduced(b, tolerance * Norm(b), x, summary) &&
         halo_.ranks().All(x->allFinite());
}

bool RankSolver::SolveNear(const Eigen::VectorXd& b, double tolerance, Eigen::VectorXd* x,
                           SolveSummary* summary) {
  PatchSmoother smoother(OwnBlock(), near_diagonal_);
  bool cycled = true;
  const auto solve = [&](const Eigen::VectorXd& right_side, Eigen::VectorXd* of_it) {
    const double target = kInnerMultigridTolerance * Norm(right_side);
    if (cycled) cycled = SolveReduced(right_side, target, of_it, summary);
    if (!cycled) of_it->setZero(right_side.size());
  };
  const auto precondition = [&](const Eigen::VectorXd& right_side, Eigen::VectorXd* of_it) {
    Smooth(&smoother, solve, right_side, of_it);
  };
  const auto apply = [&](const Eigen::VectorXd& from, Eigen::VectorXd* to) { *to = Times(from); };
  const auto dot = [&](const Eigen::VectorXd& a, const Eigen::VectorXd& c) { return Dot(a, c); };
  const CgResult cg =
      ConjugateGradients(apply, b, precondition, tolerance, max_cg_iterations_, x, dot);
  return cycled && cg.converged && halo_.ranks().All(x->allFinite());
}

/// PatchSmoother::Apply, whose sweeps stay on each rank.
void RankSolver::Smooth(PatchSmoother* smoother, const Preconditioner& solve,
                        const Eigen::VectorXd& b, Eigen::VectorXd* x) const {
  Eigen::VectorXd swept = Eigen::VectorXd::Zero(b.size()), left = b;
  smoother->SweepForward(b, &swept, &left);
  SubtractGhosts(swept, &left);
  solve(left, x);
  *x += swept;
  left = b;
  SubtractGhosts(*x, &left);
  smoother->SweepBackward(left, x);
}

void RankSolver::SubtractGhosts(const Eigen::VectorXd& x, Eigen::VectorXd* b) const {
  const Eigen::VectorXd local = WithGhosts(x);
  for (const auto& [row, ghost, value] : border_) (*b)[row] -= value * local[ghost];
}

Eigen::VectorXd RankSolver::WithGhosts(const Eigen::VectorXd& own) const {
  Eigen::VectorXd local(halo_.num_local());
  local.head(own.size()) = own;
  halo_.Fill(&local);
  return local;
}

Eigen::VectorXd RankSolver::Times(const Eigen::VectorXd& x) const {
  return rows_.Times(WithGhosts(x));
}

double RankSolver::Dot(const Eigen::VectorXd& a, const Eigen::VectorXd& b) const {
  return halo_.ranks().Sum(a.dot(b));
}

double RankSolver::Norm(const Eigen::VectorXd& a) const { return std::sqrt(Dot(a, a)); }

/// The lower triangle of what couples own unknowns.
SparseMatrix RankSolver::OwnBlock() const {
  const int n = rows_.num_rows();
  SparseMatrix lower(n, n);
  // A symmetric matrix' rows are its columns.
  const auto for_each = [&](int j, const auto& visit) {
    for (int k = rows_.start[j]; k < rows_.start[j + 1]; ++k) {
      if (rows_.column[k] >= j && rows_.column[k] < n) visit(k);
    }
  };
  int* outer = lower.outerIndexPtr();
  outer[0] = 0;
  for (int j = 0; j < n; ++j) {
    outer[j + 1] = outer[j];
    for_each(j, [&](int) { ++outer[j + 1]; });
  }
  lower.resizeNonZeros(outer[n]);
  int entry = 0;
  for (int j = 0; j < n; ++j) {
    for_each(j, [&](int k) {
      lower.innerIndexPtr()[entry] = rows_.column[k];
      lower.valuePtr()[entry++] = rows_.value[k];
    });
  }
  return lower;
}

}  // namespace cirque
