// GLB as a reader of glTF 2.0 sees it.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include <Eigen/Geometry>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "cirque/io/io.h"
#include "cirque/io/lattice_texture.h"
#include "cirque/io/mesh_formats.h"
#include "cirque/math/lattice_pattern.h"

#include "tests/io/glb_file.h"
#include "tests/mesh/meshes.h"

namespace cirque {
namespace {

using ::testing::ElementsAre;

/// The mesh as a reader has it.
GlbFile Glb(const PolygonSoup& mesh) {
  std::string bytes;
  const TextPieces pieces = *FormatMesh("m.glb", mesh);
  for (const std::string& piece : pieces) bytes += piece;
  return GlbFile(bytes);
}

/// Two triangles, torn along their common edge.
PolygonSoup TornSquare() {
  PolygonSoup soup =
      testing::MakeSoup({{0, 0, 0}, {1, 0, 0}, {1, 1, 0.1}, {0, 1, 0}}, {{0, 1, 2}, {0, 2, 3}});
  soup.texture = {{0, 0}, {1, 0}, {1, 1}, {5, 0}, {6, 1}, {5, 1}};
  soup.corner_texture = {0, 1, 2, 3, 4, 5};
  return soup;
}

TEST(Glb, HoldsPointsTextureAndTrianglesWithVerticesSplitAtSeams) {
  const GlbFile glb = Glb(TornSquare());
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
  const GlbFile glb = Glb(TornSquare());
  const auto& rounding = glb.json["meshes"][0]["extras"]["largest_rounding"];
  EXPECT_EQ(rounding["position"].get<double>(), std::abs(static_cast<double>(0.1F) - 0.1));
  EXPECT_EQ(rounding["texture"].get<double>(), 0);
}

TEST(Glb, ShowsACheckerboardOf32SquaresAcrossTheMap) {
  const GlbFile glb = Glb(TornSquare());  // 6 units wide; the picture is two squares
  const auto& texture = glb.json["materials"][0]["pbrMetallicRoughness"]["baseColorTexture"];
  EXPECT_NEAR(texture["extensions"]["KHR_texture_transform"]["scale"][0].get<double>(), 16. / 6,
              1e-12);
  EXPECT_EQ(glb.json["extensionsUsed"][0], "KHR_texture_transform");
  const SquarePicture picture(glb.View(glb.json["images"][0]["bufferView"]));
  const int last = picture.side - 1;
  EXPECT_EQ(picture.At(0, 0), picture.At(last, last));
  EXPECT_EQ(picture.At(0, last), picture.At(last, 0));
  EXPECT_NE(picture.At(0, 0), picture.At(last, 0));
}

TEST(Glb, CutsPolygonsIntoTrianglesInsideThem) {
  // An L of area 3: from its first corner it cannot be cut into a fan. Both ways round.
  PolygonSoup soup = testing::MakeSoup(
      {{0, 2, 0}, {0, 0, 0}, {2, 0, 0}, {2, 1, 0}, {1, 1, 0}, {1, 2, 0}}, {{0, 1, 2, 3, 4, 5}});
  const auto area = [](const PolygonSoup& mesh) {
    const GlbFile glb = Glb(mesh);
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

/// The square of side 2 with its lower left corner at 0, as places of a map too.
PolygonSoup TwoByTwo() {
  PolygonSoup soup =
      testing::MakeSoup({{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}}, {{0, 1, 2, 3}});
  for (const Eigen::Vector3d& p : soup.position) soup.texture.emplace_back(p.x(), p.y());
  soup.corner_texture = soup.corner;
  return soup;
}

TEST(Glb, OfALatticeShowsOnePeriodOfItsPatternThatRepeats) {
  for (const LatticeKind kind : {LatticeKind::kSquares, LatticeKind::kTriangles}) {
    const PolygonSoup soup = TwoByTwo();
    std::string bytes;
    for (const std::string& piece : FormatLatticeGlb(soup, {kind, {}})) bytes += piece;
    const GlbFile glb(bytes);
    EXPECT_FALSE(glb.json.contains("extensionsUsed"));
    EXPECT_EQ(glb.json["samplers"][0]["wrapS"], 10497);
    EXPECT_EQ(glb.json["samplers"][0]["wrapT"], 10497);
    EXPECT_EQ(glb.json["nodes"].size(), 1u);
    const auto& mesh = glb.json["meshes"][0];
    const auto uv =
        glb.Accessor<float>(mesh["primitives"][0]["attributes"]["TEXCOORD_0"], "VEC2", 2);
    ASSERT_EQ(uv.size(), 8u);
    Eigen::Matrix2d periods;
    for (int k = 0; k < 2; ++k) {
      for (int i = 0; i < 2; ++i) periods(i, k) = mesh["extras"]["texture_periods"][k][i];
    }
    EXPECT_NEAR(periods.determinant(), kind == LatticeKind::kSquares ? 1 : std::sqrt(0.75), 1e-15);
    std::vector<Eigen::Vector2d> place;
    for (std::size_t v = 0; v < 4; ++v) {
      place.emplace_back(uv[2 * v], uv[2 * v + 1]);
      const Eigen::Vector2d back = periods * Eigen::Vector2d(uv[2 * v], 1 - uv[2 * v + 1]);
      EXPECT_LT((back - soup.texture[v]).norm(), 1e-6);
    }
    // What the square shows is the pattern: light, or dark, where that is far from its edges.
    const SquarePicture picture(glb.View(glb.json["images"][0]["bufferView"]));
    ASSERT_EQ(picture.channels, 3);
    int seen[2] = {0, 0};
    for (int i = 0; i <= 40; ++i) {
      for (int j = 0; j <= 40; ++j) {
        const double x = i / 40., y = j / 40.;
        const double distance = PatternDistance(kind, {2 * x, 2 * y});
        if (std::abs(distance) < 0.02) continue;
        const Eigen::Vector2d at = place[0] + x * (place[1] - place[0]) + y * (place[3] - place[0]);
        for (int k = 0; k < 3; ++k) {
          const float colour = distance > 0 ? kPatternDark[k] : kPatternLight[k];
          EXPECT_NEAR(picture.Sample(at, k), 255 * colour, 1) << x << " " << y;
        }
        ++seen[distance > 0];
      }
    }
    EXPECT_GT(std::min(seen[0], seen[1]), 300);
  }
}

TEST(Glb, OfALatticeMarksConesByWhatTheirAngleIs) {
  const LatticeTexture lattice = {LatticeKind::kSquares,
                                  {{{0, 0, 0}, 1.5 * kPi}, {{2, 0, 0}, 2.5 * kPi}, {{2, 2, 0}, 3}}};
  std::string bytes;
  for (const std::string& piece : FormatLatticeGlb(TwoByTwo(), lattice)) bytes += piece;
  const GlbFile glb(bytes);
  std::vector<std::vector<double>> less, more;
  for (const auto& node : glb.json["scenes"][0]["nodes"]) {
    const auto& shown = glb.json["nodes"][node.get<int>()];
    if (!shown.contains("children")) continue;
    const std::string name = shown["name"];
    for (const auto& child : shown["children"]) {
      const auto& mark = glb.json["nodes"][child.get<int>()];
      std::vector<double> row = mark["translation"];
      row.push_back(mark["extras"]["angle_sum"]);
      (name == "cones_of_less_than_2_pi" ? less : more).push_back(row);
      const auto& primitive = glb.json["meshes"][mark["mesh"].get<int>()]["primitives"][0];
      EXPECT_EQ(glb.Accessor<std::uint32_t>(primitive["indices"], "SCALAR", 1).size(), 24u);
    }
  }
  EXPECT_THAT(less, ElementsAre(ElementsAre(0, 0, 0, 1.5 * kPi), ElementsAre(2, 2, 0, 3)));
  EXPECT_THAT(more, ElementsAre(ElementsAre(2, 0, 0, 2.5 * kPi)));
}

TEST(Glb, AMarkIsAClosedOctahedronSeenFromOutside) {
  std::string bytes;
  const LatticeTexture lattice = {LatticeKind::kTriangles, {{{0, 0, 0}, 1}}};
  for (const std::string& piece : FormatLatticeGlb(TwoByTwo(), lattice)) bytes += piece;
  const GlbFile glb(bytes);
  const auto& primitive = glb.json["meshes"][1]["primitives"][0];
  const auto x = glb.Accessor<float>(primitive["attributes"]["POSITION"], "VEC3", 3);
  const auto corner = glb.Accessor<std::uint32_t>(primitive["indices"], "SCALAR", 1);
  double volume = 0;
  for (std::size_t c = 0; c < corner.size(); c += 3) {
    const auto at = [&](std::size_t k) {
      const std::size_t v = 3 * corner[c + k];
      return Eigen::Vector3d(x[v], x[v + 1], x[v + 2]);
    };
    const double part = at(0).cross(at(1)).dot(at(2)) / 6;
    EXPECT_GT(part, 0);
    volume += part;
  }
  EXPECT_NEAR(volume, 4. / 3, 1e-6);
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
