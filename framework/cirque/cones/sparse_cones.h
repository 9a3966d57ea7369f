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
/// through the dual, a quadratic program in a box: with phi the multiplier of the equation,
/// u = -A^-1 L phi and
///   minimise 1/2 phi' L A^-1 L phi - K . phi   over   |phi_v| <= lambda.
/// The optimal mu = K - L A^-1 L phi lives where |phi| = lambda, on few vertices. Among these the
/// cones are chosen (ChooseByDescent), with curvatures of least distortion.
///
/// Guarantees: mu is optimal to the tolerance of SolveBoxProgram. Without a given lambda, lambda is
/// lowered by quarters until mu lives on at least twice as many vertices as there may be cones.
class L1Cones final : public BudgetedHeuristic {
 public:
  explicit L1Cones(const L1Options& options) : BudgetedHeuristic(options), options_(options) {}

 protected:
  StatusOr<std::vector<Cone>> ChooseAtMost(const ConeProblem& problem, int count) const override;

 private:
  L1Options options_;
};

/// The dual program, over the problem's candidates.
BoxProgram L1Dual(const ConeProblem& problem, double lambda);

/// mu of its solution, V.
Eigen::VectorXd L1Curvature(const ConeProblem& problem, const BoxSolution& solution);

struct ReweightedOptions : ConeBudget {
  int max_iterations = 40;  ///< reweightings, a factorisation each
};

const OptionTable<ReweightedOptions>& ReweightedOptionTable();

/// Sparse cones by iteratively reweighted least squares, after Q. Fang et al., "Computing sparse
/// cones with bounded distortion for conformal parameterizations", 2021 (who reweight an l1 norm
/// and split operators): instead of the total curvature, a surrogate of the *number* of cones,
///   1/2 sum_v a_v u_v^2 + beta/2 sum_v log(mu_v^2 + epsilon^2),   mu = L u + K,
/// is lowered by minimising
///   1/2 sum_v a_v u_v^2 + beta/2 sum_v w_v mu_v^2,   w_v = 1 / (mu_v^2 + epsilon^2) of the last mu,
/// again and again while epsilon falls to a thousandth of a radian and beta grows until no more
/// clusters are left than the budget has cones. Among what is left the cones are chosen
/// (ChooseByDescent), with curvatures of least distortion. With a target: the fewest cones found
/// whose predicted |u| stays below it.
///
/// Guarantees: every iteration lowers the surrogate of its beta and epsilon; a local method.
class ReweightedCones final : public BudgetedHeuristic {
 public:
  explicit ReweightedCones(const ReweightedOptions& options)
      : BudgetedHeuristic(options), options_(options) {}

 protected:
  StatusOr<std::vector<Cone>> ChooseAtMost(const ConeProblem& problem, int count) const override;

 private:
  ReweightedOptions options_;
};

}  // namespace cirque
