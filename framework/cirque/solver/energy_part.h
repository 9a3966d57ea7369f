#pragma once

#include <memory>
#include <optional>
#include <vector>

#include <Eigen/Core>

#include "cirque/core/solve_summary.h"
#include "cirque/energy/energy_parts.h"
#include "cirque/linear/rank_solver.h"

namespace cirque {

/// What the first rank gives to a task of an EnergyPart, and gets.
struct EnergyCall {
  const EnergySource* source = nullptr;  ///< of kTake
  AmgOptions options;                    ///< likewise
  const double* x = nullptr;             ///< all parameters: where to evaluate, or a right side
  double* result = nullptr;              ///< all parameters: a gradient, or a solution
  double damping = 0, tolerance = 0;     ///< of kPrepare and kSolve
  double number = 0;                     ///< what kShare and kLinearize come to
  bool done = false;                     ///< on all ranks
  SolveSummary* summary = nullptr;       ///< counts linear algebra
};

/// The part of an energy on a rank: evaluates it, assembles the Hessian's rows of the rank's own
/// parameters, and solves with them (RankSolver). The first rank alone has vectors of all parameters.
class EnergyPart : public RankWork {
 public:
  enum Task : int {
    kTake,             ///< all take their parts of the source
    kGradient,         ///< at x
    kShare,            ///< the value at x
    kLinearize,        ///< rows of the Hessian at x; the mean diagonal entry
    kLinearizeSmooth,  ///< rows of the smooth Hessian (Energy), where there is one
    kPrepare,          ///< for systems near those rows, damped
    kSolve,            ///< with them, damped, for the right side x
    kNumTasks
  };

  EnergyPart(Ranks* ranks, EnergyPartMaker make) : ranks_(*ranks), make_(std::move(make)) {}

  void Do(int task) override;

  EnergyCall call;  ///< of the first rank

 protected:
  const Triangulation& triangulation() const { return part_.triangulation; }
  const EnergyData& data() const { return data_; }
  const Energy& energy() const { return *energy_; }
  Ranks& ranks() const { return ranks_; }
  RankSolver& solver() { return *solver_; }
  const std::vector<bool>& is_own() const { return is_own_; }

  /// The matrix whose lower triangle, of the whole part, this is. Not collective.
  void SetMatrix(const SparseMatrix& lower);

  /// Values of the own parameters from those of the part, and back with the others' from the ranks
  /// that own them.
  Eigen::VectorXd OwnOf(const Eigen::VectorXd& of_part) const;
  Eigen::VectorXd WithOthers(const Eigen::VectorXd& own) const;

  /// Values of the own parameters to the first rank's call.result.
  void Gather(const Eigen::VectorXd& own);

  /// Where linear algebra is counted.
  SolveSummary* Summary() { return call.summary ? call.summary : &unread_; }

  /// What the first rank says.
  template <class T>
  T Told(T value) {
    ranks_.Broadcast(&value, sizeof(T));
    return value;
  }

 private:
  void Take();
  void HandOut();
  void Keep(MeshPart part, EnergyData data, std::vector<int> gauge);
  void ListUnknowns();
  void MakeSolver();

  /// The first rank's call.x at the part's parameters.
  Eigen::VectorXd Scatter();
  void Evaluate(int task);
  void Prepare();
  void Solve();
  Ranks& ranks_;
  const EnergyPartMaker make_;
  MeshPart part_;
  EnergyData data_;
  std::unique_ptr<Energy> energy_;
  std::vector<int> gauge_;      ///< own unknowns
  std::vector<int> slot_;       ///< per parameter of the part: its local number in the halo
  std::vector<bool> is_own_;    ///< likewise
  std::vector<int> parameter_;  ///< per own unknown: its parameter of the part
  std::optional<Halo> halo_;
  std::optional<RankSolver> solver_;
  std::vector<std::vector<int>> of_part_, own_;  ///< on the first rank: those of every rank
  SolveSummary unread_;
};

}  // namespace cirque
