#pragma once

#include "cirque/cones/cone_heuristic.h"

namespace cirque {

struct ReweightedOptions : ConeBudget {
  int max_iterations = 40;  ///< reweightings, a factorisation each
};

const OptionTable<ReweightedOptions>& ReweightedOptionTable();

/// Sparse cones by iteratively reweighted least squares, after Q. Fang et al., "Computing sparse
/// cones with bounded distortion for conformal parameterizations", 2021 (who reweight an l1 norm
/// and split operators): instead of the total curvature, a surrogate of the *number* of cones,
///   1/2 sum_v a_v u_v^2 + beta/2 sum_v log(mu_v^2 + epsilon^2),   mu = L u + K,
/// is lowered by minimising 1/2 u' A u + beta/2 sum_v w_v mu_v^2, w_v = 1 / (mu_v^2 + epsilon^2),
/// again and again while epsilon falls to a thousandth of a radian and beta grows until no more
/// clusters are left than the budget has cones. Among what is left the cones are chosen
/// (PlaceByDescent), with curvatures of least distortion. With a target: the fewest cones found
/// whose predicted |u| stays below it.
///
/// Guarantees: every iteration lowers the surrogate of its beta and epsilon; a local method.
class ReweightedCones final : public BudgetedHeuristic {
 public:
  explicit ReweightedCones(const ReweightedOptions& options)
      : BudgetedHeuristic(options), options_(options) {}

 protected:
  StatusOr<std::vector<Cone>> PlaceAtMost(const ConeProblem& problem, int count) const override;

 private:
  ReweightedOptions options_;
};

}  // namespace cirque
