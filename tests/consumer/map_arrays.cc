// Maps a surface given as two arrays to the unit disk, and prints where its vertices go.
#include <array>
#include <cstdio>
#include <vector>

#include "cirque/cirque.h"

int main() {
  // A tent: six points around a seventh above them.
  const std::vector<Eigen::Vector3d> points = {{2, 0, 0},   {1, 2, 0},  {-1, 2, 0}, {-2, 0, 0},
                                               {-1, -2, 0}, {1, -2, 0}, {0, 0, 1}};
  const std::vector<std::array<cirque::Index, 3>> triangles = {{0, 1, 6}, {1, 2, 6}, {2, 3, 6},
                                                               {3, 4, 6}, {4, 5, 6}, {5, 0, 6}};
  const auto surface = cirque::SurfaceFromTriangles(points, triangles);
  if (!surface.ok()) return std::puts(surface.status().message().c_str()), 1;

  cirque::MapRequest request;
  request.domain = "disk";
  request.shape.centre = 6;
  const auto map = cirque::MapSurface(*surface, request);
  if (!map.ok()) return std::puts(map.status().message().c_str()), 2;

  int on_the_circle = 0;
  for (std::size_t corner = 0; corner < map->uv.value.size(); ++corner) {
    const Eigen::Vector2d& uv = map->uv.value[corner];
    std::printf("vertex %d: %.6f %.6f\n", surface->triangulation.vertex[corner], uv.x(), uv.y());
    on_the_circle += std::abs(uv.norm() - 1) < 1e-12;
  }
  std::puts(map->certificate.ToJson().c_str());
  return on_the_circle == 12 ? 0 : 3;  // two corners at each point of the boundary
}
