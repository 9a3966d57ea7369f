#pragma once

#include "cirque/cones/cone_heuristic.h"

namespace cirque {

enum class ConePick { kExtreme, kDescent };
enum class CurvatureFit { kLeastSquares, kZeroAtCones };

template <>
inline constexpr auto kEnumWords<ConePick> = std::to_array<EnumWord<ConePick>>(
    {{ConePick::kExtreme, "extreme"}, {ConePick::kDescent, "descent"}});
template <>
inline constexpr auto kEnumWords<CurvatureFit> =
    std::to_array<EnumWord<CurvatureFit>>({{CurvatureFit::kLeastSquares, "least_squares"},
                                           {CurvatureFit::kZeroAtCones, "zero_at_cones"}});

struct GreedyOptions : ConeBudget {
  ConePick pick = ConePick::kExtreme;
  CurvatureFit fit = CurvatureFit::kLeastSquares;
};

const OptionTable<GreedyOptions>& GreedyOptionTable();

/// One cone after the other.
///
/// `pick`: `extreme` chooses the next cone where the predicted |u| is greatest, u being the log scale
/// of the cones so far at which u is made 0 (Ben-Chen, Gotsman, Bunin 2008; as the cones of
/// Sawhney, Crane, "Boundary first flattening", 2017). `descent` where a little curvature
/// lowers the distortion 1/2 sum a u^2 of the best curvatures so far most, and ends in least
/// squares. `fit`, with extreme: the curvatures at the end: `least_squares` those of least
/// distortion that the corners can carry; `zero_at_cones` those that make u = 0 at the cones, where
/// the corners can carry them.
///
/// Guarantees: the distortion predicted for least squares does not grow with the number of cones.
class GreedyCones final : public BudgetedHeuristic {
 public:
  explicit GreedyCones(const GreedyOptions& options)
      : BudgetedHeuristic(options), options_(options) {}

 protected:
  StatusOr<std::vector<Cone>> ChooseAtMost(const ConeProblem& problem, int count) const override;

 private:
  GreedyOptions options_;
};

}  // namespace cirque
