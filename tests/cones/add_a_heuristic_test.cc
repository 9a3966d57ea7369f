// Follows the README's recipe: a new heuristic in one class and one line of a copy of the table.
#include <gtest/gtest.h>

#include "cirque/cones/cone_choice.h"
#include "cirque/cones/cone_fit.h"
#include "cirque/cones/registry.h"

#include "tests/common/surfaces.h"

namespace cirque {
namespace {

// ---- the heuristic: the vertices with the most area around them ----
class LargestVertices final : public BudgetedHeuristic {
 public:
  using BudgetedHeuristic::BudgetedHeuristic;

 protected:
  StatusOr<std::vector<Cone>> ChooseAtMost(const ConeProblem& problem, int count) const override {
    StatusOr<ConeChoice> choice = ConeChoice::Make(problem, count);
    if (!choice.ok()) return choice.status();
    ConeFit fit(problem);
    while (const auto v = choice->TakeBest(problem.area())) fit.Add(*v);
    fit.FitLeastSquares();
    return fit.Cones();
  }
};

const OptionTable<ConeBudget>& LargestVerticesOptionTable() {
  static const OptionTable<ConeBudget> kTable("largest", BudgetFields<ConeBudget>());
  return kTable;
}

// ---- its line ----
const Registry<ConeHeuristicFactory>& MyHeuristics() {
  static const Registry<ConeHeuristicFactory> kTable(
      "cone heuristic",
      {
          {"greedy", *ConeHeuristics().Find("greedy")},
          {"largest", HeuristicFactory<LargestVertices>(LargestVerticesOptionTable())},
      });
  return kTable;
}

TEST(AddAHeuristic, ItIsUsedLikeTheOthers) {
  const Surface surface = GeneratedSurface("blob", 600);
  const EdgeLengths lengths = MeasureEdgeLengths(surface);
  const ConeProblem problem(surface.triangulation, lengths);
  const auto factory = MyHeuristics().Find("largest");
  ASSERT_TRUE(factory.ok());
  const auto cones = (*(*factory)({{"cones", "9"}}))->Choose(problem);
  ASSERT_TRUE(cones.ok()) << cones.status().message();
  ASSERT_EQ(cones->size(), 9u);
  EXPECT_TRUE(ConeTargetsOf(surface.triangulation, *cones).ok());
  for (const Cone& c : *cones) EXPECT_GE(problem.area()[c.vertex], problem.area().mean());
  EXPECT_FALSE((*factory)({{"cons", "9"}}).ok());
}

}  // namespace
}  // namespace cirque
