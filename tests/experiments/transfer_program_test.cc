// transfer as a user runs it, on maps that circle_patterns makes.
#include <cmath>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cirque/io/image.h"
#include "cirque/io/io.h"

#include "tests/common/run_program.h"
#include "tests/common/surfaces.h"

namespace cirque {
namespace {

using testing::HasSubstr;

class TransferProgramTest : public testing::Test {
 protected:
  void SetUp() override {
    const Surface bumps = Moved(GeneratedSurface("bumpy_terrain", 300), [](auto x) {
      return Eigen::Vector3d(x.x() + 0.9 * x.y(), x.y(), 2 * x.z());
    });
    ASSERT_TRUE(WriteMesh(Path("m.obj"), TrianglesOf(bumps)).ok());
    const ProgramResult made = RunProgram(fmt::format("circle_patterns --uv=unit --exact={} {} {}",
                                                      Path("e.obj"), Path("m.obj"), Path("a.obj")));
    ASSERT_EQ(made.exit_status, 0) << made.output;
    const ProgramResult other = RunProgram(
        fmt::format("circle_patterns --uv=unit --domain=disk {} {}", Path("m.obj"), Path("b.ply")));
    ASSERT_EQ(other.exit_status, 0) << other.output;
  }

  std::string Path(const std::string& name) const { return folder_.Path(name); }

  ProgramResult Run(const std::string& flags, const std::vector<std::string>& names) const {
    std::string command = "transfer " + flags;
    for (const std::string& name : names) command += " " + Path(name);
    return RunProgram(command);
  }

  void Expect(const std::string& flags, const std::vector<std::string>& names, int status,
              const std::string& word) const {
    const ProgramResult result = Run(flags, names);
    EXPECT_EQ(result.exit_status, status) << result.output;
    EXPECT_THAT(result.output, HasSubstr(word));
  }

  std::vector<double> Numbers(const std::string& name) const {
    std::ifstream file(Path(name));
    std::vector<double> numbers;
    for (double x = 0; file >> x;) numbers.push_back(x);
    return numbers;
  }

  TemporaryFolder folder_;
};

TEST_F(TransferProgramTest, ValuesOfVerticesAreInterpolatedAndComeBack) {
  // A linear function of space is itself at every point of the refinement.
  const PolygonSoup mesh = *ReadMesh(Path("m.obj")), exact = *ReadMesh(Path("e.obj"));
  ASSERT_GT(exact.position.size(), mesh.position.size() + 10);
  const Eigen::Vector3d slope(1, -2, 0.5);
  {
    std::ofstream file(Path("v.txt"));
    for (const Eigen::Vector3d& p : mesh.position) file << fmt::format("{} 7\n", slope.dot(p));
  }
  Expect("--values=vertices", {"m.obj", "a.obj", "e.obj", "v.txt", "fine.txt"}, 0, "");
  const std::vector<double> fine = Numbers("fine.txt");
  ASSERT_EQ(fine.size(), 2 * exact.position.size());
  for (std::size_t v = 0; v < exact.position.size(); ++v) {
    EXPECT_NEAR(fine[2 * v], slope.dot(exact.position[v]), 1e-12);
    EXPECT_NEAR(fine[2 * v + 1], 7, 1e-13);
  }
  Expect("--values=vertices", {"m.obj", "e.obj", "a.obj", "fine.txt", "back.txt"}, 0, "");
  EXPECT_EQ(Numbers("back.txt"), Numbers("v.txt"));
}

TEST_F(TransferProgramTest, ValuesOfFacesGoToTheirPiecesAndBack) {
  const PolygonSoup mesh = *ReadMesh(Path("m.obj"));
  {
    std::ofstream file(Path("f.txt"));
    for (Index f = 0; f < mesh.num_polygons(); ++f) file << f % 17 << "\n";
  }
  Expect("--values=faces", {"m.obj", "a.obj", "e.obj", "f.txt", "pieces.txt"}, 0, "");
  EXPECT_GT(Numbers("pieces.txt").size(), Numbers("f.txt").size());
  Expect("--values=faces", {"m.obj", "e.obj", "a.obj", "pieces.txt", "back.txt"}, 0, "");
  const std::vector<double> before = Numbers("f.txt"), back = Numbers("back.txt");
  ASSERT_EQ(back.size(), before.size());
  for (std::size_t f = 0; f < back.size(); ++f) EXPECT_NEAR(back[f], before[f], 1e-12);
}

TEST_F(TransferProgramTest, ASmoothTextureIsTheSameAtEveryPlaceOfTheOtherMap) {
  // Painted by the place in space, moved to the disk, and compared at the mesh's vertices.
  const PolygonSoup mesh = *ReadMesh(Path("m.obj")), a = *ReadMesh(Path("a.obj"));
  Image image{256, 256, 1, 65535, std::vector<std::uint16_t>(256 * 256, 30000)};
  ASSERT_TRUE(WriteImage(Path("flat.png"), image).ok());
  Expect("", {"m.obj", "a.obj", "b.ply", "flat.png", "moved.png"}, 0, "");
  const auto moved = ReadImage(Path("moved.png"));
  ASSERT_TRUE(moved.ok());
  EXPECT_EQ(moved->most, 65535);
  int filled = 0;
  for (const std::uint16_t sample : moved->sample) {
    EXPECT_TRUE(sample == 0 || sample == 30000);
    filled += sample != 0 ? 1 : 0;
  }
  EXPECT_NEAR(filled / 65536.0, kPi / 4, 0.06);  // a disk, and its margin
  Expect("--frame=box --width=40 --height=30", {"m.obj", "e.obj", "b.ply", "flat.png", "small.pgm"},
         0, "");
  EXPECT_EQ(ReadImage(Path("small.pgm"))->width, 40);
}

TEST_F(TransferProgramTest, WhatDoesNotFitIsRefused) {
  std::ofstream(Path("short.txt")) << "1\n2\n";
  std::ofstream(Path("ragged.txt")) << "1 2\n3\n";
  std::ofstream(Path("word.txt")) << "1\nx\n";
  const std::vector<std::string> maps = {"m.obj", "a.obj", "e.obj"};
  const auto with = [&](const std::string& in, const std::string& out) {
    std::vector<std::string> names = maps;
    names.insert(names.end(), {in, out});
    return names;
  };
  Expect("--values=vertices", with("short.txt", "o.txt"), 2, "2 rows");
  Expect("--values=vertices", with("ragged.txt", "o.txt"), 2, "ragged.txt:2: 1 numbers");
  Expect("--values=vertices", with("word.txt", "o.txt"), 2, "word.txt:2: expected a number");
  Expect("--values=edges", with("short.txt", "o.txt"), 2, "unknown kind of values 'edges'");
  Expect("--frame=unti", with("short.txt", "o.png"), 2, "did you mean 'unit'");
  Expect("--margin=-1", with("short.txt", "o.png"), 2, "a number from 0");
  Expect("", with("short.txt", "o.png"), 2, "PNG");
  Expect("", maps, 2, "transfer MESH FROM TO IN OUT");
  Expect("--values=vertices", {"m.obj", "m.obj", "e.obj", "short.txt", "o.txt"}, 2,
         "texture coordinates");
  Image image{2, 2, 3, 255, std::vector<std::uint16_t>(12, 1)};
  ASSERT_TRUE(WriteImage(Path("i.ppm"), image).ok());
  ASSERT_EQ(RunProgram(fmt::format("circle_patterns {} {}", Path("m.obj"), Path("large.obj")))
                .exit_status,
            0);
  Expect("", {"m.obj", "large.obj", "b.ply", "i.ppm", "o.ppm"}, 2, "leaves the unit square");
  EXPECT_FALSE(std::ifstream(Path("o.ppm")).good());
}

}  // namespace
}  // namespace cirque
