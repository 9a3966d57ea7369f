#include "cirque/io/con_file.h"

#include <filesystem>
#include <random>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cirque/intrinsic/intrinsic_delaunay.h"

#include "tests/common/surfaces.h"
#include "tests/io/mutate.h"
#include "tests/mesh/meshes.h"
#include "tests/mesh/scrambled.h"

namespace cirque {
namespace {

using ::testing::HasSubstr;
using testing::IntrinsicMesh;

void ExpectSame(const ConMesh& con, const Triangulation& t, const EdgeLengths& lengths) {
  EXPECT_EQ(con.triangulation.num_vertices, t.num_vertices);
  EXPECT_EQ(con.triangulation.vertex, t.vertex);
  EXPECT_EQ(con.triangulation.twin, t.twin);
  EXPECT_EQ(con.triangulation.edge, t.edge);
  EXPECT_EQ(con.lengths.value, lengths.value);
}

TEST(ConFile, RoundTripsEverySurfaceToTheBit) {
  for (const char* name :
       {"bumpy_terrain", "annulus", "blob", "double_torus", "long_capped_tube"}) {
    SCOPED_TRACE(name);
    const Surface surface = GeneratedSurface(name, 800);
    const EdgeLengths lengths = MeasureEdgeLengths(surface);
    const std::string path = testing::TempPath("round_trip.con");
    ASSERT_TRUE(WriteCon(path, surface.triangulation, lengths).ok());
    const StatusOr<ConMesh> con = ReadCon(path);
    std::filesystem::remove(path);
    ASSERT_TRUE(con.ok()) << con.status().message();
    ExpectSame(*con, surface.triangulation, lengths);
    EXPECT_EQ(FormatCon(con->triangulation, con->lengths),
              FormatCon(surface.triangulation, lengths));
  }
}

TEST(ConFile, RoundTripsInTheThesissForm) {
  const Triangulation square = ParseCon("m", "4 2\n1 2 3 1 1 1\n1 3 4 1 1 1\n")->triangulation;
  EdgeLengths lengths;
  lengths.value.setConstant(square.num_edges(), 0.25);
  EXPECT_EQ(FormatCon(square, lengths, ConForm::kThesis),
            "4 2\n1 2 3\n0.25 0.25 0.25\n1 3 4\n0.25 0.25 0.25\n");
  const Surface surface = GeneratedSurface("double_torus", 800);
  const EdgeLengths measured = MeasureEdgeLengths(surface);
  const std::string path = testing::TempPath("thesis.con");
  ASSERT_TRUE(WriteCon(path, surface.triangulation, measured, ConForm::kThesis).ok());
  const StatusOr<ConMesh> con = ReadCon(path);
  std::filesystem::remove(path);
  ASSERT_TRUE(con.ok()) << con.status().message();
  ExpectSame(*con, surface.triangulation, measured);
}

TEST(ConFile, TheThesissFormHoldsNoTwoEdgesBetweenTheSameVertices) {
  const IntrinsicMesh mesh = testing::LatticeTorus({1, 0}, {0.3, 1.1});
  const std::string path = testing::TempPath("no_thesis.con");
  const Status status = WriteCon(path, mesh.triangulation, mesh.lengths, ConForm::kThesis);
  EXPECT_EQ(status.code(), StatusCode::kInvalidInput);
  EXPECT_THAT(status.message(), HasSubstr("several edges between the same vertices"));
  EXPECT_FALSE(std::filesystem::exists(path));
}

TEST(ConFile, RoundTripsDeltaComplexes) {
  for (const IntrinsicMesh& mesh :
       {testing::LatticeTorus({1, 0}, {0.3, 1.1}),
        testing::Scramble(testing::LatticeTorus({1, 0}, {0.3, 1.1}), 5, 1)}) {
    const StatusOr<ConMesh> con = ParseCon("a.con", FormatCon(mesh.triangulation, mesh.lengths));
    ASSERT_TRUE(con.ok()) << con.status().message();
    ExpectSame(*con, mesh.triangulation, mesh.lengths);
  }
  // A face glued to itself: a cone of one corner.
  const StatusOr<ConMesh> con = ParseCon("a.con", "2 1\nf 1 2 2 0.5 1 1 0 3 2\n");
  ASSERT_TRUE(con.ok()) << con.status().message();
  EXPECT_EQ(con->triangulation.num_edges(), 2);
  EXPECT_EQ(EulerCharacteristic(con->triangulation), 1);
}

TEST(ConFile, LengthsLieOppositeTheirVertices) {
  const StatusOr<ConMesh> con = ParseCon("a.con", "# 3, 4, 5\n3 1 # numbers\nf 1 2 3 5 4 3 0 0 0");
  ASSERT_TRUE(con.ok()) << con.status().message();
  const Triangulation& t = con->triangulation;
  for (Index h = 0; h < 3; ++h) {
    EXPECT_EQ(t.vertex[h], h);
    EXPECT_EQ(con->lengths.value[t.edge[h]], 5 - h);
  }
}

TEST(ConFile, ReadsTheThesissLinesAndGluesByVertices) {
  const IntrinsicMesh torus = testing::PeriodicPatch(6, 1);
  const Triangulation& t = torus.triangulation;
  std::string text = std::to_string(t.num_vertices) + "\n" + std::to_string(t.num_faces()) + "\n";
  for (Index f = 0; f < t.num_faces(); ++f) {
    for (Index h = 3 * f; h < 3 * f + 3; ++h) text += std::to_string(t.vertex[h] + 1) + " ";
    for (Index h = 3 * f; h < 3 * f + 3; ++h) {
      text += std::to_string(1000 + t.edge[h]) + (h % 3 == 2 ? "\n" : " ");
    }
  }
  const StatusOr<ConMesh> con = ParseCon("a.con", text);
  ASSERT_TRUE(con.ok()) << con.status().message();
  EXPECT_EQ(con->triangulation.twin, t.twin);
  for (Index e = 0; e < t.num_edges(); ++e) EXPECT_EQ(con->lengths.value[e], 1000 + e);
}

TEST(ConFile, MessagesSayWhatWhereAndWhatToDo) {
  const std::pair<const char*, const char*> kTable[] = {
      {"", "a.con:1: the file holds no numbers"},
      {"3 f\n", "a.con:1: expected the numbers of vertices and faces, and nothing else, got 'f'"},
      {"3 0\n", "a.con:1: 3 vertices and 0 faces"},
      {"3 1000000000\n", "a.con:1: 3 vertices and 1000000000 faces"},
      {"4 2\nf 1 2 3 1 1 1\n", "the file ends after 1 faces of 2; is it cut off?"},
      {"3 1\nf 1 2 4 1 1 1\n", "a.con:2: there is no vertex 4: they count from 1 to 3"},
      {"3 1\nf 0 1 2 1 1 1\n", "a.con:2: there is no vertex 0"},
      {"3 1\nf 1 2 3 1 1\n", "a.con:2: expected three lengths after the vertices, got the end"},
      {"3 1\nf 1 2 3 1 1 0\n", "a.con:2: l2 = 0 is no length"},
      {"3 1\nf 1 2 3 1 inf 1\n", "a.con:2: l1 = inf is no length"},
      {"3 1\nf 1 2 3 1 -1 1\n", "a.con:2: l1 = -1 is no length"},
      {"3 1\nf 1 2 3 1 nan 1\n", "a.con:2: l1 = nan is no length"},
      {"3 1\nf 1 2 3 1 3 2\n", "a.con:2: no triangle has these sides: l1 = 3 is not below 2 + 1"},
      {"3 1\nf 1 2 3 1 1 1 0 0 4\n", "a.con:2: there is no side 4: they count from 1 to 3"},
      {"3 1\nf 1 2 3 1 1 1 0 0\n", "a.con:2: expected three neighbouring sides"},
      {"3 1\nf 1 2 3 1 1 1\nf\n", "a.con:3: more lines follow than the 1 faces"},
      {"4 2\nf 1 2 3 1 1 1\nf 3 2 4 1 1 1 0 0 1\n",
       "a.con:3: expected the end of the line after 6 numbers"},
      {"3 1\nf 1 2 3 1 1 1 1 0 0\n",
       "a.con:2: side 1 (of face 1, from vertex 2 to 3) is glued to itself"},
      {"4 2\nf 1 2 3 1 1 1 6 0 0\nf 3 2 4 1 1 1 0 0 0\n",
       "a.con:2: side 1 (of face 1, from vertex 2 to 3) names side 6 (of face 2, from vertex 3 to "
       "2) as its neighbour, which names side 0"},
      {"4 2\nf 1 2 3 1 1 1 6 0 0\nf 2 3 4 1 1 1 0 0 1\n",
       "a.con:2: side 1 (of face 1, from vertex 2 to 3) is glued to side 6 (of face 2, from vertex "
       "2 to 3); they must run"},
      {"4 2\nf 1 2 3 1 1 1 6 0 0\nf 3 2 4 1 1 1.00000000001 0 0 1\n",
       "has length 1, but side 6 (of face 2, from vertex 3 to 2) on the other side of it has "
       "1.00000000001"},
      {"5 2\nf 1 2 3 1 1 1\nf 1 4 5 1 1 1\n",
       "a.con:3: vertex 1 belongs to face 1 and to face 2, which no glued sides join"},
      {"6 2\nf 1 2 3 1 1 1\nf 4 5 6 1 1 1\n", "a.con:3: face 2 is not connected to face 1"},
      {"4 2\nf 1 2 3 1 1 1\nf 3 2 1 1 1 1\n", "a.con: vertex 4 belongs to no face"},
      {"3 3\nf 1 2 3 1 1 1\nf 3 2 1 1 1 1\nf 1 2 3 1 1 1\n",
       "could be glued to side 4 (of face 2, from vertex 2 to 1) and to others; add the three"},
      {"1 2\nf 1 1 1 1 1 1\nf 1 1 1 1 1 1\n", "and to others"},
  };
  for (const auto& [text, message] : kTable) {
    SCOPED_TRACE(text);
    const StatusOr<ConMesh> con = ParseCon("a.con", text);
    ASSERT_FALSE(con.ok());
    EXPECT_EQ(con.status().code(), StatusCode::kInvalidInput);
    EXPECT_THAT(con.status().message(), HasSubstr(message));
  }
}

TEST(ConFile, NeighboursMayDifferByRounding) {
  EXPECT_TRUE(
      ParseCon("a.con", "4 2\nf 1 2 3 1 1 1 6 0 0\nf 3 2 4 1 1 1.0000000000001 0 0 1\n").ok());
}

TEST(ConFile, WritesNoLengthThatIsNone) {
  IntrinsicMesh torus = testing::LatticeTorus({1, 0}, {0, 1});
  torus.lengths.value[1] = std::numeric_limits<double>::quiet_NaN();
  const std::string path = testing::TempPath("nan.con");
  EXPECT_THAT(WriteCon(path, torus.triangulation, torus.lengths).message(), HasSubstr("edge 1"));
  EXPECT_FALSE(std::filesystem::exists(path));
}

TEST(ConFile, MutatedIsAMeshOrAMessage) {
  std::mt19937 random(5);
  const Surface surface = GeneratedSurface("double_torus", 400);
  const IntrinsicMesh lattice = testing::LatticeTorus({1, 0}, {0.3, 1.1});
  for (const std::string& valid : {FormatCon(lattice.triangulation, lattice.lengths),
                                   FormatCon(surface.triangulation, MeasureEdgeLengths(surface)),
                                   std::string("4 2\nf 1 2 3 1 1 1\nf 3 2 4 1 1 1\n")}) {
    int meshes = 0;
    constexpr int kRounds = 1500;
    for (int round = 0; round < kRounds; ++round) {
      const StatusOr<ConMesh> con = ParseCon("a.con", testing::Mutate(valid, &random));
      meshes += con.ok() ? 1 : 0;
      if (con.ok()) MakeIntrinsicDelaunay(con->triangulation, con->lengths);
      EXPECT_TRUE(con.ok() || con.status().message().starts_with("a.con:"));
    }
    EXPECT_GT(meshes, kRounds / 100);
    EXPECT_LT(meshes, kRounds);
  }
}

}  // namespace
}  // namespace cirque
