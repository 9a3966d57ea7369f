#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <utility>
#include <vector>

#include <Eigen/Geometry>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "cirque/io/mesh_formats.h"
#include "cirque/io/png.h"

namespace cirque {
namespace {

using Json = nlohmann::ordered_json;

// Numbers of the glTF 2.0 specification.
constexpr std::uint32_t kMagic = 0x46546C67, kVersion = 2;
constexpr std::uint32_t kJsonChunk = 0x4E4F534A, kBinaryChunk = 0x004E4942;
constexpr int kUnsignedInt = 5125, kFloat = 5126;
constexpr int kArrayBuffer = 34962, kElementArrayBuffer = 34963;
constexpr int kNearest = 9728, kLinearMipmapLinear = 9987, kRepeat = 10497;

constexpr double kSquaresAcross = 32;  // of the checkerboard, on the map's longer side
constexpr int kSquaresAPicture = 2, kPixelsASquare = 32;

template <class T>
void Append(T value, std::string* bytes) {
  const std::size_t at = bytes->size();
  bytes->resize(at + sizeof value);
  for (std::size_t i = 0; i < sizeof value; ++i) {  // little-endian
    (*bytes)[at + i] = static_cast<char>((value >> (8 * i)) & 0xFF);
  }
}

void AppendFloat(double value, std::string* bytes, double* rounding) {
  const auto rounded = static_cast<float>(value);
  *rounding = std::max(*rounding, std::abs(static_cast<double>(rounded) - value));
  std::uint32_t bits;
  std::memcpy(&bits, &rounded, sizeof bits);
  Append(bits, bytes);
}

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

using Polygon = std::vector<Eigen::Vector2d>;

double Cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& c) {
  return (b - a).x() * (c - a).y() - (b - a).y() * (c - a).x();
}

/// The polygon in its map's plane, else in the plane that it is nearest to, counter-clockwise.
Polygon Flat(const PolygonSoup& mesh, Index begin, Index end) {
  Polygon points;
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();
  bool textured = !mesh.corner_texture.empty();
  for (Index c = begin; c < end; ++c) {
    const Eigen::Vector3d& origin = mesh.position[mesh.corner[begin]];
    const Index next = c + 1 < end ? c + 1 : begin;
    normal +=
        (mesh.position[mesh.corner[c]] - origin).cross(mesh.position[mesh.corner[next]] - origin);
    textured = textured && mesh.corner_texture[c] != kNone;
  }
  Eigen::Index axis = 0;
  normal.cwiseAbs().maxCoeff(&axis);
  for (Index c = begin; c < end; ++c) {
    const Eigen::Vector3d& p = mesh.position[mesh.corner[c]];
    points.push_back(textured ? mesh.texture[mesh.corner_texture[c]]
                              : Eigen::Vector2d(p[(axis + 1) % 3], p[(axis + 2) % 3]));
  }
  double area = 0;
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    area += Cross(points[0], points[i], points[i + 1]);
  }
  if (area < 0) {
    for (Eigen::Vector2d& point : points) point.x() = -point.x();
  }
  return points;
}

/// Whether the corner in the middle of three may be cut off: convex, and no other corner in it.
bool IsEar(const Polygon& points, const std::vector<int>& left, std::size_t i) {
  const std::size_t n = left.size();
  const int before = left[(i + n - 1) % n], at = left[i], after = left[(i + 1) % n];
  const Eigen::Vector2d &a = points[before], &b = points[at], &c = points[after];
  if (!(Cross(a, b, c) > 0)) return false;
  return std::none_of(left.begin(), left.end(), [&](int other) {
    if (other == before || other == at || other == after) return false;
    const Eigen::Vector2d& p = points[other];
    return Cross(a, b, p) >= 0 && Cross(b, c, p) >= 0 && Cross(c, a, p) >= 0;
  });
}

/// Calls add(i, j, k) for triangles of the polygon's corners: ears, one after the other; what has
/// none is cut from its first corner.
template <class Add>
void CutIntoTriangles(const Polygon& points, const Add& add) {
  std::vector<int> left(points.size());
  for (std::size_t i = 0; i < left.size(); ++i) left[i] = static_cast<int>(i);
  while (left.size() > 3) {
    std::size_t ear = 0;
    while (ear < left.size() && !IsEar(points, left, ear)) ++ear;
    if (ear == left.size()) ear = 1;
    const std::size_t n = left.size();
    add(left[(ear + n - 1) % n], left[ear], left[(ear + 1) % n]);
    left.erase(left.begin() + static_cast<std::ptrdiff_t>(ear));
  }
  add(left[0], left[1], left[2]);
}

/// The buffer, and the views and accessors into it.
class GlbWriter {
 public:
  explicit GlbWriter(const PolygonSoup& mesh) : mesh_(mesh) {
    if (!mesh.texture.empty()) {
      split_ = SplitAtSeams(mesh);
    } else {
      split_.corner = mesh.corner;
      for (std::size_t v = 0; v < mesh.position.size(); ++v) {
        split_.vertex.push_back(static_cast<Index>(v));
      }
    }
  }

  TextPieces Write() {
    AddPositions();
    if (!mesh_.texture.empty()) AddTexture();
    AddTriangles();
    DescribeMesh();
    return Assemble();
  }

 private:
  /// Ends the view that began at `begin`; returns its number.
  int AddView(std::size_t begin, int target) {
    Json view = {{"buffer", 0}, {"byteOffset", begin}, {"byteLength", buffer_.size() - begin}};
    if (target != 0) view["target"] = target;
    document_["bufferViews"].push_back(view);
    buffer_.resize((buffer_.size() + 3) / 4 * 4);
    return static_cast<int>(document_["bufferViews"].size()) - 1;
  }

  Json& AddAccessor(int view, int type, std::size_t count, const char* shape) {
    document_["accessors"].push_back(
        {{"bufferView", view}, {"componentType", type}, {"count", count}, {"type", shape}});
    return document_["accessors"].back();
  }

  void AddPositions() {
    Eigen::Vector3f low = Eigen::Vector3f::Constant(std::numeric_limits<float>::max());
    Eigen::Vector3f high = -low;
    double& rounding = position_rounding_;
    for (const Index v : split_.vertex) {
      for (const double x : mesh_.position[v]) AppendFloat(x, &buffer_, &rounding);
      low = low.cwiseMin(mesh_.position[v].cast<float>());
      high = high.cwiseMax(mesh_.position[v].cast<float>());
    }
    Json& accessor = AddAccessor(AddView(0, kArrayBuffer), kFloat, split_.vertex.size(), "VEC3");
    accessor["min"] = {low.x(), low.y(), low.z()};
    accessor["max"] = {high.x(), high.y(), high.z()};
  }

  void AddTexture() {
    const std::size_t begin = buffer_.size();
    for (const Index t : split_.texture) {
      const Eigen::Vector2d uv = t == kNone ? Eigen::Vector2d::Zero() : mesh_.texture[t];
      AppendFloat(uv.x(), &buffer_, &texture_rounding_);
      AppendFloat(1 - uv.y(), &buffer_, &texture_rounding_);
    }
    AddAccessor(AddView(begin, kArrayBuffer), kFloat, split_.vertex.size(), "VEC2");
  }

  void AddTriangles() {
    const std::size_t begin = buffer_.size();
    const auto put = [&](Index corner) {
      Append(static_cast<std::uint32_t>(split_.corner[corner]), &buffer_);
    };
    for (Index p = 0; p < mesh_.num_polygons(); ++p) {
      const Index first = mesh_.first_corner[p], end = mesh_.first_corner[p + 1];
      if (end - first == 3) {
        for (Index c = first; c < end; ++c) put(c);
        continue;
      }
      CutIntoTriangles(Flat(mesh_, first, end), [&](int i, int j, int k) {
        for (const int c : {i, j, k}) put(first + c);
      });
    }
    const std::size_t count = (buffer_.size() - begin) / sizeof(std::uint32_t);
    AddAccessor(AddView(begin, kElementArrayBuffer), kUnsignedInt, count, "SCALAR");
  }

  /// How many times the checkerboard's picture is laid along a unit of the map.
  double PicturesAUnit() const {
    Eigen::AlignedBox2d box;
    for (const Eigen::Vector2d& uv : mesh_.texture) box.extend(uv);
    const double longest = box.isEmpty() ? 0 : box.sizes().maxCoeff();
    return longest > 0 ? kSquaresAcross / kSquaresAPicture / longest : 1;
  }

  void DescribeMesh() {
    Json primitive = {{"attributes", {{"POSITION", 0}}},
                      {"indices", static_cast<int>(document_["accessors"].size()) - 1},
                      {"material", 0}};
    Json material = {{"doubleSided", true},
                     {"pbrMetallicRoughness", {{"metallicFactor", 0}, {"roughnessFactor", 1}}}};
    if (!mesh_.texture.empty()) {
      primitive["attributes"]["TEXCOORD_0"] = 1;
      const double scale = PicturesAUnit();
      material["pbrMetallicRoughness"]["baseColorTexture"] = {
          {"index", 0}, {"extensions", {{"KHR_texture_transform", {{"scale", {scale, scale}}}}}}};
      AddPicture();
    }
    document_["materials"] = Json::array({material});
    document_["meshes"] =
        Json::array({{{"primitives", Json::array({primitive})},
                      {"extras",
                       {{"rounded_to", "single precision"},
                        {"largest_rounding",
                         {{"position", position_rounding_}, {"texture", texture_rounding_}}}}}}});
    document_["nodes"] = Json::array({{{"mesh", 0}}});
    document_["scenes"] = Json::array({{{"nodes", {0}}}});
    document_["scene"] = 0;
  }

  void AddPicture() {
    const std::size_t begin = buffer_.size();
    buffer_ += CheckerPng();
    document_["images"] = Json::array(
        {{{"bufferView", AddView(begin, 0)}, {"mimeType", "image/png"}, {"name", "checkers"}}});
    document_["samplers"] = Json::array({{{"magFilter", kNearest},
                                          {"minFilter", kLinearMipmapLinear},
                                          {"wrapS", kRepeat},
                                          {"wrapT", kRepeat}}});
    document_["textures"] = Json::array({{{"sampler", 0}, {"source", 0}}});
    document_["extensionsUsed"] = Json::array({"KHR_texture_transform"});
  }

  TextPieces Assemble() {
    document_["buffers"] = Json::array({{{"byteLength", buffer_.size()}}});
    std::string json = document_.dump();
    json.resize((json.size() + 3) / 4 * 4, ' ');
    std::string head, between;
    Append(kMagic, &head);
    Append(kVersion, &head);
    const std::size_t kHeaders = 12 + 8 + 8;
    Append(static_cast<std::uint32_t>(kHeaders + json.size() + buffer_.size()), &head);
    Append(static_cast<std::uint32_t>(json.size()), &head);
    Append(kJsonChunk, &head);
    Append(static_cast<std::uint32_t>(buffer_.size()), &between);
    Append(kBinaryChunk, &between);
    return {head, json, between, std::move(buffer_)};
  }

  const PolygonSoup& mesh_;
  SplitVertices split_;
  std::string buffer_;
  double position_rounding_ = 0, texture_rounding_ = 0;
  Json document_ = {{"asset", {{"version", "2.0"}, {"generator", "Cirque"}}}};
};

}  // namespace

TextPieces FormatGlb(const PolygonSoup& mesh) { return GlbWriter(mesh).Write(); }

std::string ProblemAsGlb(const PolygonSoup& mesh) {
  constexpr double kLargest = static_cast<double>(std::numeric_limits<float>::max());
  const auto fits = [](const auto& point) { return point.cwiseAbs().maxCoeff() <= kLargest / 2; };
  if (!std::all_of(mesh.position.begin(), mesh.position.end(), fits) ||
      !std::all_of(mesh.texture.begin(), mesh.texture.end(), fits)) {
    return "has numbers beyond single precision, which is what this format holds";
  }
  // A vertex takes 20 bytes, a corner at most as many for its copies and 12 for its triangle.
  const double bytes = 20.0 * static_cast<double>(mesh.position.size()) +
                       32.0 * static_cast<double>(mesh.corner.size());
  if (bytes > 0.99 * std::numeric_limits<std::uint32_t>::max()) {
    return "needs more than the 4 GiB that this format holds";
  }
  return mesh.num_polygons() == 0 ? "has no faces, and this format holds no empty mesh" : "";
}

}  // namespace cirque
