#pragma once

#include "cirque/core/option_factory.h"
#include "cirque/cuts/cut_heuristic.h"

namespace cirque {

/// l / (1 + |u| / mean |u|), u the logarithm of an edge's flat length over its length l, less its
/// mean: where the map is most distorted a seam changes least.
class DistortionCuts final : public CutHeuristic {
 public:
  explicit DistortionCuts(NoOptions /*options*/) {}

  StatusOr<Eigen::VectorXd> EdgeCosts(const CutProblem& problem) const override;
};

/// l / (1 + K / mean K), K the mean |curvature| of an edge's ends: seams hide in creases and at
/// tips, which the eye takes for seams anyway.
class CurvatureCuts final : public CutHeuristic {
 public:
  explicit CurvatureCuts(NoOptions /*options*/) {}

  StatusOr<Eigen::VectorXd> EdgeCosts(const CutProblem& problem) const override;
};

}  // namespace cirque
