#pragma once

#include <functional>
#include <memory>
#include <string>

#include "cirque/cones/cone_heuristic.h"
#include "cirque/cones/cone_measure.h"

namespace cirque {

struct MovingOptions : ConeBudget {
  std::string start = "greedy";  ///< the heuristic that chooses the cones first
  int max_sweeps = 30;
  ConeMeasureKind measure = ConeMeasureKind::kArea;
  int relocations = 0;
  int one_by_one = 96;  ///< the most cones
};

const OptionTable<MovingOptions>& MovingOptionTable();

/// Moves the cones of another heuristic, in the spirit of M. Li, Q. Fang et al., "Efficient cone
/// singularity construction for conformal parameterizations", 2023: each in turn is tried a few
/// edges down the slope of the distortion, and where the distortion of the best curvatures is then
/// lower, stays. The slope at all vertices is one solve (ConeFit::Descent) and a trial one more,
/// all with one factor of the Laplacian: a trial exchanges a row of the small least-squares problem
/// and nothing is factored again. Where no cone moves any more, cones that are missed least are moved
/// to where one more would help most, at most `relocations` times.
///
/// More than `one_by_one` cones are moved all at once instead (ConeSweeps), at a cost that does not
/// grow with their number, and none is relocated. The measure ends a little higher: of 20 and 60 cones
/// the predicted area distortion by 7 to 40 %, the angle distortion by 1 to 5 %, in a half to a sixth
/// of the time.
///
/// `measure`: `area`, the predicted area distortion sqrt(sum a u^2); `angle`, the predicted mean of
/// the quasi-conformal distortion (AngleMeasure), which cones of little area distortion need not
/// lower.
///
/// Guarantees: the measure is at most that of the start with the curvatures fitted to it (`angle`:
/// up to its smoothing; of cones moved all at once, at most that of the start as it is); the number of
/// cones is that of the start.
class MovingCones final : public ConeHeuristic {
 public:
  /// Makes the heuristic of a name with options, as MakeConeHeuristic does.
  using StartMaker = std::function<StatusOr<std::shared_ptr<const ConeHeuristic>>(
      const std::string& name, const OptionMap& options)>;

  /// Error (invalid input): a start that does not take the budget's options, or is itself moving.
  static StatusOr<std::shared_ptr<const ConeHeuristic>> Make(const OptionMap& options,
                                                             const StartMaker& make_start);

  MovingCones(std::shared_ptr<const ConeHeuristic> start, MovingOptions options)
      : start_(std::move(start)), options_(std::move(options)) {}

  StatusOr<std::vector<Cone>> Choose(const ConeProblem& problem) const override;

 private:
  std::shared_ptr<const ConeHeuristic> start_;
  MovingOptions options_;
};

}  // namespace cirque
