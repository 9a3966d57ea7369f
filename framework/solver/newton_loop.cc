#include "cirque/solver/newton_loop.h"

#include <utility>

#include "cirque/solver/kinked_line_search.h"
#include "cirque/solver/line_search.h"

namespace cirque {
namespace {

LineSearchResult Search(const Eigen::VectorXd& x, const Eigen::VectorXd& gradient,
                        const Eigen::VectorXd& direction, SolveRun* run) {
  return run->kinks().empty() ? SearchAlong(x, gradient, direction, run)
                              : SearchAlongKinks(run->kinks(), x, gradient, direction, run);
}

}  // namespace

void IterateNewton(const DirectionFinder& find_direction, SolveRun* run, Eigen::VectorXd* x) {
  HessianShift shift(run->energy());
  Eigen::VectorXd gradient, direction;
  if (!run->Begin(*x, &gradient)) return;
  while (run->Continue(gradient)) {
    if (run->StoppedAtRounding(gradient)) return;
    if (!find_direction(*x, gradient, &shift, &direction)) {
      run->End(Termination::kStalled, "the Hessian could not be made positive definite");
      return;
    }
    LineSearchResult step = Search(*x, gradient, direction, run);
    if (!step.found) {
      if (shift.Raise()) continue;
      run->End(Termination::kStalled, "no step along the Newton direction improves x");
      return;
    }
    shift.Adapt(step.step_length);
    *x = std::move(step.x);
    gradient = std::move(step.gradient);
    run->Relax(x, &gradient);
    if (!run->Accept(*x, gradient, step.step_length)) return;
  }
}

}  // namespace cirque
