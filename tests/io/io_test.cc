#include "cirque/io/io.h"

#include <cmath>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <limits>
#include <random>
#include <sstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/mesh/meshes.h"

namespace cirque {
namespace {

using ::testing::EndsWith;
using ::testing::HasSubstr;
using ::testing::StartsWith;

class MeshFile : public ::testing::TestWithParam<std::string> {
 protected:
  std::string Path(const std::string& extension) const {
    return testing::TempPath("io_test." + extension);
  }
  void TearDown() override {
    for (const std::string& extension : ReadableExtensions()) {
      std::filesystem::remove(Path(extension));
    }
  }
};

/// Doubles over the whole range of exponents, with all their digits.
std::vector<Eigen::Vector3d> WildPoints(int count) {
  std::mt19937_64 random(1);
  std::vector<Eigen::Vector3d> points(count);
  for (Eigen::Vector3d& point : points) {
    for (double& coordinate : point) {
      do {
        const std::uint64_t bits = random();
        std::memcpy(&coordinate, &bits, sizeof bits);
      } while (!std::isfinite(coordinate));
    }
  }
  points[0] = {-0.0, std::numeric_limits<double>::denorm_min(), std::numeric_limits<double>::max()};
  return points;
}

// Long enough to be written in several pieces.
TEST_P(MeshFile, RoundTripKeepsEveryBit) {
  constexpr int kPoints = 20000;
  std::vector<std::vector<Index>> polygons = {{3, 2, 1, 0}, {999, 4, 5, 6, 7}, {2, 1, 0}};
  for (Index i = 2; i < kPoints; ++i) polygons.push_back({i, i - 1, i - 2});
  const PolygonSoup written = testing::MakeSoup(WildPoints(kPoints), polygons);
  ASSERT_TRUE(WriteMesh(Path(GetParam()), written).ok());
  const StatusOr<PolygonSoup> read = ReadMesh(Path(GetParam()));
  ASSERT_TRUE(read.ok()) << read.status().message();
  ASSERT_EQ(read->position.size(), written.position.size());
  EXPECT_EQ(std::memcmp(read->position.data(), written.position.data(),
                        written.position.size() * sizeof(Eigen::Vector3d)),
            0);
  EXPECT_EQ(read->first_corner, written.first_corner);
  EXPECT_EQ(read->corner, written.corner);
}

TEST_P(MeshFile, KeepsAPolygonOfManyCorners) {
  std::vector<Index> all(1000);
  for (Index i = 0; i < 1000; ++i) all[i] = i;
  ASSERT_TRUE(WriteMesh(Path(GetParam()), testing::MakeSoup(WildPoints(1000), {all})).ok());
  const StatusOr<PolygonSoup> read = ReadMesh(Path(GetParam()));
  ASSERT_TRUE(read.ok()) << read.status().message();
  EXPECT_EQ(read->corner, all);
}

TEST_P(MeshFile, NothingIsWrittenThatIsNotFinite) {
  PolygonSoup soup = testing::OneTriangle();
  soup.position[1].y() = NAN;
  const Status status = WriteMesh(Path(GetParam()), soup);
  EXPECT_EQ(status.message(), Path(GetParam()) +
                                  ": vertex 2 (counted from 1) is not finite; no such mesh is "
                                  "written");
  EXPECT_FALSE(std::filesystem::exists(Path(GetParam())));
}

INSTANTIATE_TEST_SUITE_P(EveryWritable, MeshFile, ::testing::ValuesIn(WritableExtensions()));

TEST_F(MeshFile, ObjKeepsTextureCoordinatesAndCornersWithout) {
  PolygonSoup written = testing::Tetrahedron();
  written.texture = {{0.1, 0.2}, {1.0 / 3, -4e-300}};
  written.corner_texture.assign(12, kNone);
  written.corner_texture[3] = 1;
  written.corner_texture[5] = 0;
  ASSERT_TRUE(WriteMesh(Path("obj"), written).ok());
  const StatusOr<PolygonSoup> read = ReadMesh(Path("obj"));
  ASSERT_TRUE(read.ok()) << read.status().message();
  EXPECT_EQ(read->texture, written.texture);
  EXPECT_EQ(read->corner_texture, written.corner_texture);
}

TEST_F(MeshFile, ObjIsWrittenInShortestDigits) {
  PolygonSoup soup = testing::OneTriangle();
  soup.position[1] = {0.1, -1e300, 1.0 / 3};
  soup.texture = {{0.5, 2}};
  soup.corner_texture = {0, kNone, 0};
  ASSERT_TRUE(WriteMesh(Path("obj"), soup).ok());
  std::ostringstream text;
  text << std::ifstream(Path("obj")).rdbuf();
  EXPECT_EQ(text.str(),
            "v 0 0 0\nv 0.1 -1e+300 0.3333333333333333\nv 0 1 0\nvt 0.5 2\nf 1/1 2 3/1\n");
}

TEST_F(MeshFile, TextureIsNotLostSilently) {
  PolygonSoup soup = testing::OneTriangle();
  soup.texture = {{0, 0}};
  soup.corner_texture = {0, 0, 0};
  EXPECT_THAT(WriteMesh(Path("off"), soup).message(),
              EndsWith("cannot hold UVs; write one of: obj"));
  soup.texture[0].x() = INFINITY;
  EXPECT_THAT(WriteMesh(Path("obj"), soup).message(), HasSubstr("texture coordinate 1"));
}

TEST_F(MeshFile, StlIsNotWritten) {
  EXPECT_THAT(WriteMesh(Path("stl"), testing::OneTriangle()).message(),
              EndsWith("cannot hold the mesh exactly; write one of: obj, off, ply"));
}

TEST(MeshIo, TheExtensionDecidesInAnyCase) {
  EXPECT_EQ(ReadMesh("/nowhere/m.OBJ").status().message(),
            "/nowhere/m.OBJ: cannot read: No such file or directory");
  EXPECT_EQ(ReadMesh("dir.obj/m.objj").status().message(),
            "dir.obj/m.objj: unknown mesh format 'objj'; did you mean 'obj'? Known: obj, off, ply, "
            "stl");
  EXPECT_THAT(ReadMesh("mesh").status().message(), StartsWith("mesh: unknown mesh format ''"));
  EXPECT_FALSE(WriteMesh("mesh.xyz", testing::OneTriangle()).ok());
}

TEST(MeshIo, AFolderIsNoMesh) {
  const std::string folder = testing::TempPath("folder.obj");
  std::filesystem::create_directory(folder);
  EXPECT_EQ(ReadMesh(folder).status().message(), folder + ": cannot read: Is a directory");
  std::filesystem::remove(folder);
}

}  // namespace
}  // namespace cirque
