#include <filesystem>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cirque/cuts/cut_graph.h"
#include "cirque/cuts/edge_files.h"

#include "tests/common/surfaces.h"
#include "tests/mesh/meshes.h"

namespace cirque {
namespace {

using ::testing::HasSubstr;

/// Hub 0 (in the file: 1) and rim 1 .. 6; face i (in the file: i + 1) has corners 0, i + 1, i + 2.
class CutFile : public ::testing::Test {
 protected:
  StatusOr<Cut> Parse(std::string_view text) const {
    return ParseCut("cuts.txt", text, t_, NumbersInFile(fan_));
  }
  std::string Refusal(std::string_view text) const { return Parse(text).status().message(); }

  const Surface fan_ = Fan(6, 0.5);
  const Triangulation& t_ = fan_.triangulation;
};

std::vector<std::pair<Index, Index>> Ends(const Triangulation& t, const Cut& cut) {
  std::vector<std::pair<Index, Index>> ends;
  for (Index e = 0; e < t.num_edges(); ++e) {
    const Index h = t.edge_halfedge[e];
    if (cut.edge[e]) ends.push_back(std::minmax(t.vertex[Triangulation::Next(h)], t.Tip(h)));
  }
  return ends;
}

TEST_F(CutFile, ReadsEdgesWithTheFaceOnEitherSide) {
  const auto cut = Parse("# two spokes\n1 3 2\n\n  5 1 4  # from the rim to the hub\n");
  ASSERT_TRUE(cut.ok()) << cut.status().message();
  EXPECT_THAT(Ends(t_, *cut), ::testing::UnorderedElementsAre(std::pair(0, 2), std::pair(0, 4)));
  const auto from_the_right = Parse("3 1 2\n1 5 4\n");
  ASSERT_TRUE(from_the_right.ok()) << from_the_right.status().message();
  EXPECT_EQ(from_the_right->edge, cut->edge);
}

TEST_F(CutFile, ErrorsNameTheLine) {
  EXPECT_EQ(
      Refusal("1 3 2\n1 3\n"),
      "cuts.txt:2: expected vertex, vertex and face, 'from to face', got the end of the line");
  EXPECT_THAT(Refusal("1 3 x\n"), HasSubstr("cuts.txt:1: expected"));
  EXPECT_THAT(Refusal("1 -3 1\n"), HasSubstr("got '-3'"));
  EXPECT_THAT(Refusal("1 3 2 9\n"), HasSubstr("expected the end of the line, got '9'"));
  EXPECT_EQ(Refusal("1 3 7\n"), "cuts.txt:1: there is no face 7");
  EXPECT_EQ(Refusal("1 3 0\n"), "cuts.txt:1: there is no face 0");
  EXPECT_EQ(Refusal("#\n1 5 1\n"), "cuts.txt:2: face 1 has no edge from vertex 1 to vertex 5");
  EXPECT_EQ(Refusal("1 99999999999 1\n"),
            "cuts.txt:1: face 1 has no edge from vertex 1 to vertex 99999999999");
  EXPECT_THAT(Refusal("1 3 2\n3 1 1\n"),
              HasSubstr("cuts.txt:2: this edge is cut already by line 1"));
  EXPECT_THAT(Refusal("2 3 1\n"), HasSubstr("cuts.txt:1: this edge lies on the boundary"));
}

TEST(CutFileOfPolygons, NamesSidesAndNoDiagonals) {
  const Surface torus = SurfaceOf(testing::Torus());  // face 1 is the quad 1 2 5 4
  const auto parse = [&](std::string_view text) {
    return ParseCut("c", text, torus.triangulation, NumbersInFile(torus));
  };
  EXPECT_TRUE(parse("1 2 1\n2 5 1\n5 4 1\n4 1 1\n").ok());
  const std::string both =
      parse("1 5 1\n").status().message() + parse("4 2 1\n").status().message();
  EXPECT_THAT(both, HasSubstr("are corners of face 1, but no side of it joins them"));
}

TEST_F(CutFile, FaceTellsMultipleEdgesApart) {
  // Two triangles glued along all three sides, twisted so that edges 0-0 are several.
  const Triangulation torus = NumberEdges(1, {0, 0, 0, 0, 0, 0}, {3, 4, 5, 0, 1, 2});
  const auto cut = ParseCut("c", "1 1 2\n", torus, OwnNumbers(torus));
  ASSERT_TRUE(cut.ok()) << cut.status().message();
  EXPECT_EQ(std::count(cut->edge.begin(), cut->edge.end(), true), 1);
}

TEST(CutFileRoundTrip, GivesTheSameCut) {
  const Surface torus = GeneratedSurface("double_torus", 800);
  const Triangulation& t = torus.triangulation;
  const Cut cut = *CutGraph(t, MeasureEdgeLengths(torus).value, {3, 100});
  const std::string path = ::testing::TempDir() + "round_trip_cut.txt";
  ASSERT_TRUE(WriteCutFile(path, t, NumbersInFile(torus), cut).ok());
  const auto back = ReadCutFile(path, t, NumbersInFile(torus));
  ASSERT_TRUE(back.ok()) << back.status().message();
  EXPECT_GT(std::count(cut.edge.begin(), cut.edge.end(), true), 10);
  EXPECT_EQ(back->edge, cut.edge);
  std::filesystem::remove(path);
}

TEST(CutFileRoundTrip, MissingFileIsNamed) {
  const Surface fan = Fan(6, 0);
  const Triangulation& t = fan.triangulation;
  EXPECT_THAT(ReadCutFile("no/such/cut", t, OwnNumbers(t)).status().message(),
              HasSubstr("no/such/cut"));
}

}  // namespace
}  // namespace cirque
