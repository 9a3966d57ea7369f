// remesh as a user runs it.
#include <algorithm>
#include <cmath>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cirque/core/triangulation.h"
#include "cirque/io/io.h"

#include "tests/common/run_program.h"
#include "tests/common/surfaces.h"

namespace cirque {
namespace {

using testing::HasSubstr;

class RemeshProgramTest : public testing::Test {
 protected:
  void SetUp() override {
    ASSERT_TRUE(WriteMesh(Path("in.obj"), TrianglesOf(surface_)).ok());
    folder_.Write("bad_density.txt", "1\n2\nthree\n");
  }

  std::string Path(const std::string& name) const { return folder_.Path(name); }

  ProgramResult Run(const std::string& flags, const std::string& in = "in.obj",
                    const std::string& out = "out.obj") const {
    return RunProgram(fmt::format("remesh {} {} {}", flags, Path(in), Path(out)));
  }

  void Expect(const std::string& flags, int status, const std::string& word,
              const std::string& in = "in.obj", const std::string& out = "out.obj") const {
    const ProgramResult result = Run(flags, in, out);
    EXPECT_EQ(result.exit_status, status) << result.output;
    EXPECT_THAT(result.output, HasSubstr(word));
    EXPECT_FALSE(std::ifstream(Path("out.obj")).good()) << "nothing is half written";
  }

  Surface surface_ = GeneratedSurface("double_torus", 800);
  TemporaryFolder folder_;
};

TEST_F(RemeshProgramTest, WritesMeshCorrespondenceAndReport) {
  const ProgramResult made = Run(
      fmt::format("--vertices=500 --correspondence={} --report={}", Path("c.txt"), Path("r.json")));
  ASSERT_EQ(made.exit_status, 0) << made.output;
  EXPECT_THAT(made.output, HasSubstr("mean_least_angle"));
  const StatusOr<PolygonSoup> soup = ReadMesh(Path("out.obj"));
  ASSERT_TRUE(soup.ok());
  const Surface surface = SurfaceOf(*soup);
  EXPECT_EQ(EulerCharacteristic(surface.triangulation), -2);
  EXPECT_NEAR(surface.triangulation.num_vertices, 500, 25);
  std::ifstream lines(Path("c.txt"));
  for (const Eigen::Vector3d& x : soup->position) {
    Index face = 0, v[3] = {0, 0, 0};
    double w[3] = {0, 0, 0};
    ASSERT_TRUE(lines >> face >> v[0] >> v[1] >> v[2] >> w[0] >> w[1] >> w[2]);
    Eigen::Vector3d at(0, 0, 0);
    for (int k = 0; k < 3; ++k) {
      at += w[k] * surface_.position[v[k] - 1];
      EXPECT_EQ(surface_.triangulation.vertex[3 * (face - 1) + k], v[k] - 1);
    }
    EXPECT_LT((at - x).norm(), 1e-12);
  }
  EXPECT_THAT(folder_.Read("r.json"), HasSubstr("\"from_other\": "));
}

TEST_F(RemeshProgramTest, MeasuresWhatIsThere) {
  const ProgramResult same = Run("--measure", "in.obj", "in.obj");
  EXPECT_EQ(same.exit_status, 0) << same.output;
  EXPECT_THAT(same.output, testing::ContainsRegex("to_other +(0|[0-9.]+e-1[5-9])\n"));
}

TEST_F(RemeshProgramTest, RemeshesEveryComponent) {
  const Surface cap = Moved(GeneratedSurface("spherical_cap", 400),
                            [](auto x) { return Eigen::Vector3d(x.x() + 9, x.y(), x.z()); });
  ASSERT_TRUE(WriteMesh(Path("two.off"), Together({TrianglesOf(surface_), TrianglesOf(cap)})).ok());
  const ProgramResult made = Run("--vertices=600 --quiet", "two.off", "two.ply");
  ASSERT_EQ(made.exit_status, 0) << made.output;
  EXPECT_EQ(made.output, "");
  const StatusOr<PolygonSoup> soup = ReadMesh(Path("two.ply"));
  ASSERT_TRUE(soup.ok());
  EXPECT_NEAR(static_cast<double>(soup->position.size()), 600, 60);
  const ProgramResult measured = Run("--measure", "two.off", "two.ply");
  EXPECT_EQ(measured.exit_status, 0) << measured.output;
}

TEST_F(RemeshProgramTest, MakesQuadsIrregularAtConesOnly) {
  const ProgramResult made = Run("--quads --vertices=1500");
  ASSERT_EQ(made.exit_status, 0) << made.output;
  const StatusOr<PolygonSoup> soup = ReadMesh(Path("out.obj"));
  ASSERT_TRUE(soup.ok());
  std::vector<int> degree(soup->position.size(), 0);
  for (Index p = 0; p < soup->num_polygons(); ++p) {
    ASSERT_EQ(soup->first_corner[p + 1] - soup->first_corner[p], 4);
  }
  for (const Index v : soup->corner) ++degree[v];
  const auto irregular = std::count_if(degree.begin(), degree.end(), [](int d) { return d != 4; });
  EXPECT_THAT(made.output, HasSubstr(fmt::format("cones       {}\n", irregular)));
  EXPECT_EQ(static_cast<Index>(soup->position.size()) - soup->num_polygons(), -2);  // V - E + F
}

TEST_F(RemeshProgramTest, RefusesWithTheReason) {
  Expect("", 2, "one of --edge");
  Expect("--edge=1 --vertices=5", 2, "one of --edge");
  Expect("--edge=-1", 2, "edge");
  Expect("--edge=1e-9", 2, "at most");
  Expect("--vertices=100", 2, "there.obj", "not_there.obj");
  Expect("--vertices=100 --density=" + Path("bad_density.txt"), 2, "bad_density.txt:3");
  Expect("--vertices=100 --cones=gredy", 2, "did you mean 'greedy'?");
  Expect("--vertices=100 --even=mop", 2, "even");
  Expect("--measure --edge=1", 2, "--measure");
  Expect("--vertices=100", 2, "replace the input", "in.obj", "in.obj");
  Expect("--vertices=100", 2, "no_folder", "in.obj", "no_folder/out.obj");
}

}  // namespace
}  // namespace cirque
