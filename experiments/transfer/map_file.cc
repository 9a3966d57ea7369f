#include "experiments/transfer/map_file.h"

#include <algorithm>
#include <limits>
#include <utility>

#include <Eigen/Geometry>
#include <fmt/format.h>

#include "cirque/core/grouping.h"
#include "cirque/domains/atlas.h"
#include "cirque/domains/map_mesh.h"
#include "cirque/io/io.h"
#include "cirque/verify/refinement_check.h"

namespace cirque {
namespace {

constexpr std::string_view kFirstGroup = "\ng face_";

using Point = Eigen::Vector3d;

/// Barycentric coordinates of the foot of p in a triangle.
Eigen::Vector3d Barycentric(const Point& a, const Point& b, const Point& c, const Point& p) {
  const Point normal = (b - a).cross(c - a);
  const Eigen::Vector3d areas(normal.dot((b - p).cross(c - p)), normal.dot((c - p).cross(a - p)),
                              normal.dot((a - p).cross(b - p)));
  return areas / areas.sum();
}

class MapReader {
 public:
  MapReader(const MeshOfMaps& of, MapFile* map) : of_(of), map_(*map) {}

  Status ReadPlain() {
    const PolygonSoup& mesh = map_.mesh;
    if (mesh.first_corner != of_.soup.first_corner) {
      return Status::InvalidInput(fmt::format("{} faces, not the {} of the mesh in their order",
                                              mesh.num_polygons(), of_.soup.num_polygons()));
    }
    const Surface& surface = of_.surface;
    for (std::size_t h = 0; h < surface.soup_corner.size(); ++h) {
      const Index corner = surface.soup_corner[h];
      const Index there = of_.soup.corner[corner];
      if (mesh.position[mesh.corner[corner]] != of_.soup.position[there]) {
        return Status::InvalidInput(
            fmt::format("vertex {} of the mesh is elsewhere in it", there + 1));
      }
      if (h % 3 == 0) AddTriangle(static_cast<Index>(h / 3), surface.soup_polygon[h / 3]);
      AddCorner(corner, Eigen::Vector3d::Unit(static_cast<Eigen::Index>(h % 3)));
    }
    return CheckTexture();
  }

  Status ReadExact(const std::vector<Index>& group) {
    const Index polygons = of_.soup.num_polygons();
    std::vector<Index> faces;  // of the surface, those that are of polygons
    for (Index f = 0; f < of_.surface.triangulation.num_faces(); ++f) {
      if (of_.surface.soup_polygon[f] != kNone) faces.push_back(f);
    }
    const Buckets in_polygon = SortIntoBuckets(of_.surface.soup_polygon, polygons, faces);
    for (Index p = 0; p < map_.mesh.num_polygons(); ++p) {
      if (group[p] < 0 || group[p] >= polygons) {
        return Status::InvalidInput(
            fmt::format("a group face_{}: the mesh has {} faces", group[p] + 1, polygons));
      }
      const Index first = map_.mesh.first_corner[p];
      if (map_.mesh.first_corner[p + 1] != first + 3) {
        return Status::InvalidInput("a face that is no triangle, which no exact map has");
      }
      AddPiece(p, first, in_polygon, group[p]);
    }
    return CheckTexture();
  }

 private:
  void AddTriangle(Index face, Index polygon) {
    map_.triangles.face.push_back(face);
    map_.polygon.push_back(polygon);
  }

  void AddCorner(Index corner, const Eigen::Vector3d& on_face) {
    const PolygonSoup& mesh = map_.mesh;
    const Index uv = mesh.corner_texture.empty() ? kNone : mesh.corner_texture[corner];
    has_texture_ = has_texture_ && uv != kNone;
    map_.triangles.uv.push_back(uv == kNone ? Eigen::Vector2d(0, 0) : mesh.texture[uv]);
    map_.triangles.on_face.push_back(on_face);
    map_.vertex.push_back(mesh.corner[corner]);
  }

  /// In that of the polygon's triangles which has its middle farthest inside.
  void AddPiece(Index piece, Index first, const Buckets& in_polygon, Index polygon) {
    const auto at = [&](Index c) { return map_.mesh.position[map_.mesh.corner[c]]; };
    const Point middle = (at(first) + at(first + 1) + at(first + 2)) / 3;
    double inside = -std::numeric_limits<double>::infinity();
    Index best = kNone;
    for (Index i = in_polygon.first[polygon]; i < in_polygon.first[polygon + 1]; ++i) {
      const double least = InFace(in_polygon.item[i], middle).minCoeff();
      if (!(least > inside)) continue;
      inside = least;
      best = in_polygon.item[i];
    }
    if (best == kNone) return;  // a face without area, which is none of the surface's
    AddTriangle(best, piece);
    for (Index c = first; c < first + 3; ++c) {
      const Eigen::Vector3d weight = InFace(best, at(c)).cwiseMax(0.0);
      AddCorner(c, weight / weight.sum());
    }
  }

  Eigen::Vector3d InFace(Index face, const Point& p) const {
    const Index* v = &of_.surface.triangulation.vertex[3 * face];
    const auto& position = of_.surface.position;
    return Barycentric(position[v[0]], position[v[1]], position[v[2]], p);
  }

  Status CheckTexture() const {
    if (has_texture_ && !map_.triangles.face.empty()) return Status();
    return Status::InvalidInput("a map has texture coordinates at every corner; these do not");
  }

  const MeshOfMaps& of_;
  MapFile& map_;
  bool has_texture_ = true;
};

}  // namespace

StatusOr<MeshOfMaps> ReadSurface(const std::string& path) {
  StatusOr<PolygonSoup> soup = ReadMesh(path);
  if (!soup.ok()) return soup.status();
  MeshParts parts;
  if (Status s = TakeApart(*soup, MeshOptions().repair, &parts); !s.ok()) return s.In(path);
  const std::vector<const Surface*> surfaces = parts.Surfaces();
  if (surfaces.empty()) return parts.components[0].surface.status().In(path);
  return MeshOfMaps{*std::move(soup), Joined(surfaces)};
}

StatusOr<MapFile> ReadMap(const std::string& path, const MeshOfMaps& of) {
  StatusOr<MeshFile> file = ReadMeshFile(path);
  if (!file.ok()) return file.status();
  MapFile map;
  map.mesh = std::move(file->soup);
  map.is_exact = file->text.find(kFirstGroup) != std::string::npos;
  Status status;
  if (map.is_exact) {
    const StatusOr<std::vector<Index>> groups = verify::ReadGroups(file->text);
    if (!groups.ok()) return groups.status().In(path);
    status = MapReader(of, &map).ReadExact(*groups);
  } else {
    status = MapReader(of, &map).ReadPlain();
  }
  if (!status.ok()) return status.In(path);
  return map;
}

}  // namespace cirque
