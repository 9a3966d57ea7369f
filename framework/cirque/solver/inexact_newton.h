#pragma once

#include <string>
#include <vector>

#include "cirque/core/option_table.h"
#include "cirque/linear/system_solver.h"
#include "cirque/solver/solve_run.h"

namespace cirque {

/// The rows of an option table for what every strategy on IterateInexactNewton has.
template <class T>
std::vector<typename OptionTable<T>::Field> InexactNewtonFields(const std::string& cg_limit_help) {
  return {{"max_cg_iterations", &T::max_cg_iterations, 1, 1e6, {}, cg_limit_help},
          {"forcing",
           &T::forcing,
           1e-10,
           0.9,
           {},
           "relative residual of the first steps' linear systems"}};
}

/// Newton's method whose linear systems `solver` solves as tightly as superlinear convergence needs
/// (Eisenstat & Walker 1996, choice 2): relative residual min(forcing, |g| / |g_before| squared),
/// but `forcing` in the first step, and where that allows not below 1e-4 or what the solve's
/// gradient tolerance asks for.
void IterateInexactNewton(double forcing, SystemSolver* solver, SolveRun* run, Eigen::VectorXd* x);

}  // namespace cirque
