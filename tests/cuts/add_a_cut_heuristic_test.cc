// Follows CONTRIBUTING.md: a new heuristic is one file pair (a class with its option table) and one line.
// A program outside the library says that line itself, by a table of its own that has one entry more.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cirque/cuts/registry.h"
#include "cirque/mesh/surface.h"
#include "cirque/pipeline/parameterize.h"

#include "tests/common/surfaces.h"
#include "tests/cuts/example/underside_cuts.h"

namespace cirque {
namespace {

using testing::HasSubstr;

// ---- its line ----
Registry<CutHeuristicFactory> MyHeuristics() {
  return CutHeuristics().With("underside", CutFactory<UndersideCuts>(UndersideOptionTable()));
}

// ---- its use ----
double MeanHeight(const Surface& surface, const Cut& cut) {
  const Triangulation& t = surface.triangulation;
  double sum = 0, count = 0;
  for (Index e = 0; e < t.num_edges(); ++e) {
    if (!cut.edge[e]) continue;
    const Index h = t.edge_halfedge[e];
    sum += 0.5 * (surface.position[t.Tail(h)] + surface.position[t.Tip(h)]).z();
    ++count;
  }
  return sum / count;
}

TEST(AddACutHeuristic, ItIsUsedLikeTheOthers) {
  const Surface torus = Moved(GeneratedSurface("torus", 800), [](const Eigen::Vector3d& x) {
    return Eigen::Vector3d(x.z(), x.y(), x.x());  // stands on its rim
  });
  const auto height = [&](const std::shared_ptr<const CutHeuristic>& own) {
    ParameterizeOptions options;
    options.cones = "none";
    options.cut_cost = "length";
    options.own_cut = own;
    Parameterization map;
    EXPECT_TRUE(Parameterize(torus, {options}, {}, &map).ok());
    return MeanHeight(torus, map.cut);
  };
  const auto heuristic = MakeCutHeuristic("underside", {{"weight", "30"}}, MyHeuristics());
  ASSERT_TRUE(heuristic.ok()) << heuristic.status().message();
  EXPECT_LT(height(*heuristic), height(nullptr));
}

TEST(AddACutHeuristic, ItsOptionsAreCheckedLikeTheOthers) {
  const auto message = [](const OptionMap& options) {
    return MakeCutHeuristic("underside", options, MyHeuristics()).status().message();
  };
  EXPECT_THAT(message({{"wieght", "9"}}), HasSubstr("did you mean 'weight'?"));
  EXPECT_THAT(message({{"weight", "-3"}}), HasSubstr("underside: weight = '-3'"));
}

TEST(AddACutHeuristic, TheLibrarysTableStaysAsItWas) {
  const std::size_t before = CutHeuristics().Names().size();
  EXPECT_EQ(MyHeuristics().Names().size(), before + 1);
  EXPECT_EQ(CutHeuristics().Names().size(), before);
  EXPECT_EQ(MakeCutHeuristic("underside").status().code(), StatusCode::kInvalidInput);
}

}  // namespace
}  // namespace cirque
