#pragma once

#include "cirque/cones/cone_heuristic.h"

namespace cirque {

using CurvaturePeaksOptions = ConeBudget;

const OptionTable<CurvaturePeaksOptions>& CurvaturePeaksOptionTable();

/// Cones where the surface itself is most curved (the tenth of the vertices with the greatest |K|,
/// at least eight a cone while they are about as curved), far from one another, with the curvatures
/// of least distortion. Says nothing about the distortion: the baseline of the others. Without a
/// budget: the cones of SimpleConeTargets, whose angles are multiples of pi/2.
class CurvaturePeaks final : public BudgetedHeuristic {
 public:
  explicit CurvaturePeaks(const CurvaturePeaksOptions& options)
      : BudgetedHeuristic(options), simple_(options.cones < 0 && options.target == 0) {}

 protected:
  StatusOr<std::vector<Cone>> PlaceAtMost(const ConeProblem& problem, int count) const override;

 private:
  bool simple_;
};

}  // namespace cirque
