#include "cirque/solver/newton_loop.h"

#include "cirque/solver/kinked_line_search.h"
#include "cirque/solver/line_search.h"

namespace cirque {
namespace {

void Search(const Eigen::VectorXd& x, const Eigen::VectorXd& gradient,
            const Eigen::VectorXd& direction, SolveRun* run, LineSearchResult* step) {
  return run->kinks().empty() ? SearchAlong(x, gradient, direction, run, step)
                              : SearchAlongKinks(run->kinks(), x, gradient, direction, run, step);
}

}  // namespace

void IterateNewton(const DirectionFinder& find_direction, SolveRun* run, Eigen::VectorXd* x) {
  HessianShift shift(run->energy());
  Eigen::VectorXd gradient, direction;
  LineSearchResult step;
  if (!run->Begin(*x, &gradient)) return;
  while (run->Continue(gradient)) {
    if (run->StoppedAtRounding(gradient)) return;
    if (!find_direction(*x, gradient, &shift, &direction)) {
      run->End(Termination::kStalled, "the Hessian could not be made positive definite");
      return;
    }
    Search(*x, gradient, direction, run, &step);
    if (!step.found) {
      if (shift.Raise()) continue;
      run->End(Termination::kStalled, "no step along the Newton direction improves x");
      return;
    }
    shift.Adapt(step.step_length);
    x->swap(step.x);
    gradient.swap(step.gradient);
    run->Relax(x, &gradient);
    if (!run->Accept(*x, gradient, step.step_length)) return;
  }
}

}  // namespace cirque
