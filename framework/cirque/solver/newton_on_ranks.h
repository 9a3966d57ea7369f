#pragma once

#include "cirque/solver/energy_part.h"
#include "cirque/solver/inexact_newton.h"

namespace cirque {

/// IterateInexactNewton on all ranks at once, of which each has the vectors of its own parameters
/// and this part of the energy: from the own entries *x to those of the minimum. Collective: all
/// take the same steps. What `control` asks is the first's to say; its callback gets all parameters.
/// *failed: whether the last system was one that multigrid did not solve.
SolveSummary MinimizeOnRanks(const InexactNewtonOptions& options, const SolveControl& control,
                             EnergyPart* part, Eigen::VectorXd* x, bool* failed);

/// A part that finds its share of the energy's minimum.
class NewtonPart : public EnergyPart {
 public:
  using EnergyPart::EnergyPart;

  /// The task of MinimizeOnRanks, from call.x to call.result; not done where that failed.
  static constexpr int kMinimize = EnergyPart::kNumTasks;
  static constexpr int kNumTasks = kMinimize + 1;

  void Do(int task) override;

 private:
  void Minimize();
};

}  // namespace cirque
