#include "cirque/solver/newton_cg_strategy.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

#include "cirque/solver/newton_loop.h"
#include "cirque/solver/reused_factor.h"

namespace cirque {
namespace {

constexpr int kMaxAttempts = 12;
constexpr double kLeastForcing = 1e-10;

/// Solves with the factor at hand and factors anew when that takes too many iterations.
class PreconditionedDirection {
 public:
  PreconditionedDirection(double forcing, SolveRun* run, ReusedFactor* factor)
      : forcing_(forcing), run_(run), factor_(*factor) {}

  bool operator()(const Eigen::VectorXd& x, const Eigen::VectorXd& gradient, HessianShift* shift,
                  Eigen::VectorXd* direction) {
    if (!run_->Hessian(x, &hessian_)) return false;
    const double tolerance = Forcing(gradient.norm());
    for (int attempt = 0; attempt < kMaxAttempts; ++attempt) {
      const bool solved =
          factor_.Solve(shift->Apply(hessian_), -gradient, tolerance, direction, &run_->summary());
      if (solved && direction->dot(gradient) < 0) return true;
      if (!shift->Raise()) return false;
    }
    return false;
  }

 private:
  /// How tightly to solve at this gradient norm.
  double Forcing(double norm) {
    const double ratio = norm / last_norm_;
    last_norm_ = norm;
    return std::clamp(ratio * ratio, kLeastForcing, forcing_);
  }

  const double forcing_;
  SolveRun* run_;
  ReusedFactor& factor_;
  SparseMatrix hessian_;
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
  ReusedFactor own(MakeCholesky(options_.linear_solver), options_.max_cg_iterations);
  PreconditionedDirection direction(options_.forcing, &run, control.factor ? control.factor : &own);
  IterateNewton(std::ref(direction), &run, x);
  return run.Finish(*x);
}

}  // namespace cirque
