#include "experiments/common/map_view/uv_map.h"

#include <cmath>
#include <utility>

#include "cirque/io/io.h"
#include "cirque/mesh/preflight.h"
#include "cirque/metrics/mapped_faces.h"

namespace cirque {
namespace {

// What uvs in a file can tell from rounding:
constexpr double kLeastCone = 1e-4;      ///< [rad] off 2 pi
constexpr double kLeastMismatch = 1e-4;  ///< of a seam's sides, over their lengths together

/// The uv of each corner.
StatusOr<CornerUv> CornerUvs(const PolygonSoup& soup, const Surface& surface) {
  CornerUv uv;
  for (const Index corner : surface.soup_corner) {
    if (soup.corner_texture.empty() || soup.corner_texture[corner] == kNone) {
      return Status::InvalidInput("has corners without vt");
    }
    uv.value.push_back(soup.texture[soup.corner_texture[corner]]);
  }
  return uv;
}

/// Points are numbered as the corners meet them, so that neighbours have near numbers.
void FindPoints(UvMap* map) {
  const Triangulation& mesh = map->surface.triangulation;
  std::vector<Index> latest(mesh.num_vertices, kNone), before;  // the points of a vertex as a list
  map->point.reserve(mesh.num_halfedges());
  for (Index h = 0; h < mesh.num_halfedges(); ++h) {
    const Index vertex = mesh.vertex[h];
    Index point = latest[vertex];
    while (point != kNone && map->point_uv[point] != map->uv.value[h]) point = before[point];
    if (point == kNone) {
      point = static_cast<Index>(map->point_uv.size());
      before.push_back(latest[vertex]);
      latest[vertex] = point;
      map->point_vertex.push_back(vertex);
      map->point_uv.push_back(map->uv.value[h]);
    }
    map->point.push_back(point);
  }
}

void FindEdges(UvMap* map) {
  const Triangulation& mesh = map->surface.triangulation;
  for (Index h = 0; h < mesh.num_halfedges(); ++h) {
    const Index twin = mesh.twin[h];
    if (twin == kNone) {
      map->boundary.push_back(h);
    } else if (map->point[Triangulation::Next(h)] != map->point[Triangulation::Prev(twin)] ||
               map->point[Triangulation::Prev(h)] != map->point[Triangulation::Next(twin)]) {
      map->seams.push_back(h);
    }
  }
}

double AngleAt(const CornerUv& uv, Index h) {
  const Eigen::Vector2d a = uv.value[Triangulation::Next(h)] - uv.value[h];
  const Eigen::Vector2d b = uv.value[Triangulation::Prev(h)] - uv.value[h];
  return std::atan2(a.x() * b.y() - a.y() * b.x(), a.dot(b));
}

/// Of the image's edge opposite corner h.
double LengthOpposite(const CornerUv& uv, Index h) {
  return (uv.value[Triangulation::Prev(h)] - uv.value[Triangulation::Next(h)]).norm();
}

/// The vertices on seams whose sides differ in length: nothing flat is glued there, and angles that do
/// not add up to 2 pi make no cone.
std::vector<bool> OnFreeSeams(const UvMap& map) {
  const Triangulation& mesh = map.surface.triangulation;
  std::vector<bool> on_free_seam(mesh.num_vertices, false);
  for (const Index h : map.seams) {
    const double one = LengthOpposite(map.uv, h), other = LengthOpposite(map.uv, mesh.twin[h]);
    if (std::abs(one - other) <= kLeastMismatch * (one + other)) continue;
    on_free_seam[mesh.Tail(h)] = on_free_seam[mesh.Tip(h)] = true;
  }
  return on_free_seam;
}

void FindCones(UvMap* map) {
  const Triangulation& mesh = map->surface.triangulation;
  std::vector<double> sum(mesh.num_vertices);
  for (Index h = 0; h < mesh.num_halfedges(); ++h) sum[mesh.vertex[h]] += AngleAt(map->uv, h);
  const std::vector<bool> on_boundary = BoundaryVertices(mesh);
  const std::vector<bool> on_free_seam = OnFreeSeams(*map);
  for (Index v = 0; v < mesh.num_vertices; ++v) {
    if (on_boundary[v] || on_free_seam[v]) continue;
    if (std::abs(sum[v] - 2 * kPi) > kLeastCone) map->cones.emplace_back(v, sum[v]);
  }
}

}  // namespace

StatusOr<UvMap> ReadUvMap(const std::string& path) {
  const StatusOr<PolygonSoup> soup = ReadMesh(path);
  if (!soup.ok()) return soup.status();
  PreflightReport report;
  StatusOr<Surface> surface = Preflight(*soup, &report);
  if (!surface.ok()) return surface.status().In(path);
  StatusOr<CornerUv> uv = CornerUvs(*soup, *surface);
  if (!uv.ok()) return uv.status().In(path);
  return MakeUvMap(*std::move(surface), *std::move(uv));
}

UvMap MakeUvMap(Surface surface, CornerUv uv) {
  UvMap map;
  map.surface = std::move(surface);
  map.uv = std::move(uv);
  FindPoints(&map);
  FindEdges(&map);
  FindCones(&map);
  return map;
}

UvMap MakeSphereMap(Surface surface, const std::vector<Eigen::Vector3d>& position) {
  UvMap map;
  map.surface = std::move(surface);
  const Triangulation& mesh = map.surface.triangulation;
  map.uv = FacesInPlane(MeasureSurface(mesh, ChordLengths(mesh, position)));
  map.point = mesh.vertex;
  for (Index v = 0; v < mesh.num_vertices; ++v) map.point_vertex.push_back(v);
  map.on_sphere = position;
  return map;
}

}  // namespace cirque
