// A file of rotations through the program.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cirque/generators/generators.h"
#include "cirque/intrinsic/dual_paths.h"
#include "cirque/io/io.h"

#include "tests/common/run_program.h"
#include "tests/common/surfaces.h"

namespace cirque {
namespace {

using ::testing::HasSubstr;

TEST(Rotations, OfAFileAreSaidAndMet) {
  const TemporaryFolder folder;
  const std::string in = folder.Path("in.obj"), out = folder.Path("out.obj");
  const PolygonSoup soup = *GenerateMesh("double_torus", {1500, 1});
  ASSERT_TRUE(WriteMesh(in, soup).ok());
  std::string text = "# quarter turns along the handles\n";
  for (const DualPath& path : HandleLoops(SurfaceOf(soup).triangulation)) {
    text += "0";
    for (const Index h : path.entered) text += " " + std::to_string(Triangulation::Face(h) + 1);
    text += "\n";
  }
  const std::string file = folder.Write("rotations.txt", text);
  const std::string command = "circle_patterns --cones=moving --cone_budget=8 --rotations=" + file +
                              " " + in + " " + out + " --certificate=" + folder.Path("c.json");
  const ProgramResult measured = RunProgram(command);
  EXPECT_EQ(measured.exit_status, 0) << measured.output;
  EXPECT_THAT(measured.output, HasSubstr("loops       4 loops, rotations missed by up to"));
  EXPECT_THAT(measured.output, HasSubstr("as the cones have them"));
  EXPECT_THAT(folder.Read("c.json"), HasSubstr("\"loop_miss_3\""));
  const ProgramResult wrong =
      RunProgram(command + " --rotations=" + folder.Write("w.txt", "0 1 2\n"));
  EXPECT_EQ(wrong.exit_status, 2);
  EXPECT_THAT(wrong.output, HasSubstr("w.txt:1: a loop passes at least three faces"));
  const ProgramResult alone = RunProgram("circle_patterns --meet_rotations " + in + " " + out);
  EXPECT_EQ(alone.exit_status, 2);
  EXPECT_THAT(alone.output, HasSubstr("-rotations"));
  const ProgramResult on_sphere =
      RunProgram("circle_patterns --domain=torus --rotations=" + file + " " + in + " " + out);
  EXPECT_EQ(on_sphere.exit_status, 2) << on_sphere.output;
}

}  // namespace
}  // namespace cirque
