#pragma once

#include <memory>
#include <string>

#include "cirque/cones/cone_heuristic.h"

namespace cirque {

struct MovingOptions : ConeBudget {
  std::string start = "greedy";  ///< the heuristic that places the cones first
  int max_sweeps = 30;
};

const OptionTable<MovingOptions>& MovingOptionTable();

/// Moves the cones of another heuristic, in the spirit of M. Li, Q. Fang et al., "Efficient cone
/// singularity construction for conformal parameterizations", 2023: each in turn is tried a few
/// edges down the slope of the distortion, and where the distortion of the best curvatures is then
/// lower, stays. The slope at all vertices is one solve (ConeFit::Descent) and a trial one more,
/// all with one factor of the Laplacian: a trial exchanges a row of the small least-squares problem
/// and nothing is factored again.
///
/// Guarantees: the predicted distortion sqrt(sum a u^2) is at most that of the start with least-
/// squares curvatures; the number of cones is that of the start.
class MovingCones final : public ConeHeuristic {
 public:
  /// Error (invalid input): a start that does not take the budget's options, or is itself moving.
  static StatusOr<std::shared_ptr<const ConeHeuristic>> Make(const OptionMap& options);

  MovingCones(std::shared_ptr<const ConeHeuristic> start, int max_sweeps)
      : start_(std::move(start)), max_sweeps_(max_sweeps) {}

  StatusOr<std::vector<Cone>> Place(const ConeProblem& problem) const override;

 private:
  std::shared_ptr<const ConeHeuristic> start_;
  int max_sweeps_;
};

}  // namespace cirque
