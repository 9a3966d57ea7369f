#include <functional>

#include "cirque/linear/registry.h"
#include "cirque/solver/newton_loop.h"
#include "cirque/solver/newton_strategies.h"

namespace cirque {
namespace {

constexpr int kMaxRaisesPerStep = 12;

/// Factors the regularised Hessian at every step, raising the damping until it is positive definite;
/// but a last one that the last factor does for.
class CholeskyDirection {
 public:
  CholeskyDirection(SolveRun* run, SparseCholesky* cholesky)
      : run_(run), cholesky_(cholesky), chord_(*run) {}

  bool operator()(const Eigen::VectorXd& x, const Eigen::VectorXd& gradient,
                  LevenbergMarquardtDamping* damping, Eigen::VectorXd* direction) {
    if (chord_.LastHessianDoes(gradient) && SolveByFactor(gradient, direction)) return true;
    if (!run_->Hessian(x, &hessian_)) return false;
    damping->DampHessian(&hessian_);
    for (int attempt = 0; attempt < kMaxRaisesPerStep; ++attempt) {
      if (run_->Factorize(hessian_, cholesky_) && SolveByFactor(gradient, direction)) return true;
      if (!damping->Raise(&hessian_)) return false;
    }
    return false;
  }

 private:
  bool SolveByFactor(const Eigen::VectorXd& gradient, Eigen::VectorXd* direction) {
    *direction = -run_->Solve(gradient, cholesky_);
    return direction->allFinite() && direction->dot(gradient) < 0;
  }

  SolveRun* run_;
  SparseCholesky* cholesky_;
  ChordTest chord_;
  SparseMatrix hessian_;
};

}  // namespace

const OptionTable<NewtonOptions>& NewtonOptionTable() {
  using O = NewtonOptions;
  static const OptionTable<O> kTable(
      "newton", Joined<O>(LimitOptions<O>(), {Option<O>("linear_solver", &O::linear_solver,
                                                        "sparse Cholesky; default: the first")
                                                  .OneOf(LinearSolvers().Names())}));
  return kTable;
}

SolveSummary NewtonStrategy::Minimize(const Energy& energy, const SolveControl& control,
                                      Eigen::VectorXd* x) const {
  SolveRun run("newton", options_, control, energy);
  const auto cholesky = MakeCholesky(options_.linear_solver);
  CholeskyDirection direction(&run, cholesky.get());
  IterateNewton(std::ref(direction), &run, x);
  return run.Finish(*x);
}

}  // namespace cirque
