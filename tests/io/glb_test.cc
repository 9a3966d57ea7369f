// GLB as a reader of glTF 2.0 sees it.
#include <zlib.h>

#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include <Eigen/Geometry>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "cirque/io/file_input.h"
#include "cirque/io/io.h"

#include "tests/mesh/meshes.h"

namespace cirque {
namespace {

using ::testing::ElementsAre;

/// A file's parts, every length in it checked.
class Glb {
 public:
  explicit Glb(const PolygonSoup& mesh) {
    std::string bytes;
    const TextPieces pieces = *FormatMesh("m.glb", mesh);
    for (const std::string& piece : pieces) bytes += piece;
    EXPECT_EQ(bytes.substr(0, 4), "glTF");
    EXPECT_EQ(Number(bytes, 4), 2u);
    EXPECT_EQ(Number(bytes, 8), bytes.size());
    const std::uint32_t length = Number(bytes, 12);
    EXPECT_EQ(length % 4, 0u);
    EXPECT_EQ(bytes.substr(16, 4), "JSON");
    json = nlohmann::json::parse(bytes.substr(20, length));
    EXPECT_EQ(bytes.substr(24 + length, 4), std::string("BIN\0", 4));
    buffer_ = bytes.substr(28 + length);
    EXPECT_EQ(Number(bytes, 20 + length), buffer_.size());
    EXPECT_EQ(json["buffers"][0]["byteLength"], buffer_.size());
    for (const auto& view : json["bufferViews"]) {
      EXPECT_EQ(view["byteOffset"].get<std::size_t>() % 4, 0u);
      EXPECT_LE(view["byteOffset"].get<std::size_t>() + view["byteLength"].get<std::size_t>(),
                buffer_.size());
    }
  }

  std::string View(int view) const {
    const auto& v = json["bufferViews"][view];
    return buffer_.substr(v["byteOffset"], v["byteLength"]);
  }

  /// The numbers of an accessor, `shape` a row.
  template <class T>
  std::vector<T> Accessor(int number, const std::string& shape, std::size_t row) const {
    const auto& accessor = json["accessors"][number];
    EXPECT_EQ(accessor["type"], shape);
    const std::string bytes = View(accessor["bufferView"]);
    EXPECT_EQ(bytes.size(), accessor["count"].get<std::size_t>() * row * sizeof(T));
    std::vector<T> numbers;
    for (std::size_t at = 0; at < bytes.size(); at += sizeof(T)) {
      numbers.push_back(ReadBytes<T>(std::string_view(bytes).substr(at), ByteOrder::kLittle));
    }
    return numbers;
  }

  static std::uint32_t Number(const std::string& bytes, std::size_t at) {
    return ReadBytes<std::uint32_t>(std::string_view(bytes).substr(at), ByteOrder::kLittle);
  }

  nlohmann::json json;

 private:
  std::string buffer_;
};

/// Two triangles, torn along their common edge.
PolygonSoup TornSquare() {
  PolygonSoup soup =
      testing::MakeSoup({{0, 0, 0}, {1, 0, 0}, {1, 1, 0.1}, {0, 1, 0}}, {{0, 1, 2}, {0, 2, 3}});
  soup.texture = {{0, 0}, {1, 0}, {1, 1}, {5, 0}, {6, 1}, {5, 1}};
  soup.corner_texture = {0, 1, 2, 3, 4, 5};
  return soup;
}

TEST(Glb, HoldsPointsTextureAndTrianglesWithVerticesSplitAtSeams) {
  const Glb glb(TornSquare());
  EXPECT_EQ(glb.json["asset"]["version"], "2.0");
  const auto& primitive = glb.json["meshes"][0]["primitives"][0];
  const std::vector<float> position =
      glb.Accessor<float>(primitive["attributes"]["POSITION"], "VEC3", 3);
  const std::vector<float> texture =
      glb.Accessor<float>(primitive["attributes"]["TEXCOORD_0"], "VEC2", 2);
  ASSERT_EQ(position.size(), 18u);
  EXPECT_THAT(glb.Accessor<std::uint32_t>(primitive["indices"], "SCALAR", 1),
              ElementsAre(0, 1, 2, 4, 5, 3));
  // Vertex 4 is a copy of vertex 0, with the v of glTF, which counts downwards.
  EXPECT_THAT(std::vector<float>(position.begin() + 12, position.begin() + 15),
              ElementsAre(0, 0, 0));
  EXPECT_THAT(std::vector<float>(texture.begin(), texture.begin() + 2), ElementsAre(0, 1));
  EXPECT_THAT(std::vector<float>(texture.begin() + 8, texture.begin() + 12),
              ElementsAre(5, 1, 6, 0));
  const auto& accessor = glb.json["accessors"][0];
  EXPECT_THAT(accessor["min"].get<std::vector<double>>(), ElementsAre(0, 0, 0));
  EXPECT_EQ(accessor["max"][2].get<float>(), 0.1F);
}

TEST(Glb, SaysHowMuchItWasRounded) {
  const Glb glb(TornSquare());
  const auto& rounding = glb.json["meshes"][0]["extras"]["largest_rounding"];
  EXPECT_EQ(rounding["position"].get<double>(), std::abs(static_cast<double>(0.1F) - 0.1));
  EXPECT_EQ(rounding["texture"].get<double>(), 0);
}

TEST(Glb, ShowsACheckerboardOf32SquaresAcrossTheMap) {
  const Glb glb(TornSquare());  // 6 units wide; the picture is two squares
  const auto& texture = glb.json["materials"][0]["pbrMetallicRoughness"]["baseColorTexture"];
  EXPECT_NEAR(texture["extensions"]["KHR_texture_transform"]["scale"][0].get<double>(), 16. / 6,
              1e-12);
  EXPECT_EQ(glb.json["extensionsUsed"][0], "KHR_texture_transform");
  const std::string png = glb.View(glb.json["images"][0]["bufferView"]);
  ASSERT_EQ(png.substr(0, 16), std::string("\x89PNG\r\n\x1a\n\0\0\0\rIHDR", 16));
  const auto big = [&](std::size_t at) {
    return ReadBytes<std::uint32_t>(std::string_view(png).substr(at), ByteOrder::kBig);
  };
  const std::uint32_t side = big(16);
  const std::uint32_t packed = big(33);
  ASSERT_EQ(png.substr(37, 4), "IDAT");
  EXPECT_EQ(big(41 + packed), crc32(0, reinterpret_cast<const Bytef*>(&png[37]), packed + 4));
  std::string rows(side * (side + 1), '\0');
  uLongf size = rows.size();
  ASSERT_EQ(uncompress(reinterpret_cast<Bytef*>(rows.data()), &size,
                       reinterpret_cast<const Bytef*>(&png[41]), packed),
            Z_OK);
  ASSERT_EQ(size, rows.size());
  const auto pixel = [&](std::uint32_t x, std::uint32_t y) { return rows[y * (side + 1) + 1 + x]; };
  EXPECT_EQ(pixel(0, 0), pixel(side - 1, side - 1));
  EXPECT_EQ(pixel(0, side - 1), pixel(side - 1, 0));
  EXPECT_NE(pixel(0, 0), pixel(side - 1, 0));
}

TEST(Glb, CutsPolygonsIntoTrianglesInsideThem) {
  // An L of area 3: from its first corner it cannot be cut into a fan. Both ways round.
  PolygonSoup soup = testing::MakeSoup(
      {{0, 2, 0}, {0, 0, 0}, {2, 0, 0}, {2, 1, 0}, {1, 1, 0}, {1, 2, 0}}, {{0, 1, 2, 3, 4, 5}});
  const auto area = [](const PolygonSoup& mesh) {
    const Glb glb(mesh);
    const int indices = glb.json["meshes"][0]["primitives"][0]["indices"];
    const std::vector<std::uint32_t> corner = glb.Accessor<std::uint32_t>(indices, "SCALAR", 1);
    EXPECT_EQ(corner.size(), 12u);
    double sum = 0;
    for (std::size_t c = 0; c + 2 < corner.size(); c += 3) {
      const Eigen::Vector3d& a = mesh.position[corner[c]];
      sum += (mesh.position[corner[c + 1]] - a).cross(mesh.position[corner[c + 2]] - a).norm() / 2;
    }
    return sum;
  };
  EXPECT_NEAR(area(soup), 3, 1e-12);
  std::reverse(soup.corner.begin(), soup.corner.end());
  EXPECT_NEAR(area(soup), 3, 1e-12);
  for (const Eigen::Vector3d& p : soup.position) soup.texture.emplace_back(p.x(), p.y());
  soup.corner_texture = soup.corner;
  EXPECT_NEAR(area(soup), 3, 1e-12);
}

TEST(Glb, RefusesWhatSinglePrecisionCannotHold) {
  PolygonSoup soup = testing::OneTriangle();
  EXPECT_FALSE(Glb(soup).json.contains("images"));
  soup.position[2].z() = 1e39;
  EXPECT_EQ(FormatMesh("m.glb", soup).status().message(),
            "m.glb: the mesh has numbers beyond single precision, which is what this format holds");
  EXPECT_EQ(FormatMesh("m.glb", PolygonSoup()).status().message(),
            "m.glb: the mesh has no faces, and this format holds no empty mesh");
}

}  // namespace
}  // namespace cirque
