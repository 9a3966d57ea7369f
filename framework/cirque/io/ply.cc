#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include <fmt/format.h>
#include <glog/logging.h>

#include "cirque/io/file_input.h"
#include "cirque/io/mesh_formats.h"
#include "cirque/io/ply_stream.h"
#include "cirque/io/text_writer.h"

namespace cirque {
namespace {

/// The largest length or index that any mesh can have; doubles hold it exactly.
constexpr double kLargest = 4294967295.0;
constexpr std::int64_t kUnsignedMinusOne = 4294967295;

/// Reads one element at a time into the numbers of the properties that a mesh needs.
class PlyParser {
 public:
  PlyParser(const PlyHeader& header, std::unique_ptr<PlyBody> body)
      : header_(header), body_(std::move(body)) {
    FindTexture();
  }

  StatusOr<PolygonSoup> Parse() {
    Status status = CheckHeader();
    for (const PlyElement& element : header_.elements) {
      // Elements without properties take no room in the file, however many the header promises.
      const std::int64_t count = element.properties.empty() ? 0 : element.count;
      for (std::int64_t i = 0; status.ok() && i < count; ++i) {
        status = ParseElement(element, i);
        if (corner_has_texture_.size() < soup_.corner.size()) AddFaceTexture();
      }
    }
    if (!status.ok()) return status;
    if (header_.encoding == PlyEncoding::kText && body_->NextElement()) more_.At(*body_);
    soup_.warnings = header_.warnings;
    for (const PassedOver& kind : {few_corners_, more_}) kind.Warn(&soup_);
    KeepTexture();
    return std::move(soup_);
  }

 private:
  /// Vertices come before faces, and both have what a mesh needs.
  Status CheckHeader() const {
    bool has_position = false, has_faces = false;
    for (const PlyElement& element : header_.elements) {
      int coordinates = 0;
      for (const PlyProperty& property : element.properties) {
        coordinates += Coordinate(element, property) >= 0 ? 1 : 0;
        has_faces = has_faces || (has_position && IsCorners(element, property));
      }
      has_position = has_position || coordinates == 3;
    }
    if (has_faces) return Status();
    return body_->Error(
        "expected an element 'vertex' with x, y and z, then an element 'face' (or 'tristrips') "
        "with "
        "a list vertex_indices; are these points without faces?");
  }

  /// The properties that hold texture coordinates of vertices, under any of their usual names.
  void FindTexture() {
    constexpr std::array<std::string_view, 2> kNames[] = {
        {"s", "t"}, {"u", "v"}, {"texture_u", "texture_v"}, {"texture_s", "texture_t"}};
    for (const PlyElement& element : header_.elements) {
      if (element.name != "vertex") continue;
      for (const auto& [u, v] : kNames) {
        if (texture_[0] != nullptr && texture_[1] != nullptr) return;
        texture_ = {Scalar(element, u), Scalar(element, v)};
      }
    }
  }

  static const PlyProperty* Scalar(const PlyElement& element, std::string_view name) {
    const auto found = std::find_if(
        element.properties.begin(), element.properties.end(),
        [&](const PlyProperty& property) { return !property.is_list && property.name == name; });
    return found == element.properties.end() ? nullptr : &*found;
  }

  bool HasVertexTexture() const { return texture_[0] != nullptr && texture_[1] != nullptr; }

  /// A face's list of u and v for each of its corners.
  static bool IsFaceTexture(const PlyElement& element, const PlyProperty& property) {
    return element.name == "face" && property.is_list && property.name == "texcoord";
  }

  /// 0, 1, 2 for x, y, z of a vertex, else -1.
  static int Coordinate(const PlyElement& element, const PlyProperty& property) {
    constexpr std::string_view kNames = "xyz";
    if (element.name != "vertex" || property.is_list || property.name.size() != 1) return -1;
    const std::size_t k = kNames.find(property.name);
    return k == std::string_view::npos ? -1 : static_cast<int>(k);
  }

  static bool IsCorners(const PlyElement& element, const PlyProperty& property) {
    return (element.name == "face" || IsStrips(element)) && property.is_list &&
           (property.name == "vertex_indices" || property.name == "vertex_index");
  }

  static bool IsStrips(const PlyElement& element) { return element.name == "tristrips"; }

  Status ParseElement(const PlyElement& element, std::int64_t i) {
    if (!body_->NextElement()) {
      return body_->Error(fmt::format("the file ends after {} of {} elements '{}'; is it cut off?",
                                      i, element.count, Printable(element.name)));
    }
    if (element.name == "vertex") {
      soup_.position.emplace_back(0, 0, 0);
      if (HasVertexTexture()) vertex_texture_.emplace_back(0, 0);
    }
    face_texture_.clear();
    for (const PlyProperty& property : element.properties) {
      const Status status =
          property.is_list ? ParseList(element, property) : ParseScalar(element, property);
      if (!status.ok()) return status;
    }
    const bool is_finite = element.name != "vertex" || soup_.position.back().allFinite();
    if (!is_finite && soup_.not_finite_at.empty()) soup_.not_finite_at = body_->Place();
    return Status();
  }

  /// Of the face that was read last. A list of another length is something else.
  void AddFaceTexture() {
    const std::size_t num_corners = soup_.corner.size() - corner_has_texture_.size();
    const bool has_texture = face_texture_.size() == 2 * num_corners;
    corner_has_texture_.insert(corner_has_texture_.end(), num_corners, has_texture);
    for (std::size_t i = 0; has_texture && i < face_texture_.size(); i += 2) {
      corner_texture_.emplace_back(face_texture_[i], face_texture_[i + 1]);
    }
  }

  /// Corners have the texture coordinates that their faces list, where any face does, else those of
  /// their vertices.
  void KeepTexture() {
    if (!corner_texture_.empty()) {
      soup_.texture = std::move(corner_texture_);
      Index next = 0;
      for (const char has : corner_has_texture_) {
        soup_.corner_texture.push_back(has != 0 ? next++ : kNone);
      }
    } else if (!vertex_texture_.empty()) {
      soup_.texture = std::move(vertex_texture_);
      soup_.corner_texture = soup_.corner;
    }
  }

  Status ParseScalar(const PlyElement& element, const PlyProperty& property) {
    const std::optional<double> number = body_->Number(property.type);
    if (!number) return Missing("a number", element, property);
    const int k = Coordinate(element, property);
    if (k >= 0) soup_.position.back()[k] = *number;
    for (int axis = 0; HasVertexTexture() && axis < 2; ++axis) {
      if (&property == texture_[axis]) vertex_texture_.back()[axis] = *number;
    }
    return Status();
  }

  Status ParseList(const PlyElement& element, const PlyProperty& property) {
    const std::optional<double> length = body_->Number(property.count_type);
    if (!length) return Missing("the length", element, property);
    if (!IsWhole(*length) || *length < 0) {
      return body_->Error(fmt::format("a list of length {}; the file is damaged", *length));
    }
    const bool is_corners = IsCorners(element, property);
    const bool is_texture = IsFaceTexture(element, property);
    if (is_corners) corners_.clear();
    for (double i = 0; i < *length; ++i) {
      const std::optional<double> number = body_->Number(property.type);
      if (!number) return Missing("a number", element, property);
      if (is_texture) face_texture_.push_back(*number);
      if (!is_corners) continue;
      if (!IsWhole(*number)) return body_->Error(fmt::format("vertex index {}", *number));
      corners_.push_back(static_cast<std::int64_t>(*number));
    }
    if (!is_corners) return Status();
    const std::string problem = IsStrips(element) ? AddStrips() : AddFace();
    return problem.empty() ? Status() : body_->Error(problem);
  }

  /// Of the corners that were read last; returns what is wrong with them.
  std::string AddFace() {
    if (corners_.size() >= 3) return AddPolygon(corners_, &soup_);
    few_corners_.At(*body_);
    return "";
  }

  /// The triangles of strips, one behind the other with -1 between them: three corners in a row,
  /// every second one turned around. Those that touch a vertex twice only carry the strip on.
  std::string AddStrips() {
    std::size_t in_strip = 0;  // corners
    for (std::size_t i = 0; i < corners_.size(); ++i) {
      in_strip = corners_[i] == -1 || corners_[i] == kUnsignedMinusOne ? 0 : in_strip + 1;
      if (in_strip < 3) continue;
      std::array<std::int64_t, 3> c = {corners_[i - 2], corners_[i - 1], corners_[i]};
      if (in_strip % 2 == 0) std::swap(c[0], c[1]);
      if (c[0] == c[1] || c[1] == c[2] || c[2] == c[0]) continue;
      std::string problem = AddPolygon({c.begin(), c.end()}, &soup_);
      if (!problem.empty()) return problem;
    }
    return "";
  }

  static bool IsWhole(double number) {
    return std::abs(number) <= kLargest && number == std::floor(number);
  }

  Status Missing(std::string_view what, const PlyElement& element, const PlyProperty& property) {
    return body_->Missing(fmt::format("{} for property '{}' of element '{}'", what,
                                      Printable(property.name), Printable(element.name)));
  }

  const PlyHeader& header_;
  std::unique_ptr<PlyBody> body_;
  PolygonSoup soup_;
  std::vector<std::int64_t> corners_;
  std::array<const PlyProperty*, 2> texture_ = {nullptr, nullptr};  ///< of vertices: u and v
  std::vector<Eigen::Vector2d> vertex_texture_;                     ///< V
  std::vector<double> face_texture_;                                ///< of the face being read
  std::vector<Eigen::Vector2d> corner_texture_;  ///< of the corners of all faces that list any
  std::vector<char> corner_has_texture_;         ///< C
  PassedOver few_corners_{kTooFewCorners};
  PassedOver more_{"more lines follow than the header promises, and are ignored"};
};

}  // namespace

StatusOr<PolygonSoup> ParsePly(const std::string& path, std::string_view content) {
  TextScanner scanner(path, content);
  const StatusOr<PlyHeader> header = ParsePlyHeader(&scanner);
  if (!header.ok()) return header.status();
  return PlyParser(*header, MakePlyBody(header->encoding, path, scanner)).Parse();
}

namespace {

Index MostCorners(const PolygonSoup& mesh) {
  Index most = 0;
  for (Index p = 0; p < mesh.num_polygons(); ++p) {
    most = std::max(most, mesh.first_corner[p + 1] - mesh.first_corner[p]);
  }
  return most;
}

}  // namespace

TextPieces FormatPly(const PolygonSoup& mesh) {
  SplitVertices split;
  const bool textured = !mesh.texture.empty();
  if (textured) split = SplitAtSeams(mesh);
  TextWriter out;
  out.Text("ply\nformat ascii 1.0\nelement vertex ");
  out.Number(textured ? split.vertex.size() : mesh.position.size());
  out.Text("\nproperty double x\nproperty double y\nproperty double z");
  if (textured) out.Text("\nproperty double s\nproperty double t");
  out.Text("\nelement face ");
  out.Number(mesh.num_polygons());
  // Many readers know only the usual uchar, which holds 255 corners.
  out.Text(MostCorners(mesh) < 256 ? "\nproperty list uchar int vertex_indices\nend_header\n"
                                   : "\nproperty list int int vertex_indices\nend_header\n");
  WritePointsAndPolygons(mesh, textured ? &split : nullptr, &out);
  return std::move(out).TakePieces();
}

std::string FormatColouredPly(const std::vector<Eigen::Vector3d>& position,
                              const std::vector<Index>& corner, const std::vector<Colour>& colour,
                              const std::vector<std::string>& comments) {
  CHECK_EQ(corner.size(), 3 * colour.size());
  TextWriter out;
  out.Text("ply\nformat ascii 1.0\n");
  for (const std::string& comment : comments) out.Text("comment " + comment + "\n");
  out.Text("element vertex ");
  out.Number(position.size());
  out.Text("\nproperty double x\nproperty double y\nproperty double z\nelement face ");
  out.Number(colour.size());
  out.Text(
      "\nproperty list uchar int vertex_indices\nproperty uchar red\nproperty uchar green\n"
      "property uchar blue\nend_header\n");
  for (const Eigen::Vector3d& point : position) out.PointLine(point);
  for (std::size_t f = 0; f < colour.size(); ++f) {
    Eigen::Matrix<Index, 7, 1> line;
    line << 3, corner[3 * f], corner[3 * f + 1], corner[3 * f + 2], colour[f][0], colour[f][1],
        colour[f][2];
    out.PointLine(line);
  }
  return std::move(out).Take();
}

}  // namespace cirque
