#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Geometry>

#include "cirque/io/glb_document.h"
#include "cirque/io/glb_texture.h"
#include "cirque/io/lattice_texture.h"
#include "cirque/io/mesh_formats.h"
#include "cirque/io/polygon_triangles.h"

namespace cirque {
namespace {

using Json = GlbDocument::Json;
using Row = std::array<double, 3>;

constexpr double kMarkSize = 0.008;  ///< radius of a cone's mark, as a part of the mesh's diagonal
const Eigen::Vector3d kLess(0.93, 0.45, 0.05), kMore(0.5, 0.2, 0.75);  ///< colours of marks

Row RowOf(const Eigen::Vector3d& p) { return {p.x(), p.y(), p.z()}; }

class GlbWriter {
 public:
  GlbWriter(const PolygonSoup& mesh, const LatticeTexture* lattice)
      : mesh_(mesh), lattice_(lattice) {
    if (lattice) kind_ = lattice->kind;
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
    AddMesh();
    if (lattice_) {
      AddMarks("cones_of_less_than_2_pi", kLess, true);
      AddMarks("cones_of_more_than_2_pi", kMore, false);
    }
    Json scene = Json::array();
    for (const int node : shown_) scene.push_back(node);
    document_.Add("scenes", {{"nodes", scene}});
    document_.json()["scene"] = 0;
    return document_.Assemble();
  }

 private:
  template <class PositionOf>
  int AddPositions(std::size_t count, const PositionOf& position_of) {
    Eigen::Vector3f low = Eigen::Vector3f::Constant(std::numeric_limits<float>::max());
    Eigen::Vector3f high = -low;
    for (std::size_t v = 0; v < count; ++v) {
      const Eigen::Vector3d p = position_of(v);
      for (const double x : p) document_.PutFloat(x, &position_rounding_);
      low = low.cwiseMin(p.cast<float>());
      high = high.cwiseMax(p.cast<float>());
    }
    const int accessor = document_.EndFloats(count, "VEC3");
    Json& json = document_.json()["accessors"][accessor];
    json["min"] = {low.x(), low.y(), low.z()};
    json["max"] = {high.x(), high.y(), high.z()};
    return accessor;
  }

  int AddTexture() {
    for (const Index t : split_.texture) {
      const Eigen::Vector2d uv = t == kNone ? Eigen::Vector2d(0, 0) : mesh_.texture[t];
      for (const double x : InPicture(uv, kind_)) document_.PutFloat(x, &texture_rounding_);
    }
    return document_.EndFloats(split_.vertex.size(), "VEC2");
  }

  int AddTriangles() {
    for (Index p = 0; p < mesh_.num_polygons(); ++p) {
      for (const auto& triangle : TrianglesOfPolygon(mesh_, p)) {
        for (const Index c : triangle) {
          document_.PutIndex(static_cast<std::uint32_t>(split_.corner[c]));
        }
      }
    }
    return document_.EndIndices();
  }

  void AddMesh() {
    const int position = AddPositions(
        split_.vertex.size(), [&](std::size_t v) { return mesh_.position[split_.vertex[v]]; });
    Json primitive = {{"attributes", {{"POSITION", position}}}};
    const bool is_textured = !mesh_.texture.empty();
    if (is_textured) primitive["attributes"]["TEXCOORD_0"] = AddTexture();
    primitive["indices"] = AddTriangles();
    primitive["material"] = document_.Add(
        "materials", is_textured ? TexturedMaterial(mesh_, kind_, &document_) : PlainMaterial());
    Json extras = {
        {"rounded_to", "single precision"},
        {"largest_rounding", {{"position", position_rounding_}, {"texture", texture_rounding_}}}};
    if (kind_) extras["texture_periods"] = Periods();
    const int mesh =
        document_.Add("meshes", {{"primitives", Json::array({primitive})}, {"extras", extras}});
    shown_.push_back(document_.Add("nodes", {{"mesh", mesh}}));
  }

  /// In the map's plane, what a unit of either texture coordinate is.
  Json Periods() const {
    const Lattice periods = PeriodsOf(*kind_);
    return {{periods.first.real(), periods.first.imag()},
            {periods.second.real(), periods.second.imag()}};
  }

  /// One octahedron, shown at each cone of less than a full angle, or of more.
  void AddMarks(const char* name, const Eigen::Vector3d& colour, bool less) {
    std::vector<ConeMark> marks;
    for (const ConeMark& cone : lattice_->cones) {
      if ((cone.angle_sum < 2 * kPi) == less) marks.push_back(cone);
    }
    if (marks.empty()) return;
    Json primitive = {{"attributes", {{"POSITION", AddPositions(6, [](std::size_t v) {
                                         const auto axis = static_cast<Eigen::Index>(v / 2);
                                         const double sign = v % 2 == 0 ? 1 : -1;
                                         return Eigen::Vector3d(sign * Eigen::Vector3d::Unit(axis));
                                       })}}}};
    for (const std::uint32_t x : {0, 1}) {
      for (const std::uint32_t y : {2, 3}) {
        for (const std::uint32_t z : {4, 5}) {
          const bool is_turned = (x + y + z) % 2 == 1;  // outwards all
          for (const std::uint32_t corner : {x, is_turned ? z : y, is_turned ? y : z}) {
            document_.PutIndex(corner);
          }
        }
      }
    }
    primitive["indices"] = document_.EndIndices();
    primitive["material"] = document_.Add("materials", PlainMaterial(colour));
    const int mesh = document_.Add("meshes", {{"primitives", Json::array({primitive})}});
    Json children = Json::array();
    for (const ConeMark& mark : marks) children.push_back(AddMark(mesh, mark));
    shown_.push_back(document_.Add("nodes", {{"name", name}, {"children", children}}));
  }

  int AddMark(int mesh, const ConeMark& mark) {
    Eigen::AlignedBox3d box;
    for (const Eigen::Vector3d& p : mesh_.position) box.extend(p);
    const double size = kMarkSize * box.diagonal().norm();
    return document_.Add("nodes", {{"mesh", mesh},
                                   {"translation", RowOf(mark.position)},
                                   {"scale", Row{size, size, size}},
                                   {"extras", {{"angle_sum", mark.angle_sum}}}});
  }

  const PolygonSoup& mesh_;
  const LatticeTexture* lattice_;
  std::optional<LatticeKind> kind_;
  SplitVertices split_;
  double position_rounding_ = 0, texture_rounding_ = 0;
  std::vector<int> shown_;  ///< the nodes of the scene
  GlbDocument document_;
};

}  // namespace

TextPieces FormatGlb(const PolygonSoup& mesh) { return GlbWriter(mesh, nullptr).Write(); }

TextPieces FormatLatticeGlb(const PolygonSoup& mesh, const LatticeTexture& lattice) {
  return GlbWriter(mesh, &lattice).Write();
}

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
