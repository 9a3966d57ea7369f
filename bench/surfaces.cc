#include "bench/surfaces.h"

#include <map>
#include <memory>
#include <utility>

#include <glog/logging.h>

#include "cirque/generators/generators.h"
#include "cirque/mesh/preflight.h"

namespace cirque {
namespace {

constexpr double kStretch = 4;

std::unique_ptr<const Surface> SurfaceOf(const PolygonSoup& soup) {
  PreflightReport report;
  StatusOr<Surface> surface = Preflight(soup, &report);
  CHECK(surface.ok()) << surface.status().message();
  return std::make_unique<const Surface>(*std::move(surface));
}

PolygonSoup Generated(const std::string& generator, int triangles) {
  StatusOr<PolygonSoup> soup = GenerateMesh(generator, {triangles, 1});
  CHECK(soup.ok()) << soup.status().message();
  return *std::move(soup);
}

}  // namespace

const Surface& BenchSurface(const std::string& generator, int triangles) {
  static std::map<std::pair<std::string, int>, std::unique_ptr<const Surface>> cache;
  auto& surface = cache[{generator, triangles}];
  if (!surface) surface = SurfaceOf(Generated(generator, triangles));
  return *surface;
}

const Surface& StretchedTerrain(int triangles) {
  static std::map<int, std::unique_ptr<const Surface>> cache;
  auto& surface = cache[triangles];
  if (!surface) {
    PolygonSoup soup = Generated("bumpy_terrain", triangles);
    for (Eigen::Vector3d& point : soup.position) point.x() *= kStretch;
    surface = SurfaceOf(soup);
  }
  return *surface;
}

}  // namespace cirque
