// verify_map as a user runs it: what its options bind, and how it ends.
#include <fstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/common/run_program.h"

namespace cirque {
namespace {

using ::testing::HasSubstr;
using ::testing::StartsWith;

class VerifyMapProgramTest : public ::testing::Test {
 protected:
  std::string Write(const std::string& name, const std::string& content) const {
    std::ofstream(folder_.Path(name)) << content;
    return folder_.Path(name);
  }

  static void Expect(const std::string& arguments, int status, const std::string& word) {
    const ProgramResult result = RunProgram("verify_map " + arguments);
    EXPECT_EQ(result.exit_status, status) << arguments << "\n" << result.output;
    EXPECT_THAT(result.output, HasSubstr(word)) << arguments;
  }

  TemporaryFolder folder_;
  const std::string square_ = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";
  const std::string in_ = Write("in.obj", square_ + "f 1 2 3\nf 1 3 4\n");
  /// Opened along the diagonal, the second triangle moved by 2 and turned by a quarter.
  const std::string torn_ = Write(
      "torn.obj", square_ +
                      "vt 0 0\nvt 1 0\nvt 1 1\nvt 2 0\nvt 2 1\nvt 1 1\nvt 3 0\nvt 2 1\nvt 2 0\n"
                      "f 1/1 2/2 3/3\nf 1/7 3/8 4/9\n");
};

TEST_F(VerifyMapProgramTest, PatchesAndSeamsAreStatedAndBound) {
  const std::string files = " " + in_ + " " + torn_;
  Expect(files, 0, "verdict: valid (injective), torn: 2 patches of 1 component, 1 seam edge\n");
  Expect("--max_patches=2 --max_seam_edges=1" + files, 0, "valid");
  Expect("--max_patches=1" + files, 1, "INVALID: 2 patches, 1 allowed");
  Expect("--max_seam_edges=0" + files, 1, "INVALID: 1 seam edge, 0 allowed");
  Expect("--max_patches=-2" + files, 2, "max_patches = -2: a number >= 0 is needed");
  Expect("--require_seams=" + Write("seams", "1 3\n") + files, 0, "valid");
  Expect("--require_seams=" + Write("none", "# none\n") + files, 1, "should not be there: 0-2");
  Expect("--require_seams=" + Write("bad", "1 9\n") + files, 2, "bad:1: no vertex 9");
  Expect("--require_seam_rotations=4" + files, 0, "valid");
}

TEST_F(VerifyMapProgramTest, MapsInPlyAreJudged) {
  const std::string head =
      "ply\nformat ascii 1.0\nelement vertex 4\nproperty double x\nproperty double y\n"
      "property double z\nproperty float s\nproperty float t\nelement face 2\n"
      "property list uchar int vertex_indices\n";
  // Twice as large, and with the corners in another order.
  const std::string points = "0 0 0 0 0\n2 2 0 1 1\n2 0 0 1 0\n0 2 0 0 1\n";
  Expect(in_ + " " + Write("uv.ply", head + "end_header\n" + points + "3 0 2 1\n3 0 1 3\n"), 0,
         "OUT is IN times 2");
  Expect(in_ + " " +
             Write("flip.ply", head + "property list uchar float texcoord\nend_header\n" + points +
                                   "3 0 2 1 6 0 0 1 0 1 1\n3 0 1 3 6 0 0 1 1 1 0\n"),
         1, "INVALID: 1 flipped triangle (1)");
  Expect(in_ + " " +
             Write("none.ply", head + "property list uchar float texcoord\nend_header\n" + points +
                                   "3 0 2 1 4 0 0 1 0\n3 0 1 3 6 0 0 1 1 0 1\n"),
         1, "1 triangle without texture coordinates");
}

TEST_F(VerifyMapProgramTest, ACertificateIsHeldToTheTargetsAskedAbout) {
  std::string fan = "v 0 0 0\n", faces;
  for (int i = 0; i < 6; ++i) {
    fan += "v " + std::to_string(i % 3) + " " + std::to_string(i / 3 + 1) + " 1\n";
    faces += "f 1 " + std::to_string(2 + i) + " " + std::to_string(2 + (i + 1) % 6) + "\n";
  }
  const std::string in = Write("fan.obj", fan + faces);
  const std::string proof =
      Write("proof.json", R"({"outcome": "infeasible", "infeasibility": {"epsilon_over_pi": 0,
      "face_multiplier": [0, 0, 0, 0, 0, 0], "constrained_vertex": [0], "lower_over_pi": [100],
      "upper_over_pi": [100], "vertex_multiplier": [1], "carrying_faces": [],
      "carrying_vertices": []}})");
  Expect("--infeasible " + proof + " " + in, 3, "NOT PROVEN of the targets asked about");
  EXPECT_THAT(RunProgram("verify_map --infeasible " + proof + " " + in).output,
              StartsWith("targets           the certificate's own (vertex 0: 100 pi)"));
  Expect("--infeasible " + proof + " " + in + " --targets=" + Write("cones", "1 100\n"), 0,
         "accepted (no coherent angles)");
  Expect("--infeasible " + proof + " " + in + " --targets=" + Write("others", "1 1.5\n"), 3,
         "not those of the file given");
}

TEST_F(VerifyMapProgramTest, MapsAreHeldToConesAsCirclePatternsTakesThem) {
  const std::string files = " " + in_ + " " + torn_;
  Expect("--targets=" + Write("right", "2 0.5\n1 0.5\n") + files, 0, "valid");
  Expect("--targets=" + Write("wrong", "2 0.75\n") + files, 1, "wrong angle sum (1)");
}

// What circle_patterns maps, polygons among it, verify_map takes for the same surface.
TEST_F(VerifyMapProgramTest, SurfacesOfPolygonsAreJudgedAsCirclePatternsMapsThem) {
  const std::string double_sided =
      "v 0 0 0\nv 2 0 0\nv 2 1 0\nv 0 1 0\nf 1 2 3 4\nf 1 3 2\nf 1 4 3\n";
  const std::string box =
      "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 1\nv 1 0 1\nv 1 1 1\nv 0 1 1\n"
      "f 4 3 2 1\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n";
  for (const std::string& content : {double_sided, box}) {
    const std::string in = Write("polygons.obj", content), out = folder_.Path("map.obj");
    const ProgramResult mapped = RunProgram("circle_patterns -io " + in + " -oo " + out);
    EXPECT_EQ(mapped.exit_status, 0) << mapped.output;
    Expect(in + " " + out, 0, "verdict: valid (injective), 1 patch");
  }
}

}  // namespace
}  // namespace cirque
