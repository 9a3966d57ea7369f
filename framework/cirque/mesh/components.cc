// preflight.h: a mesh as one surface, or taken apart into its components.
#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "cirque/core/grouping.h"
#include "cirque/mesh/boundary_contacts.h"
#include "cirque/mesh/inspection.h"
#include "cirque/mesh/preflight.h"
#include "cirque/mesh/repair.h"

namespace cirque {
namespace {

bool IsManifold(const PreflightReport& report) {
  return report.repeated_vertex_faces.empty() && report.zero_area_faces.empty() &&
         report.non_manifold_edges.empty() && report.non_manifold_vertices.empty();
}

/// What the mode does not let be repaired.
Status CheckRepairable(const PreflightReport& report, RepairMode mode) {
  PreflightReport hopeless = report;
  hopeless.components = 1;  // any number will do
  hopeless.orientable = true;
  if (mode != RepairMode::kNothing) {
    hopeless.repeated_vertex_faces = hopeless.zero_area_faces = hopeless.non_manifold_vertices = {};
    hopeless.non_manifold_edges = {};
  }
  const std::string problems = DescribeProblems(hopeless, {}, {kNone, kNone});
  return problems.empty() ? Status() : Status::InvalidInput(problems);
}

/// The numbers of the soup that was repaired instead of those of the repaired one.
void NumberAsBefore(const RepairedSoup& repaired, Surface* surface) {
  for (Index& v : surface->soup_vertex) v = repaired.vertex[v];
  for (Index& p : surface->soup_polygon) p = repaired.polygon[p];
  for (Index& c : surface->soup_corner) c = repaired.corner[c];
}

/// The boundary edges by their vertices in the soup, each once.
BoundaryEdges BoundaryOf(const Surface& surface) {
  const Triangulation& t = surface.triangulation;
  BoundaryEdges edges;
  for (Index h = 0; h < t.num_halfedges(); ++h) {
    if (t.twin[h] != kNone) continue;
    edges.emplace_back(
        std::minmax({surface.soup_vertex[t.Tail(h)], surface.soup_vertex[t.Tip(h)]}));
  }
  std::sort(edges.begin(), edges.end());
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  return edges;
}

/// Takes connected parts out of a surface, one after the other.
class ComponentCutter {
 public:
  explicit ComponentCutter(const Surface& whole)
      : whole_(whole), number_(whole.position.size(), kNone) {}

  /// The part that has these faces, all of it.
  MeshComponent Cut(const Index* first_face, const Index* last_face) {
    Surface part;
    std::vector<Index> vertices, vertex, twin;
    for (const Index* f = first_face; f != last_face; ++f) {
      for (Index h = 3 * *f; h < 3 * *f + 3; ++h)
        vertices.push_back(whole_.triangulation.vertex[h]);
    }
    std::sort(vertices.begin(), vertices.end());
    vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
    for (std::size_t v = 0; v < vertices.size(); ++v) {
      number_[vertices[v]] = static_cast<Index>(v);
      part.position.push_back(whole_.position[vertices[v]]);
      part.soup_vertex.push_back(whole_.soup_vertex[vertices[v]]);
    }
    MeshComponent component{Status(), whole_.soup_polygon[*first_face], 0};
    for (const Index* f = first_face; f != last_face; ++f) {
      const Index polygon = whole_.soup_polygon[*f];
      if (part.soup_polygon.empty() || part.soup_polygon.back() != polygon) {
        ++component.num_polygons;
      }
      part.soup_polygon.push_back(polygon);
      for (Index h = 3 * *f; h < 3 * *f + 3; ++h) {
        const Index g = whole_.triangulation.twin[h];
        vertex.push_back(number_[whole_.triangulation.vertex[h]]);
        part.soup_corner.push_back(whole_.soup_corner[h]);
        twin.push_back(g == kNone ? kNone : 3 * PlaceOf(g / 3, first_face, last_face) + g % 3);
      }
    }
    part.triangulation =
        NumberEdges(static_cast<Index>(vertices.size()), std::move(vertex), std::move(twin));
    component.surface = std::move(part);
    return component;
  }

 private:
  static Index PlaceOf(Index face, const Index* first, const Index* last) {
    return static_cast<Index>(std::lower_bound(first, last, face) - first);
  }

  const Surface& whole_;
  std::vector<Index> number_;
};

/// The connected parts of a surface, those with the faces given refused as one-sided.
std::vector<MeshComponent> SplitIntoComponents(Surface whole,
                                               const std::vector<OneSided>& one_sided) {
  const Patches patches = ConnectedPatches(whole.triangulation);
  std::vector<MeshComponent> components;
  if (patches.count == 1) {
    components.push_back({Status(), whole.soup_polygon.front(), 1});
    for (std::size_t f = 1; f < whole.soup_polygon.size(); ++f) {
      if (whole.soup_polygon[f] != whole.soup_polygon[f - 1]) ++components[0].num_polygons;
    }
    components[0].surface = std::move(whole);
  } else {
    const Buckets faces = SortIntoBuckets(patches.of_face, patches.count);
    ComponentCutter cutter(whole);
    for (Index i = 0; i < patches.count; ++i) {
      components.push_back(
          cutter.Cut(&faces.item[faces.first[i]], faces.item.data() + faces.first[i + 1]));
    }
  }
  for (const auto& [face, edge] : one_sided) {
    components[patches.of_face[face]].surface = Status::InvalidInput(DescribeOneSided(edge));
  }
  return components;
}

}  // namespace

StatusOr<std::vector<MeshComponent>> SurfacesOf(const PolygonSoup& soup,
                                                const RepairOptions& repair,
                                                PreflightReport* report, RepairSummary* summary) {
  *summary = {};
  Inspected inspected = Inspect(soup, report);
  if (Status s = CheckRepairable(*report, repair.mode); !s.ok()) return s;
  RepairedSoup repaired;
  const bool repairs = !IsManifold(*report) || repair.mode == RepairMode::kWeld;
  if (repairs) {
    repaired = RepairSoup(soup, repair, summary);
    if (repaired.polygon.empty()) {
      return Status::InvalidInput("no face has an area; check the coordinates");
    }
    PreflightReport mended;
    inspected = Inspect(repaired.soup, &mended);
    if (Status s = CheckRepairable(mended, RepairMode::kNothing); !s.ok()) return s;
  }
  std::vector<OneSided> one_sided = FindOneSided(inspected.assembly);
  Surface whole = BuildSurface(repairs ? repaired.soup : soup, std::move(inspected.assembly));
  if (repairs) {
    NumberAsBefore(repaired, &whole);
    for (OneSided& found : one_sided) {
      found.edge = {repaired.vertex[found.edge.first], repaired.vertex[found.edge.second]};
    }
  }
  const BoundaryEdges boundary = BoundaryOf(whole);
  summary->t_junctions = FindTJunctions(soup.position, boundary);
  if (!report->duplicate_vertices.empty()) {
    summary->coincident_edges = CountCoincidentEdges(soup.position, boundary);
  }
  return SplitIntoComponents(std::move(whole), one_sided);
}

StatusOr<Surface> Preflight(const PolygonSoup& soup, PreflightReport* report) {
  Inspected inspected = Inspect(soup, report);
  const std::vector<OneSided> one_sided = FindOneSided(inspected.assembly);
  const std::string problems =
      DescribeProblems(*report, inspected.components,
                       one_sided.empty() ? std::pair(kNone, kNone) : one_sided.front().edge);
  if (!problems.empty()) return Status::InvalidInput(problems);
  return BuildSurface(soup, std::move(inspected.assembly));
}

StatusOr<Surface> SurfaceFromTriangles(const std::vector<Eigen::Vector3d>& points,
                                       const std::vector<std::array<Index, 3>>& triangles) {
  PolygonSoup soup;
  soup.position = points;
  for (const auto& triangle : triangles) {
    for (const Index v : triangle) {
      if (v >= 0 && v < static_cast<Index>(points.size())) continue;
      return Status::InvalidInput(
          fmt::format("triangle {} has a corner {}; there are {} points, counted from 0",
                      soup.num_polygons(), v, points.size()));
    }
    soup.corner.insert(soup.corner.end(), triangle.begin(), triangle.end());
    soup.first_corner.push_back(static_cast<Index>(soup.corner.size()));
  }
  PreflightReport report;
  return Preflight(soup, &report);
}

}  // namespace cirque
