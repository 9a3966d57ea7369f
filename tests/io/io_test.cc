#include "cirque/io/io.h"

#include <cmath>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <limits>
#include <map>
#include <random>
#include <sstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/io/om_bytes.h"
#include "tests/mesh/meshes.h"

namespace cirque {
namespace {

using ::testing::EndsWith;
using ::testing::HasSubstr;
using ::testing::Not;
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
  for (const std::string& extension : MapExtensions()) {
    const std::string path = Path(extension);
    ASSERT_TRUE(WriteMesh(path, soup).ok()) << extension;
    EXPECT_THAT(FormatMesh(path, soup)->front() + FormatMesh(path, soup)->back(),
                Not(FormatMesh(path, testing::OneTriangle())->front() +
                    FormatMesh(path, testing::OneTriangle())->back()));
    std::filesystem::remove(path);
  }
  soup.texture[0].x() = INFINITY;
  for (const std::string& extension : MapExtensions()) {
    EXPECT_THAT(WriteMesh(Path(extension), soup).message(), HasSubstr("texture coordinate 1"));
  }
}

/// A tetrahedron that every edge is a seam of, but that two corners at a vertex agree.
PolygonSoup Torn() {
  PolygonSoup soup = testing::Tetrahedron();
  for (Index c = 0; c < 12; ++c) {
    soup.texture.emplace_back(0.1 * c, 1.0 / (c + 3));
    soup.corner_texture.push_back(c);
  }
  for (Index c = 1; c < 12; ++c) {
    if (soup.corner[c] == soup.corner[0]) soup.texture[c] = soup.texture[0];
  }
  return soup;
}

// Vertices may be split, but every corner keeps its point and its texture coordinates to the bit.
TEST_P(MeshFile, TextureRoundTripsCornerByCorner) {
  const PolygonSoup written = Torn();
  ASSERT_TRUE(WriteMesh(Path(GetParam()), written).ok());
  const StatusOr<PolygonSoup> read = ReadMesh(Path(GetParam()));
  ASSERT_TRUE(read.ok()) << read.status().message();
  EXPECT_EQ(read->first_corner, written.first_corner);
  ASSERT_EQ(read->corner_texture.size(), 12u);
  for (Index c = 0; c < 12; ++c) {
    EXPECT_EQ(read->position[read->corner[c]], written.position[written.corner[c]]) << c;
    EXPECT_EQ(read->texture[read->corner_texture[c]], written.texture[c]) << c;
  }
  EXPECT_EQ(read->position.size(), GetParam() == "obj" ? 4u : 10u);
}

TEST(SplitAtSeams, FirstKeepsTheVerticesAndThenAddsTheCopies) {
  PolygonSoup soup = Torn();
  const SplitVertices split = SplitAtSeams(soup);
  ASSERT_EQ(split.vertex.size(), 10u);
  for (Index v = 0; v < 4; ++v) EXPECT_EQ(split.vertex[v], v);
  for (Index c = 0; c < 12; ++c) {
    EXPECT_EQ(split.vertex[split.corner[c]], soup.corner[c]);
    EXPECT_EQ(soup.texture[split.texture[split.corner[c]]], soup.texture[soup.corner_texture[c]]);
  }
  soup.corner_texture.assign(12, kNone);
  EXPECT_EQ(SplitAtSeams(soup).corner, soup.corner);
  EXPECT_EQ(SplitAtSeams(soup).texture, std::vector<Index>(4, kNone));
}

TEST_F(MeshFile, StlIsNotWritten) {
  EXPECT_THAT(WriteMesh(Path("stl"), testing::OneTriangle()).message(),
              EndsWith("cannot hold the mesh exactly; write one of: obj, off, ply, glb"));
}

TEST(MeshIo, TheExtensionDecidesInAnyCase) {
  EXPECT_EQ(ReadMesh("/nowhere/m.OBJ").status().message(),
            "/nowhere/m.OBJ: cannot read: No such file or directory");
  EXPECT_EQ(ParseMesh("dir.obj/m.objj", "what").status().message(),
            "dir.obj/m.objj: unknown mesh format 'objj'; did you mean 'obj'? Known: obj, off, ply, "
            "stl, om, and the content is plainly none of them");
  EXPECT_THAT(ParseMesh("mesh", "").status().message(), StartsWith("mesh: unknown mesh format ''"));
  EXPECT_FALSE(WriteMesh("mesh.xyz", testing::OneTriangle()).ok());
}

// A loop over the formats: under a name that says nothing, under a wrong one, from a stream.
TEST(MeshIo, TheContentDecidesWhereTheNameDoesNot) {
  std::map<std::string, std::string> contents;
  const PolygonSoup soup = testing::Tetrahedron();
  for (const std::string& extension : WritableExtensions()) {
    const TextPieces pieces = *FormatMesh("m." + extension, soup);
    for (const std::string& piece : pieces) {
      contents[extension] += piece;
    }
  }
  contents["stl"] =
      "solid a\n facet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\n"
      "vertex 0 1 0\nendloop\nendfacet\nendsolid\n";
  contents["om"] = testing::OmOfQuadrilateral();
  for (const std::string& extension : ReadableExtensions()) {
    ASSERT_TRUE(contents.contains(extension)) << extension;
    const std::string text = extension == "ply" || extension == "stl" || extension == "om"
                                 ? contents[extension]
                                 : "# c\n\n" + contents[extension];
    const PolygonSoup plain = *ParseMesh("m." + extension, text);
    EXPECT_TRUE(plain.warnings.empty());
    for (const std::string& other : ReadableExtensions()) {
      for (const std::string& name :
           {"m." + other, std::string("/dev/stdin"), std::string("-"), std::string("m"),
            std::string("m.dat"), std::string("m.gz")}) {
        const StatusOr<PolygonSoup> read = ParseMesh(name, text);
        ASSERT_TRUE(read.ok()) << name << read.status().message();
        EXPECT_EQ(read->corner, plain.corner);
        EXPECT_EQ(read->position, plain.position);
        const bool lies = name == "m." + other && other != extension;
        EXPECT_EQ(read->warnings.size(), lies ? 1u : 0u) << name;
        if (!lies) continue;
        EXPECT_EQ(read->warnings[0], name + ": this is " + extension + ", whatever its name says");
      }
    }
  }
}

TEST(MeshIo, AFolderIsNoMesh) {
  const std::string folder = testing::TempPath("folder.obj");
  std::filesystem::create_directory(folder);
  EXPECT_EQ(ReadMesh(folder).status().message(), folder + ": cannot read: Is a directory");
  std::filesystem::remove(folder);
}

}  // namespace
}  // namespace cirque
