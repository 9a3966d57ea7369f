#include "tests/common/surfaces.h"

#include <cmath>

#include <glog/logging.h>

#include "cirque/mesh/corner_angles.h"
#include "cirque/mesh/generators.h"
#include "cirque/mesh/preflight.h"

namespace cirque {
namespace {

Surface MustBeSurface(const PolygonSoup& soup) {
  PreflightReport report;
  StatusOr<Surface> surface = Preflight(soup, &report);
  CHECK(surface.ok()) << surface.status().message();
  return *std::move(surface);
}

void AddTriangle(PolygonSoup* soup, Index a, Index b, Index c) {
  soup->corner.insert(soup->corner.end(), {a, b, c});
  soup->first_corner.push_back(static_cast<Index>(soup->corner.size()));
}

}  // namespace

Surface GeneratedSurface(const std::string& generator, Index triangles, unsigned seed) {
  return MustBeSurface((*MeshGenerators().Find(generator))({triangles, seed}));
}

Surface Fan(int n, double height) {
  PolygonSoup soup;
  soup.position.emplace_back(0, 0, height);
  for (int i = 0; i < n; ++i) {
    soup.position.emplace_back(std::cos(2 * kPi * i / n), std::sin(2 * kPi * i / n), 0);
    AddTriangle(&soup, 0, 1 + i, 1 + (i + 1) % n);
  }
  return MustBeSurface(soup);
}

Surface FlatStrip(int columns, int rows) {
  PolygonSoup soup;
  for (int j = 0; j <= rows; ++j) {
    for (int i = 0; i <= columns; ++i) soup.position.emplace_back(i, j, 0);
  }
  for (int j = 0; j < rows; ++j) {
    for (int i = 0; i < columns; ++i) {
      const Index a = j * (columns + 1) + i, b = a + 1, c = b + columns + 1, d = c - 1;
      const bool rising = (i + j) % 2 == 0;
      AddTriangle(&soup, a, b, rising ? c : d);
      AddTriangle(&soup, rising ? a : b, c, d);
    }
  }
  return MustBeSurface(soup);
}

Surface Kleetope(const Surface& surface) {
  PolygonSoup soup;
  soup.position = surface.position;
  const Triangulation& t = surface.triangulation;
  for (Index f = 0; f < t.num_faces(); ++f) {
    const Index a = t.vertex[3 * f], b = t.vertex[3 * f + 1], c = t.vertex[3 * f + 2];
    const auto apex = static_cast<Index>(soup.position.size());
    soup.position.emplace_back((soup.position[a] + soup.position[b] + soup.position[c]) / 3);
    AddTriangle(&soup, a, b, apex);
    AddTriangle(&soup, b, c, apex);
    AddTriangle(&soup, c, a, apex);
  }
  return MustBeSurface(soup);
}

CornerAngles AnglesOf(const Surface& surface) {
  return MeasureCornerAngles(surface.triangulation, MeasureEdgeLengths(surface));
}

}  // namespace cirque
