#include "tests/cones/example/largest_vertices_cones.h"

#include "cirque/cones/cone_choice.h"
#include "cirque/cones/cone_fit.h"

namespace cirque {

const OptionTable<ConeBudget>& LargestVerticesOptionTable() {
  static const OptionTable<ConeBudget> kTable("largest", BudgetOptions<ConeBudget>());
  return kTable;
}

StatusOr<std::vector<Cone>> LargestVertices::ChooseAtMost(const ConeProblem& problem,
                                                          int count) const {
  StatusOr<ConeChoice> choice = ConeChoice::Make(problem, count);
  if (!choice.ok()) return choice.status();
  ConeFit fit(problem);
  while (const auto v = choice->TakeBest(problem.area())) fit.Add(*v);
  fit.FitLeastSquares();
  return fit.Cones();
}

}  // namespace cirque
