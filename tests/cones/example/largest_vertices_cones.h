#pragma once

#include "cirque/cones/cone_heuristic.h"

namespace cirque {

const OptionTable<ConeBudget>& LargestVerticesOptionTable();

/// The example of CONTRIBUTING.md: cones at the vertices with the most area around them.
class LargestVertices final : public BudgetedHeuristic {
 public:
  using BudgetedHeuristic::BudgetedHeuristic;

 protected:
  StatusOr<std::vector<Cone>> ChooseAtMost(const ConeProblem& problem, int count) const override;
};

}  // namespace cirque
