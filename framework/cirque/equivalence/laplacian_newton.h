#pragma once

#include <vector>

#include <Eigen/Core>

#include "cirque/core/solve_summary.h"
#include "cirque/energy/energy.h"
#include "cirque/solver/solver_strategy.h"

namespace cirque {

/// Solves L x = b for a matrix whose entries off the diagonal are not positive and whose rows do not
/// sum to less than 0, a graph's Laplacian with or without vertices that are held. Eliminated without
/// a subtraction, each weight keeps its digits however far weights range, where a Cholesky factor has
/// light ones only as differences of heavy ones. (W. Grassmann, M. Taksar, D. Heyman, "Regenerative
/// analysis and steady state distributions for Markov chains", Oper. Res. 33, 1985; C. O'Cinneide,
/// "Relative-error bounds for the LU decomposition via the GTH algorithm", Numer. Math. 73, 1996.)
///
/// `weight`: symmetric, n x n, >= 0, minus L off the diagonal, which is not read; `held`: n, >= 0, the
/// sums of L's rows. Parts of the graph that nothing holds get their first unknown 0: there b has to
/// sum to 0. What b comes to of vertices joined by heavy weights is taken for 0 where it is no more than
/// `rounding`, that of b: it would move them together, and in the spacing of doubles at that move the
/// much smaller ones of each against the other would be lost. Cost: n^3 / 3.
Eigen::VectorXd SolveLaplacian(Eigen::MatrixXd weight, Eigen::VectorXd held, Eigen::VectorXd b,
                               double rounding = 0);

/// Newton's method with SolveLaplacian for an energy whose Hessian is such a matrix, as that of
/// ConformalEquivalenceEnergy is where the metric is Delaunay: for needles, whose weights range over more
/// than a double's digits, and where scales are as large as a hundred: E is all but linear then between
/// narrow creases, and steps go down to one of them each (SearchToRest), where less exact ones leap to
/// and fro across. For few unknowns (kMostLaplacianUnknowns): the matrix is dense.
SolveSummary MinimizeByLaplacians(const Energy& energy, const SolverLimits& limits,
                                  const SolveControl& control, Eigen::VectorXd* x);

inline constexpr int kMostLaplacianUnknowns = 600;

}  // namespace cirque
