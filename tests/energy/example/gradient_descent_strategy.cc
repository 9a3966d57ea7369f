#include "tests/energy/example/gradient_descent_strategy.h"

#include "cirque/solver/solve_run.h"

namespace cirque {

const OptionTable<GradientDescentOptions>& GradientDescentOptionTable() {
  using O = GradientDescentOptions;
  static const OptionTable<O> kTable(
      "gradient_descent",
      Joined<O>(LimitOptions<O>(),
                {Option<O>("step", &O::step, "multiple of the gradient").Between(0, 1e3)}));
  return kTable;
}

SolveSummary GradientDescentStrategy::Minimize(const Energy& energy, const SolveControl& control,
                                               Eigen::VectorXd* x) const {
  SolveRun run("gradient_descent", options_, control, energy);
  Eigen::VectorXd gradient;
  if (!run.Begin(*x, &gradient)) return run.Finish(*x);
  while (run.Continue(gradient)) {
    *x -= options_.step * gradient;
    if (!run.Gradient(*x, &gradient)) {
      run.End(Termination::kStalled, "the step left the domain");
    } else if (!run.Accept(*x, gradient, options_.step)) {
      break;
    }
  }
  return run.Finish(*x);
}

}  // namespace cirque
