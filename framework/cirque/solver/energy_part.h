#pragma once

#include <memory>
#include <optional>
#include <vector>

#include <Eigen/Core>

#include "cirque/core/solve_summary.h"
#include "cirque/energy/energy_parts.h"
#include "cirque/linear/rank_solver.h"
#include "cirque/solver/inexact_newton.h"

namespace cirque {

/// What the first rank gives to a task of an EnergyPart, and gets.
struct EnergyCall {
  const EnergySource* source = nullptr;   ///< of kTake
  AmgOptions options;                     ///< likewise
  InexactNewtonOptions newton;            ///< of NewtonPart::kMinimize
  const SolveControl* control = nullptr;  ///< likewise
  const double* x = nullptr;              ///< all parameters: where to evaluate, or to start
  double* result = nullptr;               ///< all parameters: a gradient, or the minimum
  double tolerance = 0;                   ///< of tasks beyond these
  double number = 0;                      ///< what kShare comes to
  bool done = false;                      ///< on all ranks
  SolveSummary* summary = nullptr;        ///< what the task did
};

/// The part of an energy on a rank: evaluates it, assembles the Hessian's rows of the rank's own
/// parameters, and solves with them (RankSolver). Vectors are those of the own parameters; what the
/// first rank gives and gets is all. Every function is collective unless it says otherwise.
class EnergyPart : public RankWork {
 public:
  enum Task : int {
    kTake,      ///< all take their parts of the source
    kGradient,  ///< at x
    kShare,     ///< the value at x
    kNumTasks
  };

  EnergyPart(Ranks* ranks, EnergyPartMaker make) : ranks_(*ranks), make_(std::move(make)) {}

  void Do(int task) override;

  EnergyCall call;  ///< of the first rank

  Ranks& ranks() const { return ranks_; }
  int num_own() const { return static_cast<int>(parameter_.size()); }  ///< not collective
  int NumOfAll() const { return part_.first.back(); }                  ///< likewise
  double LeastDamping() const { return energy_->LeastDamping(); }      ///< likewise

  /// False outside the domain.
  bool Value(const Eigen::VectorXd& x, double* value);
  bool Gradient(const Eigen::VectorXd& x, Eigen::VectorXd* gradient);

  /// Energy::Relax of every rank by itself: the others' parameters stay as they are meanwhile.
  bool Relax(double threshold, Eigen::VectorXd* x, Eigen::VectorXd* gradient);

  /// Makes the Hessian at x the matrix of the systems to come; its mean diagonal entry. False
  /// outside the domain.
  bool Linearize(const Eigen::VectorXd& x, double* mean_diagonal);

  /// The same with the smooth Hessian; false where there is none.
  bool LinearizeSmooth(const Eigen::VectorXd& x, double* mean_diagonal);

  /// Says that the systems to come are near the matrix with this damping (RankSolver).
  bool PrepareForSystemsNear(double damping, SolveSummary* summary);

  /// Solves with the matrix and this damping. False where multigrid does not converge.
  bool Solve(double damping, const Eigen::VectorXd& right_side, double tolerance,
             Eigen::VectorXd* x, SolveSummary* summary);

  /// The own entries of what the first rank has of all, and back.
  Eigen::VectorXd Scatter(const double* all) const;
  void Gather(const Eigen::VectorXd& own, double* all) const;

 protected:
  const Triangulation& triangulation() const { return part_.triangulation; }
  const EnergyData& data() const { return data_; }
  const Energy& energy() const { return *energy_; }
  RankSolver& solver() { return *solver_; }
  const std::vector<bool>& is_own() const { return is_own_; }

  /// The matrix whose lower triangle, of the whole part, this is. Not collective.
  void SetMatrix(const SparseMatrix& lower);

  /// Values of the own parameters from those of the part (not collective), and back with the others'
  /// from the ranks that own them.
  Eigen::VectorXd OwnOf(const Eigen::VectorXd& of_part) const;
  Eigen::VectorXd WithOthers(const Eigen::VectorXd& own) const;

  /// Where linear algebra is counted. Not collective.
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

  using MatrixForm = bool (Energy::*)(const double* x, SparseMatrix* lower) const;
  bool SetMatrixTo(MatrixForm form, const Eigen::VectorXd& x, double* mean_diagonal);

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
  std::vector<std::vector<int>> own_;  ///< on the first rank: the parameters of every rank
  SolveSummary unread_;
};

}  // namespace cirque
