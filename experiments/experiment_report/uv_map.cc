#include "experiments/experiment_report/uv_map.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

#include "cirque/io/io.h"
#include "cirque/mesh/preflight.h"

namespace cirque::experiment_report {
namespace {

constexpr double kLeastCone = 1e-4;  // [rad] off 2 pi: what uvs in a file can tell from rounding

/// The uv of each corner. Preflight keeps the order of the polygons and of their corners up to
/// turning around, so a corner is found by its vertex.
StatusOr<CornerUv> CornerUvs(const PolygonSoup& soup, const Surface& surface) {
  CornerUv uv;
  const Triangulation& mesh = surface.triangulation;
  for (Index h = 0; h < mesh.num_halfedges(); ++h) {
    const Index polygon = surface.soup_polygon[Triangulation::Face(h)];
    const auto first = soup.corner.begin() + soup.first_corner[polygon];
    const auto last = soup.corner.begin() + soup.first_corner[polygon + 1];
    const auto found = std::find(first, last, surface.soup_vertex[mesh.vertex[h]]);
    const std::size_t corner = found - soup.corner.begin();
    if (found == last || corner >= soup.corner_texture.size() ||
        soup.corner_texture[corner] == kNone) {
      return Status::InvalidInput("has corners without vt");
    }
    uv.value.push_back(soup.texture[soup.corner_texture[corner]]);
  }
  return uv;
}

/// Points are numbered as the corners meet them, so that neighbours have near numbers.
void FindPoints(UvMap* map) {
  std::map<std::tuple<Index, double, double>, Index> known;
  const Triangulation& mesh = map->surface.triangulation;
  for (Index h = 0; h < mesh.num_halfedges(); ++h) {
    const Eigen::Vector2d& uv = map->uv.value[h];
    const auto [found, is_new] = known.try_emplace({mesh.vertex[h], uv.x(), uv.y()},
                                                   static_cast<Index>(map->point_uv.size()));
    if (is_new) {
      map->point_vertex.push_back(mesh.vertex[h]);
      map->point_uv.push_back(uv);
    }
    map->point.push_back(found->second);
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

void FindCones(UvMap* map) {
  const Triangulation& mesh = map->surface.triangulation;
  std::vector<double> sum(mesh.num_vertices);
  for (Index h = 0; h < mesh.num_halfedges(); ++h) sum[mesh.vertex[h]] += AngleAt(map->uv, h);
  const std::vector<bool> on_boundary = BoundaryVertices(mesh);
  for (Index v = 0; v < mesh.num_vertices; ++v) {
    if (!on_boundary[v] && std::abs(sum[v] - 2 * kPi) > kLeastCone) {
      map->cones.emplace_back(v, sum[v]);
    }
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
  UvMap map;
  map.surface = *std::move(surface);
  map.uv = *std::move(uv);
  FindPoints(&map);
  FindEdges(&map);
  FindCones(&map);
  return map;
}

}  // namespace cirque::experiment_report
