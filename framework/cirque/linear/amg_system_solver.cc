#include "cirque/linear/amg_system_solver.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <fmt/format.h>

#include "cirque/core/solve_summary.h"
#include "cirque/linear/conjugate_gradients.h"
#include "cirque/linear/patch_smoother.h"
#include "cirque/linear/registry.h"
#include "cirque/linear/sparse_matrix.h"

namespace cirque {
namespace {

constexpr int kFactorIterations = 6;
constexpr int kMostFailures = 2;
/// A hierarchy costs about as much as this many iterations on it.
constexpr double kSetUpIterations = 10;
constexpr double kInnerTolerance = 0.1;  ///< of the solves inside conjugate gradients

}  // namespace

/// The system that elimination leaves, in the form of the factorization whose place it takes: its
/// factor is the matrix itself, and it solves to a tolerance.
class AmgSystemSolver::Reduced final : public SparseCholesky {
 public:
  explicit Reduced(const AmgOptions& options) : options_(options) {}

  /// What the next Solve is about.
  void Prepare(double target, SolveSummary* summary) {
    target_ = target;
    summary_ = summary;
    converged_ = false;
    error_.clear();
  }

  bool converged() const { return converged_; }
  const std::string& error() const { return error_; }  ///< of the library; empty: none

  void Solve(const Eigen::VectorXd& b, Eigen::VectorXd* x) override {
    x->setZero(b.size());
    const bool reused = has_hierarchy_;
    const int most = reused ? IterationsWorthTrying(b.norm()) : options_.max_cg_iterations;
    if (!reused && !SetUp()) return;
    if (!Iterate(b, most, x) || converged_ || !reused) return;
    if (SetUp()) Iterate(b, options_.max_cg_iterations, x);
  }

 protected:
  /// Another pattern leaves other unknowns.
  bool Analyze(const SparseMatrix&) override {
    has_hierarchy_ = false;
    return Load();
  }

  bool FactorizeNumerically(const SparseMatrix& lower) override {
    if (!system_) return false;
    const Timer timer;
    const bool taken = system_->SetMatrix({static_cast<int>(lower.cols()), lower.outerIndexPtr(),
                                           lower.innerIndexPtr(), lower.valuePtr()});
    summary_->factorization_seconds += timer.Seconds();
    return taken || Fail();
  }

 private:
  bool Load() {
    if (system_) return true;
    const auto library = LoadMultigrid();
    if (!library.ok()) {
      error_ = library.status().message();
      return false;
    }
    method_ = options_.multigrid.empty() ? (*library)->Methods().front() : options_.multigrid;
    system_ = (*library)->MakeSystem();
    return true;
  }

  bool Fail() {
    error_ = system_->error();
    return false;
  }

  bool SetUp() {
    const Timer timer;
    has_hierarchy_ = system_->SetUp(method_);
    digits_per_iteration_ = 0;
    ++summary_->factorizations;
    summary_->factorization_seconds += timer.Seconds();
    return has_hierarchy_ || Fail();
  }

  /// On a hierarchy that was made for another matrix.
  int IterationsWorthTrying(double start) const {
    const double digits = std::log10(start / target_);
    const double expected = digits > 0 ? digits / digits_per_iteration_ : 0;
    return static_cast<int>(
        std::min<double>(options_.max_cg_iterations, expected + kSetUpIterations));
  }

  bool Iterate(const Eigen::VectorXd& right_side, int most, Eigen::VectorXd* x) {
    const Timer timer;
    MultigridResult result;
    const bool done = system_->Solve(right_side.data(), target_, most, x->data(), &result);
    summary_->cg_iterations += result.iterations;
    summary_->linear_solves += result.iterations + 1;
    summary_->solve_seconds += timer.Seconds();
    converged_ = done && result.converged;
    if (converged_ && digits_per_iteration_ == 0) {
      const double digits = std::log10(right_side.norm() / target_);
      digits_per_iteration_ = std::max(digits, 1.0) / std::max(result.iterations, 1);
    }
    return done || Fail();
  }

  const AmgOptions options_;
  std::string method_, error_;
  std::unique_ptr<MultigridSystem> system_;
  SolveSummary* summary_ = nullptr;
  double target_ = 0;
  double digits_per_iteration_ = 0;  ///< on the hierarchy's own matrix; 0: not known yet
  bool has_hierarchy_ = false, converged_ = false;
};

AmgSystemSolver::AmgSystemSolver(const AmgOptions& options)
    : reduced_(new Reduced(options)),
      elimination_(MakeEliminatingCholesky(std::unique_ptr<SparseCholesky>(reduced_))),
      factor_(MakeCholesky(), kFactorIterations),
      max_cg_iterations_(options.max_cg_iterations) {}

AmgSystemSolver::~AmgSystemSolver() = default;

bool AmgSystemSolver::Solve(const SparseMatrix& lower, const Eigen::VectorXd& right_side,
                            const SolveAccuracy& accuracy, Eigen::VectorXd* x,
                            SolveSummary* summary) {
  ++num_systems_;
  if (num_factored_ < kMostFailures &&
      SolveByMultigrid(lower, right_side, accuracy.tolerance, x, summary)) {
    return true;
  }
  if (!factor_.Solve(lower, right_side, accuracy, x, summary)) return false;
  ++num_factored_;
  return true;
}

bool AmgSystemSolver::SolveByMultigrid(const SparseMatrix& lower, const Eigen::VectorXd& right_side,
                                       double tolerance, Eigen::VectorXd* x,
                                       SolveSummary* summary) {
  if (near_diagonal_.size() > 0) return SolveNear(lower, right_side, tolerance, x, summary);
  // What was eliminated is solved exactly, so the residual is that of the rest.
  const bool reduced = Eliminate(lower, tolerance * right_side.norm(), summary);
  if (reduced) *x = elimination_->Solve(right_side);
  return (reduced && reduced_->converged() && x->allFinite()) || Fail();
}

void AmgSystemSolver::PrepareForSystemsNear(const SparseMatrix& lower, SolveSummary* summary) {
  if (Eliminate(lower, 0, summary)) near_diagonal_ = Diagonal(lower);
}

bool AmgSystemSolver::Eliminate(const SparseMatrix& lower, double target, SolveSummary* summary) {
  reduced_->Prepare(target, summary);
  const int analyses = elimination_->symbolic_analyses();
  const bool done = elimination_->Factorize(lower);
  summary->symbolic_analyses += elimination_->symbolic_analyses() - analyses;
  return done;
}

bool AmgSystemSolver::SolveNear(const SparseMatrix& lower, const Eigen::VectorXd& right_side,
                                double tolerance, Eigen::VectorXd* x, SolveSummary* summary) {
  PatchSmoother smoother(lower, near_diagonal_);
  bool cycled = true;
  const auto solve = [&](const Eigen::VectorXd& b, Eigen::VectorXd* of_b) {
    reduced_->Prepare(kInnerTolerance * b.norm(), summary);
    elimination_->Solve(b, of_b);
    cycled = cycled && reduced_->converged();
  };
  const CgResult cg = ConjugateGradients(lower, right_side, smoother.Around(solve), tolerance,
                                         max_cg_iterations_, x);
  return (cycled && cg.converged && x->allFinite()) || Fail();
}

bool AmgSystemSolver::Fail() {
  reason_ = reduced_->error().empty() ? "multigrid did not converge" : reduced_->error();
  return false;
}

std::string AmgSystemSolver::Remark() const {
  if (num_factored_ == 0) return "";
  return fmt::format("{} of {} systems factored: {}", num_factored_, num_systems_, reason_);
}

}  // namespace cirque
