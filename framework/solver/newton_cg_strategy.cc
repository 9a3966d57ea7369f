#include "cirque/solver/newton_cg_strategy.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

#include "cirque/solver/conjugate_gradients.h"
#include "cirque/solver/newton_loop.h"
#include "cirque/solver/sparse_cholesky.h"

namespace cirque {
namespace {

constexpr int kMaxAttempts = 12;
constexpr double kLeastForcing = 1e-10;

/// Solves with the factor at hand and factors anew when that takes too many iterations.
class PreconditionedDirection {
 public:
  PreconditionedDirection(const NewtonCgOptions& options, SolveRun* run, SparseCholesky* cholesky)
      : options_(options), run_(run), cholesky_(cholesky) {}

  bool operator()(const Eigen::VectorXd& x, const Eigen::VectorXd& gradient, HessianShift* shift,
                  Eigen::VectorXd* direction) {
    if (!run_->Hessian(x, &hessian_)) return false;
    const double tolerance = Forcing(gradient.norm());
    for (int attempt = 0; attempt < kMaxAttempts; ++attempt) {
      const SparseMatrix& regularized = shift->Apply(hessian_);
      if (Solve(regularized, gradient, tolerance, direction)) return true;
      factored_ = run_->Factorize(regularized, cholesky_);
      // With its own factor a step may fall short of the tolerance by rounding only.
      if (factored_) {
        Solve(regularized, gradient, tolerance, direction);
        if (IsDescent(*direction, gradient)) return true;
      }
      if (!shift->Raise()) return false;
    }
    return false;
  }

 private:
  /// How tightly to solve at this gradient norm.
  double Forcing(double norm) {
    const double ratio = norm / last_norm_;
    last_norm_ = norm;
    return std::clamp(ratio * ratio, kLeastForcing, options_.forcing);
  }

  static bool IsDescent(const Eigen::VectorXd& direction, const Eigen::VectorXd& gradient) {
    return direction.allFinite() && direction.dot(gradient) < 0;
  }

  /// Solves to the tolerance with the factor at hand, if there is one.
  bool Solve(const SparseMatrix& matrix, const Eigen::VectorXd& gradient, double tolerance,
             Eigen::VectorXd* direction) {
    if (!factored_) return false;
    const CgResult cg = ConjugateGradients(
        matrix, -gradient, [this](const Eigen::VectorXd& b) { return run_->Solve(b, cholesky_); },
        tolerance, options_.max_cg_iterations, direction);
    run_->summary().cg_iterations += cg.iterations;
    return cg.converged && IsDescent(*direction, gradient);
  }

  const NewtonCgOptions& options_;
  SolveRun* run_;
  SparseCholesky* cholesky_;
  SparseMatrix hessian_;
  bool factored_ = false;
  double last_norm_ = std::numeric_limits<double>::infinity();
};

}  // namespace

const OptionTable<NewtonCgOptions>& NewtonCgOptionTable() {
  static const OptionTable<NewtonCgOptions> kTable("newton_cg", [] {
    auto fields = LimitFields<NewtonCgOptions>();
    fields.push_back({"linear_solver", &NewtonCgOptions::linear_solver, 0, 0,
                      LinearSolvers().Names(), "sparse Cholesky; default: the first"});
    fields.push_back({"max_cg_iterations",
                      &NewtonCgOptions::max_cg_iterations,
                      1,
                      1e6,
                      {},
                      "conjugate gradient iterations a step before factoring anew"});
    fields.push_back({"forcing",
                      &NewtonCgOptions::forcing,
                      1e-10,
                      0.9,
                      {},
                      "relative residual of the first steps' linear systems"});
    return fields;
  }());
  return kTable;
}

SolveSummary NewtonCgStrategy::Minimize(const Energy& energy, const SolveControl& control,
                                        Eigen::VectorXd* x) const {
  SolveRun run("newton_cg", options_, control, energy);
  const auto cholesky = MakeCholesky(options_.linear_solver);
  PreconditionedDirection direction(options_, &run, cholesky.get());
  IterateNewton(std::ref(direction), &run, x);
  return run.Finish(*x);
}

}  // namespace cirque
