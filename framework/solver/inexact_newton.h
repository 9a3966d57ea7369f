#pragma once

#include "cirque/solver/solve_run.h"
#include "cirque/solver/system_solver.h"

namespace cirque {

/// Newton's method whose linear systems `solver` solves as tightly as superlinear convergence needs
/// (Eisenstat & Walker 1996, choice 2): relative residual min(forcing, |g| / |g_before| squared).
void IterateInexactNewton(double forcing, SystemSolver* solver, SolveRun* run, Eigen::VectorXd* x);

}  // namespace cirque
