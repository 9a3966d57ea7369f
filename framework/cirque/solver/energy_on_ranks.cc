#include "cirque/solver/energy_on_ranks.h"

#include <utility>

namespace cirque {

std::unique_ptr<EnergyOnRanks> EnergyOnRanks::Make(const EnergySource& source,
                                                   const AmgOptions& options) {
  MultigridLibrary* library = RanksAtService();
  if (!library) return nullptr;
  auto work = std::make_unique<SharedWork<EnergyPart>>(library, source.Work());
  if (!work->IsKnown()) return nullptr;
  const std::string method = MethodOf(options, *library);
  return std::unique_ptr<EnergyOnRanks>(
      new EnergyOnRanks(*library, source, std::move(work), {method, options.max_cg_iterations}));
}

EnergyOnRanks::EnergyOnRanks(const MultigridLibrary& library, const EnergySource& source,
                             std::unique_ptr<SharedWork<EnergyPart>> work,
                             const AmgOptions& options)
    : library_(library), source_(source), work_(std::move(work)) {
  call().source = &source;
  call().options = options;
  work_->Do(EnergyPart::kTake);
}

bool EnergyOnRanks::Do(int task) const {
  call().done = false;
  work_->Do(task);
  call().summary = nullptr;
  return call().done;
}

bool EnergyOnRanks::Gradient(const double* x, double* gradient) const {
  call().x = x;
  call().result = gradient;
  return Do(EnergyPart::kGradient);
}

bool EnergyOnRanks::Evaluate(const double* x, double* value, double* gradient) const {
  call().x = x;
  if (!Do(EnergyPart::kShare)) return false;
  *value = call().number;
  return gradient ? Gradient(x, gradient) : true;
}

bool EnergyOnRanks::Linearize(const double* x, double* mean_diagonal) const {
  call().x = x;
  const bool done = Do(EnergyPart::kLinearize);
  *mean_diagonal = call().number;
  return done;
}

bool EnergyOnRanks::LinearizeSmooth(const double* x, double* mean_diagonal) const {
  call().x = x;
  const bool done = Do(EnergyPart::kLinearizeSmooth);
  *mean_diagonal = call().number;
  return done;
}

bool EnergyOnRanks::PrepareForSystemsNear(double damping, SolveSummary* summary) const {
  call().damping = damping;
  call().summary = summary;
  return Do(EnergyPart::kPrepare);
}

bool EnergyOnRanks::Solve(double damping, const Eigen::VectorXd& right_side, double tolerance,
                          Eigen::VectorXd* x, SolveSummary* summary) const {
  x->resize(right_side.size());
  call().damping = damping;
  call().tolerance = tolerance;
  call().x = right_side.data();
  call().result = x->data();
  call().summary = summary;
  failed_ = !Do(EnergyPart::kSolve);
  return !failed_;
}

}  // namespace cirque
