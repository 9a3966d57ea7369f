// Damaged files of every format: whatever the bytes, a reader returns a mesh that is one or a
// message, and preflight takes that mesh. Worth most under the sanitizers.

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <random>
#include <string>

#include <gtest/gtest.h>

#include "cirque/core/atomic_file.h"
#include "cirque/io/file_input.h"
#include "cirque/io/io.h"
#include "cirque/mesh/preflight.h"

#include "tests/io/mutate.h"
#include "tests/io/om_bytes.h"
#include "tests/mesh/meshes.h"

namespace cirque {
namespace {

/// The torus as binary STL: its quadrilaterals' first halves will do.
std::string BinaryStl() {
  const PolygonSoup soup = testing::Torus();
  std::string bytes(80, ' ');
  const auto append = [&](auto value) {
    bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
  };
  append(static_cast<std::uint32_t>(soup.num_polygons()));
  for (Index p = 0; p < soup.num_polygons(); ++p) {
    for (int k = 0; k < 3; ++k) append(0.0F);
    for (int k = 0; k < 3; ++k) {
      for (const double x : soup.position[soup.corner[4 * p + k]]) append(static_cast<float>(x));
    }
    append(std::uint16_t{0});
  }
  return bytes;
}

const char kTextStl[] =
    "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\n"
    "endfacet\nendsolid a\n";

/// A binary PLY with a list in front of the indices.
std::string BinaryPly() {
  std::string bytes =
      "ply\nformat binary_little_endian 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
      "property float z\nelement face 1\nproperty list int uchar a\nproperty list uchar int "
      "vertex_indices\nend_header\n";
  bytes += std::string(36, '\0');
  bytes += std::string("\1\0\0\0\7", 5);
  bytes += std::string("\3\0\0\0\0\1\0\0\0\2\0\0\0", 13);
  return bytes;
}

/// Returns whether it was a mesh.
bool ExpectAMeshOrAMessage(const std::string& path) {
  const StatusOr<PolygonSoup> soup = ReadMesh(path);
  if (!soup.ok()) {
    EXPECT_EQ(soup.status().code(), StatusCode::kInvalidInput);
    EXPECT_TRUE(soup.status().message().starts_with(path)) << soup.status().message();
    return false;
  }
  PreflightReport report;
  const StatusOr<Surface> surface = Preflight(*soup, &report);
  EXPECT_FALSE(report.Text().empty());
  EXPECT_NE(surface.ok(), !surface.status().message().empty());
  return true;
}

void MutateManyTimes(const std::string& extension, const std::string& valid) {
  const std::string path = testing::TempPath("mutation_test." + extension);
  std::mt19937 random(7);
  ASSERT_TRUE(WriteFileAtomically(path, valid).ok());
  ASSERT_TRUE(ReadMesh(path).ok());
  constexpr int kRounds = 1500;
  int meshes = 0;
  for (int round = 0; round < kRounds; ++round) {
    ASSERT_TRUE(WriteFileAtomically(path, testing::Mutate(valid, &random)).ok());
    meshes += ExpectAMeshOrAMessage(path) ? 1 : 0;
  }
  // Both outcomes were met.
  EXPECT_GT(meshes, kRounds / 50);
  EXPECT_LT(meshes, kRounds);
  std::filesystem::remove(path);
}

TEST(MutatedFile, OfEveryWritableFormatIsAMeshOrAMessage) {
  PolygonSoup torus = testing::Torus();
  for (const std::string& extension : WritableExtensions()) {
    SCOPED_TRACE(extension);
    const std::string path = testing::TempPath("mutation_source." + extension);
    ASSERT_TRUE(WriteMesh(path, torus).ok());
    const StatusOr<std::string> valid = ReadFileContent(path);
    ASSERT_TRUE(valid.ok());
    std::filesystem::remove(path);
    MutateManyTimes(extension, *valid);
  }
}

/// Valid files by hand: of formats that are only read, and variants that are not written.
const std::multimap<std::string, std::string>& Handmade() {
  static const std::multimap<std::string, std::string> kFiles = {
      {"stl", kTextStl},
      {"stl", BinaryStl()},
      {"ply", BinaryPly()},
      {"om", testing::OmOfQuadrilateral()},
      {"obj", "v 0 0 0\nv 1 0 0\nv 0 1 \\\n0\nvt 0 0\nvn 0 0 1\nf -1/1 2//1 1/-1/1\n"}};
  return kFiles;
}

TEST(MutatedFile, ByHandIsAMeshOrAMessage) {
  for (const auto& [extension, valid] : Handmade()) {
    SCOPED_TRACE(extension);
    MutateManyTimes(extension, valid);
  }
}

TEST(MutatedFile, IsTriedOfEveryReadableFormat) {
  const std::vector<std::string> writable = WritableExtensions();
  for (const std::string& extension : ReadableExtensions()) {
    EXPECT_TRUE(Handmade().contains(extension) ||
                std::find(writable.begin(), writable.end(), extension) != writable.end())
        << "a valid file of the format '" << extension << "' belongs into Handmade()";
  }
}

TEST(MutatedFile, NoiseIsAMeshOrAMessage) {
  std::mt19937 random(11);
  for (const std::string& extension : ReadableExtensions()) {
    const std::string path = testing::TempPath("mutation_noise." + extension);
    for (std::size_t size = 0; size < 300; ++size) {
      std::string noise(size, ' ');
      for (char& byte : noise) byte = static_cast<char>(random() % 256);
      ASSERT_TRUE(WriteFileAtomically(path, noise).ok());
      ExpectAMeshOrAMessage(path);
    }
    std::filesystem::remove(path);
  }
}

}  // namespace
}  // namespace cirque
