#include "cirque/solver/newton_on_ranks.h"

#include <utility>

#include <fmt/format.h>

namespace cirque {
namespace {

/// Vectors of which every rank has the entries of its own parameters.
class SharedSpace final : public ParameterSpace {
 public:
  explicit SharedSpace(EnergyPart* part) : part_(*part), ranks_(part->ranks()) {}

  double Dot(const Eigen::VectorXd& a, const Eigen::VectorXd& b) const override {
    return ranks_.Sum(a.dot(b));
  }
  double LargestEntry(const Eigen::VectorXd& a) const override {
    return ranks_.Largest(a.lpNorm<Eigen::Infinity>());
  }
  bool All(bool mine) const override { return ranks_.All(mine); }
  bool FirstSays(bool mine) const override {
    ranks_.Broadcast(&mine, sizeof(mine));
    return mine;
  }
  const Eigen::VectorXd& Whole(const Eigen::VectorXd& x, Eigen::VectorXd* room) const override {
    if (ranks_.rank() == 0) room->resize(part_.NumOfAll());
    part_.Gather(x, room->data());
    return *room;
  }

 private:
  EnergyPart& part_;
  Ranks& ranks_;
};

/// The energy as a function of a rank's own parameters.
class EnergyOfRank final : public Energy {
 public:
  explicit EnergyOfRank(EnergyPart* part) : part_(*part), space_(part) {}

  int NumParameters() const override { return part_.num_own(); }
  bool Evaluate(const double* x, double* value, double* gradient) const override {
    if (!part_.Value(Own(x), value)) return false;
    return gradient ? Gradient(x, gradient) : true;
  }
  bool Gradient(const double* x, double* gradient) const override {
    Eigen::VectorXd own;
    const bool done = part_.Gradient(Own(x), &own);
    Eigen::Map<Eigen::VectorXd>(gradient, own.size()) = own;
    return done;
  }
  bool Relax(double threshold, double* x, double* gradient) const override {
    Eigen::VectorXd moved = Own(x), changed = Own(gradient);
    if (!part_.Relax(threshold, &moved, &changed)) return false;
    Eigen::Map<Eigen::VectorXd>(x, moved.size()) = moved;
    Eigen::Map<Eigen::VectorXd>(gradient, changed.size()) = changed;
    return true;
  }
  double LeastDamping() const override { return part_.LeastDamping(); }
  const ParameterSpace& space() const override { return space_; }

  /// No rank has it whole: false.
  bool Hessian(const double*, SparseMatrix*) const override { return false; }

 private:
  Eigen::VectorXd Own(const double* x) const {
    return Eigen::Map<const Eigen::VectorXd>(x, NumParameters());
  }

  EnergyPart& part_;
  const SharedSpace space_;
};

/// Newton's systems, of which every rank has its own rows.
class SharedSystems final : public NewtonSystems {
 public:
  SharedSystems(EnergyPart* part, SolveRun* run) : part_(*part), run_(*run) {}

  /// One hierarchy for all, that of the smooth Hessian, where there is one.
  void Prepare(const Eigen::VectorXd& x) {
    double mean_diagonal = 0;
    if (!part_.LinearizeSmooth(x, &mean_diagonal)) return;
    part_.PrepareForSystemsNear(part_.LeastDamping(), &run_.summary());
  }

  bool Linearize(const Eigen::VectorXd& x, LevenbergMarquardtDamping* damping) override {
    const Timer timer;
    double mean_diagonal = 0;
    const bool defined = part_.Linearize(x, &mean_diagonal);
    damping->SetScale(mean_diagonal);
    damping_ = damping->damping();
    ++run_.summary().hessian_evaluations;
    run_.summary().evaluation_seconds += timer.Seconds();
    return defined;
  }
  bool Raise(LevenbergMarquardtDamping* damping) override {
    // Where multigrid does not converge others do it, with the energy as a whole.
    const bool raised = !failed_ && damping->Raise();
    damping_ = damping->damping();
    return raised;
  }
  bool Solve(const Eigen::VectorXd& right_side, const SolveAccuracy& accuracy,
             Eigen::VectorXd* direction) override {
    failed_ = !part_.Solve(damping_, right_side, accuracy.tolerance, direction, &run_.summary());
    return !failed_;
  }

  bool failed() const { return failed_; }

 private:
  EnergyPart& part_;
  SolveRun& run_;
  double damping_ = 0;
  bool failed_ = false;
};

}  // namespace

SolveSummary MinimizeOnRanks(const InexactNewtonOptions& options, const SolveControl& control,
                             EnergyPart* part, Eigen::VectorXd* x, bool* failed) {
  const EnergyOfRank energy(part);
  SolveRun run(fmt::format("newton_amg on {} ranks", part->ranks().num_ranks()), options, control,
               energy);
  SharedSystems systems(part, &run);
  systems.Prepare(*x);
  IterateInexactNewton(options.forcing, &systems, &run, x);
  *failed = systems.failed();
  return run.Finish(*x);
}

void NewtonPart::Do(int task) { return task == kMinimize ? Minimize() : EnergyPart::Do(task); }

void NewtonPart::Minimize() {
  static const SolveControl kOfOthers;
  const bool first = ranks().rank() == 0;
  Eigen::VectorXd x = Scatter(call.x);
  bool failed = false;
  SolveSummary summary =
      MinimizeOnRanks(Told(call.newton), first ? *call.control : kOfOthers, this, &x, &failed);
  Gather(x, call.result);
  call.done = !failed;
  if (first) *call.summary = std::move(summary);
}

}  // namespace cirque
