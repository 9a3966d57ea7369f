#include "cirque/linear/amg_system_solver.h"

#include <optional>

#include <fmt/format.h>

#include "cirque/core/solve_summary.h"
#include "cirque/linear/conjugate_gradients.h"
#include "cirque/linear/lagged_hierarchy.h"
#include "cirque/linear/patch_smoother.h"
#include "cirque/linear/registry.h"
#include "cirque/linear/sparse_matrix.h"

namespace cirque {
namespace {

constexpr int kFactorIterations = 6;
constexpr int kMostFailures = 2;

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
    converged_ = hierarchy_->Solve(b, b.norm(), target_, x, summary_);
    if (!converged_) error_ = system_->error();
  }

 protected:
  /// Another pattern leaves other unknowns.
  bool Analyze(const SparseMatrix&) override {
    if (hierarchy_) hierarchy_->Forget();
    return Load();
  }

  bool FactorizeNumerically(const SparseMatrix& lower) override {
    if (!system_) return false;
    const Timer timer;
    const bool taken = system_->SetMatrix({static_cast<int>(lower.cols()), lower.outerIndexPtr(),
                                           lower.innerIndexPtr(), lower.valuePtr()});
    summary_->factorization_seconds += timer.Seconds();
    if (!taken) error_ = system_->error();
    return taken;
  }

 private:
  bool Load() {
    if (system_) return true;
    const auto library = LoadMultigrid();
    if (!library.ok()) {
      error_ = library.status().message();
      return false;
    }
    system_ = (*library)->MakeSystem();
    hierarchy_.emplace(system_.get(), MethodOf(options_, **library), options_.max_cg_iterations);
    return true;
  }

  const AmgOptions options_;
  std::string error_;
  std::unique_ptr<WholeSystem> system_;
  std::optional<LaggedHierarchy> hierarchy_;
  SolveSummary* summary_ = nullptr;
  double target_ = 0;
  bool converged_ = false;
};

std::string MethodOf(const AmgOptions& options, const MultigridLibrary& library) {
  return options.multigrid.empty() ? library.Methods().front() : options.multigrid;
}

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
    reduced_->Prepare(kInnerMultigridTolerance * b.norm(), summary);
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
