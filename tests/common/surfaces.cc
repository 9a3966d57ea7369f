#include "tests/common/surfaces.h"

#include <cmath>
#include <filesystem>
#include <utility>

#include <Eigen/Geometry>
#include <glog/logging.h>

#include "cirque/generators/generators.h"
#include "cirque/intrinsic/intrinsic_surface.h"
#include "cirque/io/io.h"

#include "tests/common/paths.h"

namespace cirque {
namespace {

Surface MustBeSurface(const PolygonSoup& soup, PreflightReport* report) {
  StatusOr<Surface> surface = Preflight(soup, report);
  CHECK(surface.ok()) << surface.status().message();
  return *std::move(surface);
}

void AddTriangle(PolygonSoup* soup, Index a, Index b, Index c) {
  soup->corner.insert(soup->corner.end(), {a, b, c});
  soup->first_corner.push_back(static_cast<Index>(soup->corner.size()));
}

}  // namespace

Surface SurfaceOf(const PolygonSoup& soup) {
  PreflightReport report;
  return MustBeSurface(soup, &report);
}

std::optional<SharedSurface> ReadSharedSurface(const std::string& name) {
  const std::string path = ProjectPath("../shared/meshes/" + name + ".obj");
  if (!std::filesystem::exists(path)) return std::nullopt;
  const StatusOr<PolygonSoup> soup = ReadMesh(path);
  CHECK(soup.ok()) << soup.status().message();
  SharedSurface mesh{*soup, {}, {}};
  mesh.surface = MustBeSurface(mesh.soup, &mesh.report);
  return mesh;
}

Surface GeneratedSurface(const std::string& generator, Index triangles, unsigned seed) {
  return SurfaceOf((*MeshGenerators().Find(generator))({triangles, seed}));
}

Surface Fan(int n, double height) {
  PolygonSoup soup;
  soup.position.emplace_back(0, 0, height);
  for (int i = 0; i < n; ++i) {
    soup.position.emplace_back(std::cos(2 * kPi * i / n), std::sin(2 * kPi * i / n), 0);
    AddTriangle(&soup, 0, 1 + i, 1 + (i + 1) % n);
  }
  return SurfaceOf(soup);
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
  return SurfaceOf(soup);
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
  return SurfaceOf(soup);
}

Surface RegularPolyhedron(int num_faces) {
  const double golden = (1 + std::sqrt(5.0)) / 2;
  PolygonSoup soup;
  if (num_faces == 4) soup.position = {{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}};
  for (const double s : {-1., 1.}) {
    for (int k = 0; k < 3; ++k) {
      if (num_faces == 8) soup.position.emplace_back(s * Eigen::Vector3d::Unit(k));
      for (const double t : {-golden, golden}) {
        Eigen::Vector3d x = Eigen::Vector3d::Zero();
        x[k] = s;
        x[(k + 1) % 3] = t;
        if (num_faces == 20) soup.position.push_back(x);
      }
    }
  }
  for (Eigen::Vector3d& x : soup.position) x.normalize();
  // The faces are the triples at the least distance.
  const double side = num_faces == 4 ? std::sqrt(8. / 3) : num_faces == 8 ? std::sqrt(2.) : 1.0515;
  const auto adjacent = [&](Index a, Index b) {
    return std::abs((soup.position[a] - soup.position[b]).norm() - side) < 1e-3;
  };
  const auto count = static_cast<Index>(soup.position.size());
  for (Index a = 0; a < count; ++a) {
    for (Index b = a + 1; b < count; ++b) {
      for (Index c = b + 1; c < count; ++c) {
        if (!adjacent(a, b) || !adjacent(b, c) || !adjacent(a, c)) continue;
        const auto& p = soup.position;
        const bool outward = p[a].dot((p[b] - p[a]).cross(p[c] - p[a])) > 0;
        AddTriangle(&soup, a, outward ? b : c, outward ? c : b);
      }
    }
  }
  return SurfaceOf(soup);
}

Triangulation WithFoldedFace(const Triangulation& t, Index h) {
  const Index g = t.twin[h], a = t.Tail(h), b = t.Tip(h);
  CHECK_NE(g, kNone);
  const Index first = t.num_halfedges(), folded = first + 3;
  std::vector<Index> vertex = t.vertex, twin = t.twin;
  vertex.insert(vertex.end(), {a, b, a, t.num_vertices, a, a});
  twin.insert(twin.end(), {h, folded, g, first + 1, folded + 2, folded + 1});
  twin[h] = first;
  twin[g] = first + 2;
  return NumberEdges(t.num_vertices + 1, std::move(vertex), std::move(twin));
}

CornerAngles AnglesOf(const Surface& surface) {
  return MeasureCornerAngles(surface.triangulation, MeasureEdgeLengths(surface));
}

PolygonSoup Together(const std::vector<PolygonSoup>& parts) {
  PolygonSoup all;
  for (const PolygonSoup& part : parts) {
    const auto first = static_cast<Index>(all.position.size());
    const Eigen::Vector3d shift(10. * all.num_polygons(), 0, 0);
    for (const Eigen::Vector3d& p : part.position) all.position.push_back(p + shift);
    for (Index p = 0; p < part.num_polygons(); ++p) {
      for (Index c = part.first_corner[p]; c < part.first_corner[p + 1]; ++c) {
        all.corner.push_back(first + part.corner[c]);
      }
      all.first_corner.push_back(static_cast<Index>(all.corner.size()));
    }
  }
  return all;
}

Surface TwoLimbs(int rings) {
  constexpr int kSides = 12;
  PolygonSoup soup;
  for (int ring = 0; ring < rings; ++ring) {
    for (int i = 0; i < kSides; ++i) {
      soup.position.emplace_back(std::cos(2 * kPi * i / kSides), std::sin(2 * kPi * i / kSides),
                                 0.5 * ring);
    }
  }
  const Index bottom = rings * kSides, top = bottom + 1;
  soup.position.emplace_back(0, 0, -0.5);
  soup.position.emplace_back(0, 0, 0.5 * rings);
  const auto add = [&](Index a, Index b, Index c) {
    soup.corner.insert(soup.corner.end(), {a, b, c});
    soup.first_corner.push_back(static_cast<Index>(soup.corner.size()));
  };
  for (int ring = 0; ring + 1 < rings; ++ring) {
    for (int i = 0; i < kSides; ++i) {
      const Index a = ring * kSides + i, b = ring * kSides + (i + 1) % kSides;
      if (ring != rings / 2 || i != 0) add(a, b, a + kSides);
      add(b, b + kSides, a + kSides);
    }
  }
  for (int i = 0; i < kSides; ++i) {
    const Index last = (rings - 1) * kSides, j = (i + 1) % kSides;
    add(j, i, bottom);
    add(last + i, last + j, top);
  }
  return SurfaceOf(soup);
}

PolygonSoup UncleanMesh() {
  const PolygonSoup terrain = *GenerateMesh("bumpy_terrain", {100, 1});
  PolygonSoup mesh = Together({terrain, *GenerateMesh("sphere", {200, 1})});
  const auto add = [&](Index a, Index b, Index c) {
    mesh.corner.insert(mesh.corner.end(), {a, b, c});
    mesh.first_corner.push_back(static_cast<Index>(mesh.corner.size()));
  };
  const Index of_sphere = 3 * terrain.num_polygons();
  for (const Index c : {Index{0}, of_sphere}) {
    add(mesh.corner[c], mesh.corner[c + 1], mesh.corner[c + 2]);
  }
  const Surface surface = SurfaceOf(terrain);
  const Triangulation& t = surface.triangulation;
  const std::vector<bool> boundary = BoundaryVertices(t);
  for (const Index h : t.edge_halfedge) {
    if (boundary[t.Tail(h)] || boundary[t.Tip(h)]) continue;
    const auto top = static_cast<Index>(mesh.position.size());
    mesh.position.push_back(mesh.position[t.Tail(h)] + Eigen::Vector3d(0, 0, 1));
    add(t.Tail(h), t.Tip(h), top);
    break;
  }
  return mesh;
}

}  // namespace cirque
