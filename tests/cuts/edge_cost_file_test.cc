#include <fmt/format.h>
#include <gtest/gtest.h>

#include "cirque/core/atomic_file.h"
#include "cirque/cuts/edge_files.h"
#include "cirque/pipeline/cut_costs.h"
#include "cirque/pipeline/parameterize.h"

#include "tests/common/surfaces.h"

namespace cirque {
namespace {

TEST(EdgeCostFile, FactorsOfNamedEdges) {
  const Surface fan = Fan(5, 0);
  const auto costs = ParseEdgeCosts("a.txt", "# spokes\n1 2 0.5\n3 1 4 # other way\n\n",
                                    fan.triangulation, fan.soup_vertex);
  ASSERT_TRUE(costs.ok()) << costs.status().message();
  EXPECT_EQ(costs->sum(), fan.triangulation.num_edges() - 2 + 4.5);
  for (Index e = 0; e < costs->size(); ++e) {
    const Index h = fan.triangulation.edge_halfedge[e];
    const Index a = std::min(fan.triangulation.Tail(h), fan.triangulation.Tip(h));
    const Index b = std::max(fan.triangulation.Tail(h), fan.triangulation.Tip(h));
    EXPECT_EQ((*costs)[e], a == 0 && b == 1 ? 0.5 : a == 0 && b == 2 ? 4 : 1);
  }
}

TEST(EdgeCostFile, MistakesAreNamed) {
  const Surface fan = Fan(5, 0);
  const auto message = [&](const char* text) {
    return ParseEdgeCosts("a.txt", text, fan.triangulation, fan.soup_vertex).status().message();
  };
  EXPECT_EQ(message("1 2 1\n2 4 1\n"), "a.txt:2: no edge joins the vertices 2 and 4");
  EXPECT_EQ(message("1 2 1\n2 1 1\n"), "a.txt:2: the edge 2 1 has a cost already, in line 1");
  EXPECT_EQ(message("1 2 -1\n"), "a.txt:1: the cost -1 must be finite and at least 0");
  EXPECT_EQ(message("1 2\n").substr(0, 8), "a.txt:1:");
  EXPECT_EQ(message("1 2 3 4\n").substr(0, 8), "a.txt:1:");
  EXPECT_EQ(message("x\n").substr(0, 8), "a.txt:1:");
}

TEST(CutCosts, TheCutGoesWhereItIsCheap) {
  const Surface surface = GeneratedSurface("torus", 800);
  ParameterizeOptions options;
  options.cut_cost = "length";
  Parameterization shortest;
  ASSERT_TRUE(Parameterize(surface, {options}, {}, &shortest).ok());
  // The edges of the short cut made dear, another one is found, and it is longer.
  std::string text;
  const Triangulation& t = surface.triangulation;
  for (Index e = 0; e < t.num_edges(); ++e) {
    if (!shortest.cut.edge[e]) continue;
    const Index h = t.edge_halfedge[e];
    text += fmt::format("{} {} 100\n", surface.soup_vertex[t.Tail(h)] + 1,
                        surface.soup_vertex[t.Tip(h)] + 1);
  }
  options.cut_cost = "length";
  options.edge_costs = testing::TempDir() + "edge_costs.txt";
  ASSERT_TRUE(WriteFileAtomically(options.edge_costs, text).ok());
  Parameterization other;
  ASSERT_TRUE(Parameterize(surface, {options}, {}, &other).ok());
  int shared = 0;
  for (Index e = 0; e < t.num_edges(); ++e) shared += shortest.cut.edge[e] && other.cut.edge[e];
  EXPECT_LT(shared, 3);
}

}  // namespace
}  // namespace cirque
