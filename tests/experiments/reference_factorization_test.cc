// The yardsticks as a user runs them: the studies reference_factorization and lower_bound.
#include <regex>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cirque/generators/generators.h"
#include "cirque/io/io.h"

#include "tests/common/run_program.h"

namespace cirque {
namespace {

using ::testing::HasSubstr;

class ReferenceFactorizationTest : public ::testing::Test {
 protected:
  ReferenceFactorizationTest() {
    EXPECT_TRUE(WriteMesh(mesh_, *GenerateMesh("bumpy_terrain", {2000, 1})).ok());
  }

  const TemporaryFolder folder_;
  const std::string mesh_ = folder_.Path("in.obj");
};

TEST_F(ReferenceFactorizationTest, TimesAMesh) {
  const ProgramResult result = RunProgram("studies reference_factorization --repeats=2 " + mesh_);
  std::smatch seconds;
  ASSERT_TRUE(std::regex_search(result.output, seconds,
                                std::regex("2000 triangles +([0-9.]+) s wall +([0-9.]+) s CPU")))
      << result.output;
  EXPECT_GT(std::stod(seconds[1]), 0);
  EXPECT_GT(std::stod(seconds[2]), 0);
}

TEST_F(ReferenceFactorizationTest, TheLowerBoundWritesWhatAMapWould) {
  const std::string out = folder_.Path("out.obj");
  ASSERT_EQ(RunProgram("studies lower_bound --output=" + out + " " + mesh_).exit_status, 0);
  const PolygonSoup before = *ReadMesh(mesh_), after = *ReadMesh(out);
  EXPECT_EQ(after.position, before.position);
  EXPECT_EQ(after.corner, before.corner);
  ASSERT_EQ(after.corner_texture.size(), after.corner.size());
  for (std::size_t c = 0; c < after.corner.size(); ++c) {
    EXPECT_EQ(after.texture[after.corner_texture[c]],
              after.position[after.corner[c]].head<2>().eval());
  }
}

TEST_F(ReferenceFactorizationTest, SaysWhatTheLowerBoundNeeds) {
  const ProgramResult result = RunProgram("studies lower_bound " + mesh_);
  EXPECT_EQ(result.exit_status, 2);
  EXPECT_THAT(result.output, HasSubstr("one mesh and --output are needed"));
}

TEST_F(ReferenceFactorizationTest, ABrokenMeshLeavesNoLowerBound) {
  const std::string out = folder_.Path("out.obj");
  const std::string broken = folder_.Write("broken.obj", "v 0 0 0\nv 1 0 0\nf 1 2 3\n");
  EXPECT_EQ(RunProgram("studies lower_bound --output=" + out + " " + broken).exit_status, 2);
  EXPECT_FALSE(ReadMesh(out).ok());
}

}  // namespace
}  // namespace cirque
