// Every option of the thesis's program on files whose every byte stands here: an octahedron, whose
// six vertices as cones of 4 pi / 3 make it flat with equilateral faces.
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "cirque/generators/generators.h"
#include "cirque/io/con_file.h"
#include "cirque/io/io.h"

#include "tests/common/run_program.h"

namespace cirque {
namespace {

using ::testing::HasSubstr;

constexpr char kObj[] =
    "v 1 0 0\nv -1 0 0\nv 0 1 0\nv 0 -1 0\nv 0 0 1\nv 0 0 -1\n"
    "f 1 3 5\nf 3 2 5\nf 2 4 5\nf 4 1 5\nf 3 1 6\nf 2 3 6\nf 4 2 6\nf 1 4 6\n";
constexpr char kCones[] =
    "1 1.3333333333333333 1.3333333333333333\n2 1.3333333333333333\n"
    "3 1.3333333333333333\n4 1.3333333333333333\n5 1.2 1.4\n6 1.2666666666666666 "
    "1.4666666666666666\n";
constexpr char kCut[] = "5 1 1\n1 3 1\n3 2 2\n2 4 3\n6 4 7\n";

class ThesisOptions : public ::testing::Test {
 protected:
  std::string Write(const std::string& name, const std::string& bytes) const {
    std::ofstream(folder_.Path(name), std::ios::binary) << bytes;
    return folder_.Path(name);
  }

  nlohmann::json Certificate() const {
    std::ifstream file(folder_.Path("out.certificate.json"));
    return nlohmann::json::parse(file);
  }

  /// All edges of all uv triangles, longest over shortest: 1 for equilateral faces.
  double EdgeRatio() const {
    const PolygonSoup map = *ReadMesh(out_);
    double least = 1e300, most = 0;
    for (std::size_t c = 0; c < map.corner_texture.size(); ++c) {
      const std::size_t next = c % 3 == 2 ? c - 2 : c + 1;
      const double length =
          (map.texture[map.corner_texture[c]] - map.texture[map.corner_texture[next]]).norm();
      least = std::min(least, length), most = std::max(most, length);
    }
    return most / least;
  }

  TemporaryFolder folder_;
  const std::string program_ =
      "circle_patterns -certificate " + folder_.Path("out.certificate.json");
  const std::string obj_ = Write("octahedron.obj", kObj), cones_ = Write("cones.txt", kCones),
                    cut_ = Write("cut.txt", kCut), out_ = folder_.Path("out.obj"),
                    con_ = folder_.Path("out.con");
};

TEST_F(ThesisOptions, IoOoIvFlattenTheOctahedronToEquilateralFaces) {
  const ProgramResult run =
      RunProgram(program_ + " -io " + obj_ + " -oo " + out_ + " -iv " + cones_);
  ASSERT_EQ(run.exit_status, 0) << run.output;
  EXPECT_NEAR(EdgeRatio(), 1, 1e-12);
  EXPECT_EQ(Certificate()["values"]["cones"], 6);
}

TEST_F(ThesisOptions, IeOpensTheEdgesOfTheFile) {
  const ProgramResult run =
      RunProgram(program_ + " -io " + obj_ + " -oo " + out_ + " -iv " + cones_ + " -ie " + cut_);
  ASSERT_EQ(run.exit_status, 0) << run.output;
  // A tree of five edges: its ten sides and the faces' vertices make a disk of ten vertices.
  EXPECT_EQ(ReadMesh(out_)->texture.size(), 10u);
  EXPECT_EQ(RunProgram("verify_map " + obj_ + " " + out_).exit_status, 0);
  const ProgramResult refused = RunProgram(program_ + " -io " + obj_ + " -oo " + out_ + " -ie " +
                                           Write("wrong.txt", "1 2 1\n"));
  EXPECT_EQ(refused.exit_status, 2);
  EXPECT_THAT(refused.output, HasSubstr("wrong.txt:1"));
}

TEST_F(ThesisOptions, OcWritesTheFlatMetricAndIcNoLaysItOut) {
  ASSERT_EQ(
      RunProgram(program_ + " -io " + obj_ + " -oo " + out_ + " -oc " + con_ + " -iv " + cones_)
          .exit_status,
      0);
  const ConMesh flat = *ReadCon(con_);
  EXPECT_NEAR(flat.lengths.value.maxCoeff() / flat.lengths.value.minCoeff(), 1, 1e-12);
  std::filesystem::remove(out_);
  const ProgramResult run = RunProgram("circle_patterns -ic " + con_ + " -no -oo " + out_);
  ASSERT_EQ(run.exit_status, 0) << run.output;
  EXPECT_NEAR(EdgeRatio(), 1, 1e-12);
}

TEST_F(ThesisOptions, IcTakesAMetricOfTheseBytes) {
  // Four equilateral faces round vertex 5: a cone of 4 pi / 3 with a free boundary.
  const std::string metric =
      Write("metric.con", "5 4\n1 3 5 1 1 1\n3 2 5 1 1 1\n2 4 5 1 1 1\n4 1 5 1 1 1\n");
  const ProgramResult run =
      RunProgram("circle_patterns -ic " + metric + " -oo " + out_ + " -oc " + con_);
  ASSERT_EQ(run.exit_status, 0) << run.output;
  // Flattened: four right angles round the centre, so the rim's sides are sqrt(2) of the spokes.
  EXPECT_NEAR(EdgeRatio(), std::sqrt(2.), 1e-12);
}

TEST_F(ThesisOptions, OneTextFileHoldsThemAll) {
  const std::string all = Write("all.txt", "-io " + obj_ + " -oo " + out_ + "\n-oc " + con_ +
                                               "\n-iv " + cones_ + "\n-ie " + cut_ + "\n");
  const ProgramResult run = RunProgram("circle_patterns " + all);
  ASSERT_EQ(run.exit_status, 0) << run.output;
  EXPECT_NEAR(EdgeRatio(), 1, 1e-12);
  EXPECT_TRUE(std::filesystem::exists(con_));
}

TEST_F(ThesisOptions, CutPathsOpenShortestPathsAndSixthTurnsAreExact) {
  const ProgramResult run = RunProgram(program_ + " -io " + obj_ + " -oo " + out_ + " -iv " +
                                       cones_ + " -cut_paths 1-5,5-3,3-2,2-4,4-6");
  ASSERT_EQ(run.exit_status, 0) << run.output;
  EXPECT_EQ(ReadMesh(out_)->texture.size(), 10u);
  for (const char* wrong : {"1-9", "1", "1-x", "-"}) {
    const ProgramResult refused =
        RunProgram(program_ + " -io " + obj_ + " -oo " + out_ + " -cut_paths=" + wrong);
    EXPECT_EQ(refused.exit_status, 2) << wrong;
    EXPECT_THAT(refused.output, HasSubstr("cut_paths")) << wrong;
  }
  const std::string fixed = Write("fixed.txt",
                                  "1 1.3333333333333333\n2 1.3333333333333333\n"
                                  "3 1.3333333333333333\n4 1.3333333333333333\n"
                                  "5 1.3333333333333333\n6 1.3333333333333333\n");
  ASSERT_EQ(RunProgram(program_ + " -io " + obj_ + " -oo " + out_ + " -iv " + fixed).exit_status,
            0);
  EXPECT_EQ(Certificate()["values"]["rotation_order"], 6);
}

TEST_F(ThesisOptions, FlipBackGivesTheInputsTrianglesBack) {
  const std::string in = folder_.Path("scrambled.obj");
  ASSERT_TRUE(WriteMesh(in, *GenerateMesh("bumpy_terrain", {400, 1})).ok());
  const ProgramResult run =
      RunProgram(program_ + " -io " + in + " -oo " + out_ + " -oc " + con_ + " -flip_back");
  ASSERT_EQ(run.exit_status, 0) << run.output;
  EXPECT_GT(Certificate()["values"]["flips"], 0);
  EXPECT_EQ(Certificate()["values"]["flip_back_stuck"], 0);
  EXPECT_EQ(ReadCon(con_)->triangulation.vertex, ReadMesh(in)->corner);
}

}  // namespace
}  // namespace cirque
