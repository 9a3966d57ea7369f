#pragma once

#include "cirque/cones/cone_heuristic.h"
#include "cirque/linear/box_program.h"

namespace cirque {

struct L1Options : ConeBudget {
  double lambda = 0;   ///< weight of the cones' total curvature; 0: sought for the budget
  int max_solves = 6;  ///< of that search
};

const OptionTable<L1Options>& L1OptionTable();

/// Optimal cones of Y. Soliman, D. Slepcev, K. Crane, "Optimal cone singularities for conformal
/// flattening", 2018: curvatures mu at any vertices that minimise
///   1/2 sum_v a_v u_v^2 + lambda sum_v |mu_v|,   L u = mu - K,
/// through the dual, a quadratic program in a box: with phi the multiplier of the equation, u =
/// -phi's Laplacian by area and
///   minimise 1/2 phi' L A^-1 L phi - K . phi   over   |phi_v| <= lambda.
/// The optimal mu = K - L A^-1 L phi lives where |phi| = lambda, on few vertices. These are
/// gathered in clusters, the greatest of which become the cones, with curvatures of least
/// distortion.
///
/// Guarantees: mu is optimal to the tolerance of SolveBoxProgram. That it lies on at most as many
/// clusters as the budget has cones depends on lambda, which is sought by bisection.
class L1Cones final : public BudgetedHeuristic {
 public:
  explicit L1Cones(const L1Options& options) : BudgetedHeuristic(options), options_(options) {}

 protected:
  StatusOr<std::vector<Cone>> PlaceAtMost(const ConeProblem& problem, int count) const override;

 private:
  L1Options options_;
};

/// The dual program, over the problem's candidates.
BoxProgram L1Dual(const ConeProblem& problem, double lambda);

/// mu of its solution, V.
Eigen::VectorXd L1Curvature(const ConeProblem& problem, const BoxSolution& solution);

}  // namespace cirque
