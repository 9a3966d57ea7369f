#include "cirque/core/solve_summary.h"

#include <fmt/format.h>

namespace cirque {
std::string ToString(Termination termination) {
  switch (termination) {
    case Termination::kNotRun:
      return "not_run";
    case Termination::kConverged:
      return "converged";
    case Termination::kStalled:
      return "stalled";
    case Termination::kIterationLimit:
      return "iteration_limit";
    case Termination::kTimeLimit:
      return "time_limit";
    case Termination::kStoppedByCaller:
      return "stopped_by_caller";
    case Termination::kCancelled:
      return "cancelled";
    case Termination::kInvalidStart:
      return "invalid_start";
    case Termination::kUnsupported:
      return "unsupported";
  }
  return "unknown";
}

std::string SolveSummary::BriefReport() const {
  return fmt::format(
      "{}: {} after {} iterations, gradient {:.2e} -> {:.2e}, {} factorizations, {:.3f} s; {}",
      strategy, ToString(termination), num_iterations(), initial_gradient_max, final_gradient_max,
      factorizations, total_seconds, message);
}

std::string SolveSummary::FullReport() const {
  std::string text = BriefReport() + "\n";
  text += fmt::format("value        {:.17g} -> {:.17g}\n", initial_value, final_value);
  text += fmt::format("evaluations  {} values, {} gradients, {} Hessians\n", value_evaluations,
                      gradient_evaluations, hessian_evaluations);
  text += fmt::format("linear       {} analyses, {} factorizations, {} solves, {} CG iterations\n",
                      symbolic_analyses, factorizations, linear_solves, cg_iterations);
  text += fmt::format(
      "seconds      {:.4f} evaluating, {:.4f} factoring, {:.4f} solving, {:.4f} in all\n",
      evaluation_seconds, factorization_seconds, solve_seconds, total_seconds);
  for (const IterationRecord& r : iterations) {
    text += fmt::format("{:4d}  value {:.12g}  gradient {:.3e}  step {:.3g}  {:.4f} s\n",
                        r.iteration, r.value, r.gradient_max, r.step_length, r.seconds);
  }
  return text;
}

}  // namespace cirque
