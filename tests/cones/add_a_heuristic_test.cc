// Follows CONTRIBUTING.md: a new heuristic is one file pair (a class with its option table) and one line.
// A program outside the library says that line itself, by a table of its own that has one entry more.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cirque/cones/registry.h"

#include "tests/common/surfaces.h"
#include "tests/cones/example/largest_vertices_cones.h"

namespace cirque {
namespace {

using testing::HasSubstr;

// ---- its line ----
Registry<ConeHeuristicFactory> MyHeuristics() {
  return ConeHeuristics().With("largest",
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

}  // namespace
}  // namespace cirque
