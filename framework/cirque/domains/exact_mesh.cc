#include "cirque/domains/exact_mesh.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "cirque/core/grouping.h"

namespace cirque {
namespace {

/// Numbers things as they are first asked for, and remembers which they are.
class Numbering {
 public:
  explicit Numbering(std::size_t count) : number_(count, kNone) {}

  /// The number, and whether it is new.
  std::pair<Index, bool> Of(Index thing, Index next) {
    Index& number = number_[thing];
    if (number != kNone) return {number, false};
    return {number = next, true};
  }

 private:
  std::vector<Index> number_;
};

/// On an edge it is the same from the triangles on both sides, since only two weights are not 0.
Eigen::Vector3d Place(const Surface& surface, const SurfacePoint& point) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (int k = 0; k < 3; ++k) {
    const Index v = surface.triangulation.vertex[3 * point.face + k];
    if (point.barycentric[k] != 0) sum += point.barycentric[k] * surface.position[v];
  }
  return sum;
}

/// The vertex of the surface that a point is; kNone: it lies inside an edge.
Index VertexAt(const Surface& surface, const SurfacePoint& point) {
  for (int k = 0; k < 3; ++k) {
    if (point.barycentric[k] == 1) return surface.triangulation.vertex[3 * point.face + k];
  }
  return kNone;
}

class Refiner {
 public:
  Refiner(const PolygonSoup& input, const Surface& surface, const ExactMap& map)
      : surface_(surface), map_(map), point_(map.point.size()), uv_(map.uv.size()) {
    result_.mesh.position = input.position;
    if (IsOnSphere()) result_.sphere.assign(input.position.size(), Eigen::Vector3d::Zero());
  }

  ExactMesh Run() && {
    const auto polygons =
        surface_.soup_polygon.empty()
            ? Index{0}
            : *std::max_element(surface_.soup_polygon.begin(), surface_.soup_polygon.end()) + 1;
    std::vector<Index> polygon, order;
    for (Index t = 0; t < map_.num_triangles(); ++t) {
      polygon.push_back(surface_.soup_polygon[map_.face_of_input[t]]);
      if (polygon.back() != kNone) order.push_back(t);
    }
    for (const Index t : SortIntoBuckets(polygon, polygons, order).item) {
      AddTriangle(t);
      result_.polygon.push_back(polygon[t]);
    }
    return std::move(result_);
  }

 private:
  bool IsOnSphere() const { return !map_.position.empty(); }

  void AddTriangle(Index t) {
    PolygonSoup& mesh = result_.mesh;
    for (Index c = 3 * t; c < 3 * t + 3; ++c) {
      mesh.corner.push_back(PointOf(map_.corner[c]));
      if (IsOnSphere()) {
        result_.sphere.resize(mesh.position.size());
        result_.sphere[mesh.corner.back()] = map_.position[map_.corner[c]];
        continue;
      }
      const auto [uv, is_new] = uv_.Of(map_.corner_uv[c], static_cast<Index>(mesh.texture.size()));
      if (is_new) {
        mesh.texture.push_back(map_.uv[map_.corner_uv[c]]);
        AddWeight(map_.corner[c]);
      }
      mesh.corner_texture.push_back(uv);
    }
    mesh.first_corner.push_back(static_cast<Index>(mesh.corner.size()));
  }

  /// Above 0, whatever the range.
  void AddWeight(Index point) {
    if (map_.log_weight.empty()) return;
    result_.weight.push_back(
        std::max(std::exp(map_.log_weight[point]), std::numeric_limits<double>::min()));
  }

  Index PointOf(Index point) {
    const SurfacePoint& at = map_.point[point];
    const Index vertex = VertexAt(surface_, at);
    if (vertex != kNone) return surface_.soup_vertex[vertex];
    PolygonSoup& mesh = result_.mesh;
    const auto [number, is_new] = point_.Of(point, static_cast<Index>(mesh.position.size()));
    if (is_new) mesh.position.push_back(Place(surface_, at));
    return number;
  }

  const Surface& surface_;
  const ExactMap& map_;
  Numbering point_, uv_;
  ExactMesh result_;
};

}  // namespace

ExactMesh RefineByExactMap(const PolygonSoup& input, const Surface& surface, const ExactMap& map) {
  return Refiner(input, surface, map).Run();
}

std::vector<Eigen::Vector3d> HomogeneousTexture(const ExactMesh& exact) {
  std::vector<Eigen::Vector3d> homogeneous;
  homogeneous.reserve(exact.weight.size());
  for (std::size_t i = 0; i < exact.weight.size(); ++i) {
    const Eigen::Vector2d& uv = exact.mesh.texture[i];
    homogeneous.push_back(exact.weight[i] * Eigen::Vector3d(uv.x(), uv.y(), 1));
  }
  return homogeneous;
}

}  // namespace cirque
