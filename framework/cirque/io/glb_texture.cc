#include "cirque/io/glb_texture.h"

#include <cmath>
#include <string>

#include <Eigen/Geometry>

#include "cirque/io/png.h"
#include "cirque/math/lattice_pattern.h"

namespace cirque {
namespace {

using Json = GlbDocument::Json;

// Numbers of the glTF 2.0 specification.
constexpr int kNearest = 9728, kLinear = 9729, kLinearMipmapLinear = 9987, kRepeat = 10497;

constexpr double kSquaresAcross = 32;  // of the checkerboard, on the map's longer side
constexpr int kSquaresAPicture = 2, kPixelsASquare = 32;
constexpr int kPixelsAPeriod = 256;  // of a lattice

/// Two by two squares, light and dark, as PNG of two grey levels.
std::string CheckerPng() {
  constexpr int kSide = kSquaresAPicture * kPixelsASquare;
  std::string rows;
  for (int y = 0; y < kSide; ++y) {
    rows += '\0';  // no filter
    for (int x = 0; x < kSide; ++x) {
      const bool is_light = (x / kPixelsASquare + y / kPixelsASquare) % 2 == 0;
      rows += static_cast<char>(is_light ? 235 : 110);
    }
  }
  return FormatPng(kSide, kSide, PngColour::kGrey, rows);
}

/// One period of the lattice's pattern, edges a pixel wide; the first row is that of the highest v.
std::string LatticePng(LatticeKind kind) {
  const std::vector<std::uint8_t> tile = PatternTile(kind, kPixelsAPeriod, kPixelsAPeriod);
  std::string rows;
  for (int y = kPixelsAPeriod - 1; y >= 0; --y) {
    rows += '\0';  // no filter
    for (int x = 0; x < kPixelsAPeriod; ++x) {
      const float dark = static_cast<float>(tile[y * kPixelsAPeriod + x]) / 255;
      for (std::size_t k = 0; k < 3; ++k) {
        const float mixed = dark * kPatternDark[k] + (1 - dark) * kPatternLight[k];
        rows += static_cast<char>(std::lround(255 * mixed));
      }
    }
  }
  return FormatPng(kPixelsAPeriod, kPixelsAPeriod, PngColour::kRgb, rows);
}

Json SamplerThatRepeats(int magnified) {
  return {{"magFilter", magnified},
          {"minFilter", kLinearMipmapLinear},
          {"wrapS", kRepeat},
          {"wrapT", kRepeat}};
}

/// How many times the checkerboard's picture is laid along a unit of the map.
double PicturesAUnit(const PolygonSoup& mesh) {
  Eigen::AlignedBox2d box;
  for (const Eigen::Vector2d& uv : mesh.texture) box.extend(uv);
  const double longest = box.isEmpty() ? 0 : box.sizes().maxCoeff();
  return longest > 0 ? kSquaresAcross / kSquaresAPicture / longest : 1;
}

double Linear(double srgb) {  // IEC 61966-2-1; colours of glTF materials are linear
  return srgb <= 0.04045 ? srgb / 12.92 : std::pow((srgb + 0.055) / 1.055, 2.4);
}

}  // namespace

Json TexturedMaterial(const PolygonSoup& mesh, std::optional<LatticeKind> lattice,
                      GlbDocument* document) {
  Json texture;
  if (lattice) {
    texture["index"] =
        document->AddTexture("lattice", LatticePng(*lattice), SamplerThatRepeats(kLinear));
  } else {
    texture["index"] = document->AddTexture("checkers", CheckerPng(), SamplerThatRepeats(kNearest));
    const double scale = PicturesAUnit(mesh);
    texture["extensions"] = {{"KHR_texture_transform", {{"scale", {scale, scale}}}}};
    document->json()["extensionsUsed"] = Json::array({"KHR_texture_transform"});
  }
  Json material = PlainMaterial();
  material["pbrMetallicRoughness"]["baseColorTexture"] = texture;
  return material;
}

Json PlainMaterial(const Eigen::Vector3d& colour) {
  Json shown = {{"metallicFactor", 0}, {"roughnessFactor", 1}};
  if (colour != Eigen::Vector3d::Ones()) {
    shown["baseColorFactor"] = {Linear(colour.x()), Linear(colour.y()), Linear(colour.z()), 1};
  }
  return {{"doubleSided", true}, {"pbrMetallicRoughness", shown}};
}

Eigen::Vector2d InPicture(const Eigen::Vector2d& uv, std::optional<LatticeKind> lattice) {
  const Eigen::Vector2d place = lattice ? InPeriods(*lattice, uv) : uv;
  return {place.x(), 1 - place.y()};
}

}  // namespace cirque
