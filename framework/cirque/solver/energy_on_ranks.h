#pragma once

#include <memory>
#include <vector>

#include "cirque/energy/energy.h"
#include "cirque/linear/multigrid.h"
#include "cirque/solver/energy_part.h"

namespace cirque {

/// An energy that all ranks have parts of, as the first sees it: value, gradient and minimum, which
/// the ranks find together. An error on one rank ends all.
class EnergyOnRanks final : public Energy {
 public:
  /// All ranks take their parts; `source` must outlive the energy. Null where there are no other
  /// ranks, or the program's do not know this energy.
  static std::unique_ptr<EnergyOnRanks> Make(const EnergySource& source, const AmgOptions& options);

  int NumParameters() const override { return source_.NumParameters(); }
  bool Evaluate(const double* x, double* value, double* gradient) const override;
  bool Gradient(const double* x, double* gradient) const override;
  std::vector<int> GaugeParameters() const override { return source_.GaugeParameters(); }

  /// No rank has it whole: false.
  bool Hessian(const double*, SparseMatrix*) const override { return false; }

  /// By MinimizeOnRanks, from all parameters *x to all.
  SolveSummary Minimize(const InexactNewtonOptions& options, const SolveControl& control,
                        Eigen::VectorXd* x) const;

  /// Whether the last system was one that multigrid did not solve.
  bool failed() const { return failed_; }

  /// For tasks of a part's own.
  SharedWork<EnergyPart>& work() const { return *work_; }

 private:
  EnergyOnRanks(const EnergySource& source, std::unique_ptr<SharedWork<EnergyPart>> work,
                const AmgOptions& options);

  /// Does a task; false where it is not done on all ranks.
  bool Do(int task) const;
  EnergyCall& call() const { return work_->part().call; }

  const EnergySource& source_;
  const std::unique_ptr<SharedWork<EnergyPart>> work_;
  mutable bool failed_ = false;
};

}  // namespace cirque
