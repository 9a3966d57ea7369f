// Follows the recipe: a new heuristic is one class with its option table, and one line of the table.
// A program outside the library says that line itself, by a table of its own that has one entry more.
#include <fstream>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cirque/cones/cone_choice.h"
#include "cirque/cones/cone_fit.h"
#include "cirque/cones/registry.h"

#include "tests/common/paths.h"
#include "tests/common/surfaces.h"

namespace cirque {
namespace {

using testing::HasSubstr;

// ---- cones/largest_vertices_cones: the vertices with the most area around them ----
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
  static const OptionTable<ConeBudget> kTable("largest", BudgetOptions<ConeBudget>());
  return kTable;
}

// ---- its line ----
Registry<ConeHeuristicFactory> MyHeuristics() {
  return *ConeHeuristics().With("largest",
                                HeuristicFactory<LargestVertices>(LargestVerticesOptionTable()));
}

// ---- its use ----
class AddAHeuristic : public testing::Test {
 protected:
  const Surface surface_ = GeneratedSurface("blob", 600);
  const EdgeLengths lengths_ = MeasureEdgeLengths(surface_);
  const ConeProblem problem_{surface_.triangulation, lengths_};
};

TEST_F(AddAHeuristic, ItIsUsedLikeTheOthers) {
  const auto heuristic = MakeConeHeuristic("largest", {{"cones", "9"}}, MyHeuristics());
  ASSERT_TRUE(heuristic.ok()) << heuristic.status().message();
  const auto cones = (*heuristic)->Choose(problem_);
  ASSERT_TRUE(cones.ok()) << cones.status().message();
  ASSERT_EQ(cones->size(), 9u);
  EXPECT_TRUE(ConeTargetsOf(surface_.triangulation, *cones).ok());
  for (const Cone& c : *cones) EXPECT_GE(problem_.area()[c.vertex], problem_.area().mean());
}

TEST_F(AddAHeuristic, ItsOptionsAreCheckedLikeTheOthers) {
  const auto message = [](const OptionMap& options) {
    return MakeConeHeuristic("largest", options, MyHeuristics()).status().message();
  };
  EXPECT_THAT(message({{"cons", "9"}}), HasSubstr("did you mean 'cones'?"));
  EXPECT_THAT(message({{"cones", "-3"}}), HasSubstr("largest: cones = '-3'"));
}

TEST_F(AddAHeuristic, TheLibrarysTableStaysAsItWas) {
  const std::size_t before = ConeHeuristics().Names().size();
  EXPECT_EQ(MyHeuristics().Names().size(), before + 1);
  EXPECT_EQ(ConeHeuristics().Names().size(), before);
  const Status unknown = MakeConeHeuristic("largest").status();
  EXPECT_EQ(unknown.code(), StatusCode::kInvalidInput);
  const auto own = (*MakeConeHeuristic("greedy", {}, MyHeuristics()))->Choose(problem_);
  const auto library = (*MakeConeHeuristic("greedy"))->Choose(problem_);
  ASSERT_EQ(own->size(), library->size());
  for (std::size_t i = 0; i < own->size(); ++i) EXPECT_EQ((*own)[i].vertex, (*library)[i].vertex);
}

/// The lines of code of this file from one mark to the next.
int LinesBetween(const std::string& from, const std::string& to) {
  std::ifstream file(ProjectPath("tests/cones/add_a_heuristic_test.cc"));
  std::string line;
  int count = 0;
  bool inside = false;
  while (std::getline(file, line)) {
    if (line.starts_with("// ---- " + to)) break;
    if (inside && !line.empty() && !line.starts_with("//")) ++count;
    if (line.starts_with("// ---- " + from)) inside = true;
  }
  return count;
}

TEST_F(AddAHeuristic, TakesOnePairOfFilesAndOneEntry) {
  const int lines = LinesBetween("cones/", "its line"), entry = LinesBetween("its line", "its use");
  RecordProperty("files", "cones/NAME_cones.{h,cc}, and one line of cones/registry.cc");
  RecordProperty("lines_of_the_heuristic", lines);
  RecordProperty("lines_of_the_entry", entry);
  EXPECT_GT(lines, 10);
  EXPECT_LE(lines, 25);
  EXPECT_LE(entry, 4);
}

}  // namespace
}  // namespace cirque
