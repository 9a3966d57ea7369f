#pragma once

#include <memory>
#include <vector>

#include "cirque/energy/energy.h"
#include "cirque/linear/multigrid.h"
#include "cirque/solver/energy_part.h"

namespace cirque {

/// An energy that all ranks have parts of, as the first sees it: value, gradient and the solution of
/// Newton's systems, whose matrices no rank has whole. An error on one rank ends all.
class EnergyOnRanks final : public Energy {
 public:
  /// All ranks take their parts; `source` must outlive the energy. Null where there are no other
  /// ranks, or the program's do not know this energy.
  static std::unique_ptr<EnergyOnRanks> Make(const EnergySource& source, const AmgOptions& options);

  int NumParameters() const override { return source_.NumParameters(); }
  bool Evaluate(const double* x, double* value, double* gradient) const override;
  bool Gradient(const double* x, double* gradient) const override;
  std::vector<int> GaugeParameters() const override { return source_.GaugeParameters(); }
  double LeastDamping() const override { return source_.LeastDamping(); }
  bool Relax(double share, double* x, double* gradient) const override {
    return source_.Relax(share, x, gradient);
  }

  /// No rank has it whole: false.
  bool Hessian(const double*, SparseMatrix*) const override { return false; }

  /// Makes the Hessian at x the matrix of the systems to come; its mean diagonal entry. False
  /// outside the domain.
  bool Linearize(const double* x, double* mean_diagonal) const;

  /// The same with the smooth Hessian; false where there is none.
  bool LinearizeSmooth(const double* x, double* mean_diagonal) const;

  /// Says that the systems to come are near the matrix with this damping (RankSolver).
  bool PrepareForSystemsNear(double damping, SolveSummary* summary) const;

  /// Solves with the matrix and this damping. False where multigrid does not converge.
  bool Solve(double damping, const Eigen::VectorXd& right_side, double tolerance,
             Eigen::VectorXd* x, SolveSummary* summary) const;

  int num_ranks() const { return library_.num_ranks(); }

  /// Whether the last system was one that multigrid did not solve.
  bool failed() const { return failed_; }

  /// For tasks of a part's own.
  SharedWork<EnergyPart>& work() const { return *work_; }

 private:
  EnergyOnRanks(const MultigridLibrary& library, const EnergySource& source,
                std::unique_ptr<SharedWork<EnergyPart>> work, const AmgOptions& options);

  /// Does a task; false where it is not done on all ranks.
  bool Do(int task) const;
  EnergyCall& call() const { return work_->part().call; }

  const MultigridLibrary& library_;
  const EnergySource& source_;
  const std::unique_ptr<SharedWork<EnergyPart>> work_;
  mutable bool failed_ = false;
};

}  // namespace cirque
