#include "cirque/solver/energy_on_ranks.h"

#include <utility>

#include "cirque/solver/newton_on_ranks.h"

namespace cirque {

std::unique_ptr<EnergyOnRanks> EnergyOnRanks::Make(const EnergySource& source,
                                                   const AmgOptions& options) {
  MultigridLibrary* library = RanksAtService();
  if (!library) return nullptr;
  auto work = std::make_unique<SharedWork<EnergyPart>>(library, source.Work());
  if (!work->IsKnown()) return nullptr;
  const std::string method = MethodOf(options, *library);
  return std::unique_ptr<EnergyOnRanks>(
      new EnergyOnRanks(source, std::move(work), {method, options.max_cg_iterations}));
}

EnergyOnRanks::EnergyOnRanks(const EnergySource& source,
                             std::unique_ptr<SharedWork<EnergyPart>> work,
                             const AmgOptions& options)
    : source_(source), work_(std::move(work)) {
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

SolveSummary EnergyOnRanks::Minimize(const InexactNewtonOptions& options,
                                     const SolveControl& control, Eigen::VectorXd* x) const {
  SolveSummary summary;
  call().newton = options;
  call().control = &control;
  call().x = x->data();
  call().result = x->data();
  call().summary = &summary;
  failed_ = !Do(NewtonPart::kMinimize);
  return summary;
}

}  // namespace cirque
