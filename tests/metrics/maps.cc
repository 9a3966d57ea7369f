#include "tests/metrics/maps.h"

#include <algorithm>
#include <map>
#include <utility>

namespace cirque {
namespace {

using Eigen::Vector2d;

void AddTriangle(PolygonSoup* soup, Index a, Index b, Index c) {
  soup->corner.insert(soup->corner.end(), {a, b, c});
  soup->first_corner.push_back(static_cast<Index>(soup->corner.size()));
}

}  // namespace

TestMap MapOf(const Surface& surface, const PlaneMap& map) {
  TestMap result{surface.triangulation, MeasureEdgeLengths(surface), {}};
  for (const Index v : surface.triangulation.vertex) {
    result.uv.value.push_back(map(surface.position[v]));
  }
  return result;
}

TestMap DroppedToPlane(const Surface& surface) {
  return MapOf(surface, [](const Eigen::Vector3d& p) { return Vector2d(p.x(), p.y()); });
}

TestMap Subdivided(const Surface& surface, const CornerUv& uv) {
  const Triangulation& t = surface.triangulation;
  PolygonSoup soup;
  soup.position = surface.position;
  TestMap result;
  for (Index e = 0; e < t.num_edges(); ++e) {
    const Index h = t.edge_halfedge[e];
    soup.position.emplace_back((surface.position[t.Tail(h)] + surface.position[t.Tip(h)]) / 2);
  }
  for (Index f = 0; f < t.num_faces(); ++f) {
    std::array<Index, 6> vertex;  // the corners, then the midpoints opposite them
    std::array<Vector2d, 6> image;
    for (Index k = 0; k < 3; ++k) {
      const Index h = 3 * f + k;
      vertex[k] = t.vertex[h];
      vertex[3 + k] = t.num_vertices + t.edge[h];
      image[k] = uv.value[h];
      image[3 + k] = (uv.value[Triangulation::Next(h)] + uv.value[Triangulation::Prev(h)]) / 2;
    }
    for (const auto& [a, b, c] : {std::array{0, 5, 4}, {5, 1, 3}, {4, 3, 2}, {3, 4, 5}}) {
      AddTriangle(&soup, vertex[a], vertex[b], vertex[c]);
      result.uv.value.insert(result.uv.value.end(), {image[a], image[b], image[c]});
    }
  }
  const Surface fine = SurfaceOf(soup);
  result.triangulation = fine.triangulation;
  result.lengths = MeasureEdgeLengths(fine);
  return result;
}

Surface Grid(int columns, int rows) {
  PolygonSoup soup;
  for (int j = 0; j <= rows; ++j) {
    for (int i = 0; i <= columns; ++i) soup.position.emplace_back(i, j, 0);
  }
  for (int j = 0; j < rows; ++j) {
    for (int i = 0; i < columns; ++i) {
      const Index a = j * (columns + 1) + i, b = a + 1, d = a + columns + 1, c = d + 1;
      AddTriangle(&soup, a, b, c);
      AddTriangle(&soup, a, c, d);
    }
  }
  return SurfaceOf(soup);
}

TestMap LooseTriangles(const std::vector<std::array<Vector2d, 3>>& sources,
                       const std::vector<std::array<Vector2d, 3>>& images) {
  const auto corners = static_cast<Index>(3 * sources.size());
  std::vector<Index> vertex(corners);
  for (Index h = 0; h < corners; ++h) vertex[h] = h;
  TestMap map;
  map.triangulation = NumberEdges(corners, vertex, std::vector<Index>(corners, kNone));
  map.lengths.value.resize(corners);
  for (Index h = 0; h < corners; ++h) {
    const auto& triangle = sources[h / 3];
    const Index edge = map.triangulation.edge[h];
    map.lengths.value[edge] = (triangle[(h + 2) % 3] - triangle[(h + 1) % 3]).norm();
    map.uv.value.push_back(images[h / 3][h % 3]);
  }
  return map;
}

}  // namespace cirque
