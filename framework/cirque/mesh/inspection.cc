#include "cirque/mesh/inspection.h"

#include <algorithm>
#include <utility>

#include <glog/logging.h>

#include "cirque/core/grouping.h"
#include "cirque/core/parallel.h"

namespace cirque {
namespace {

std::vector<bool> UsedVertices(const PolygonSoup& soup) {
  std::vector<bool> used(soup.position.size(), false);
  for (const Index v : soup.corner) used[v] = true;
  return used;
}

void InspectVertices(const PolygonSoup& soup, PreflightReport* report) {
  const Index num_vertices = static_cast<Index>(soup.position.size());
  report->non_finite_at = soup.not_finite_at;
  const std::vector<bool> used = UsedVertices(soup);
  const std::vector<Index> first = FirstOfEqualPoints(soup.position);
  for (Index v = 0; v < num_vertices; ++v) {
    if (!soup.position[v].allFinite()) report->non_finite_vertices.push_back(v);
    if (!used[v]) report->isolated_vertices.push_back(v);
    if (first[v] != v) report->duplicate_vertices.push_back(v);
  }
}

/// The vertices whose corners fall into more than one fan.
std::vector<Index> NonManifoldVertices(const std::vector<Index>& triangles,
                                       const std::vector<Index>& fan, Index num_vertices) {
  std::vector<Index> fans(num_vertices, 0);
  for (std::size_t h = 0; h < fan.size(); ++h) {
    if (fan[h] == static_cast<Index>(h)) ++fans[triangles[h]];
  }
  std::vector<Index> bad;
  for (Index v = 0; v < num_vertices; ++v) {
    if (fans[v] > 1) bad.push_back(v);
  }
  return bad;
}

/// The polygons of every component, each component by its vertices, in the order of their first
/// polygons.
std::vector<std::vector<Index>> CollectComponents(const PolygonSoup& soup) {
  DisjointSets sets(static_cast<Index>(soup.position.size()));
  for (Index p = 0; p < soup.num_polygons(); ++p) {
    for (Index c = soup.first_corner[p] + 1; c < soup.first_corner[p + 1]; ++c) {
      sets.Unite(soup.corner[c - 1], soup.corner[c]);
    }
  }
  std::vector<Index> component_of(soup.position.size(), kNone);
  std::vector<std::vector<Index>> components;
  for (Index p = 0; p < soup.num_polygons(); ++p) {
    Index& component = component_of[sets.Find(soup.corner[soup.first_corner[p]])];
    if (component == kNone) {
      component = static_cast<Index>(components.size());
      components.emplace_back();
    }
    components[component].push_back(p);
  }
  return components;
}

/// V - E + F = 2 components - 2 genus - loops; a one-sided surface has crosscaps instead of two
/// sides a handle.
Index Genus(const PreflightReport& report, std::size_t used_vertices) {
  if (!report.non_manifold_edges.empty() || !report.non_manifold_vertices.empty() ||
      !report.repeated_vertex_faces.empty()) {
    return kNone;
  }
  const Index euler = static_cast<Index>(used_vertices) - report.num_edges + report.num_triangles;
  const Index crosscaps = 2 * report.components - report.boundary_loops - euler;
  return report.orientable ? crosscaps / 2 : crosscaps;
}

void InspectConnectivity(const PolygonSoup& soup, const Assembly& assembly,
                         PreflightReport* report) {
  const std::vector<Index>& triangles = assembly.triangles.vertex;
  const std::vector<Index> fan = CornerFans(triangles, assembly.gluing);
  report->num_triangles = static_cast<Index>(triangles.size() / 3);
  report->num_edges = assembly.gluing.num_edges;
  report->non_manifold_edges = assembly.gluing.non_manifold_edges;
  report->non_manifold_vertices = NonManifoldVertices(triangles, fan, report->num_vertices);
  report->boundary_loops = CountBoundaryLoops(fan, assembly.gluing);
  report->orientable = assembly.orientation.one_sided.empty();
  for (std::size_t f = 0; report->orientable && f < assembly.orientation.turn.size(); ++f) {
    if (assembly.orientation.turn[f]) {
      report->reoriented_faces.push_back(assembly.triangles.polygon[f]);
    }
  }
  std::vector<Index>& turned = report->reoriented_faces;
  turned.erase(std::unique(turned.begin(), turned.end()), turned.end());
  report->genus = Genus(*report, soup.position.size() - report->isolated_vertices.size());
}

void CheckIsSoup(const PolygonSoup& soup) {
  const Index num_vertices = static_cast<Index>(soup.position.size());
  CHECK(!soup.first_corner.empty());
  CHECK_EQ(soup.first_corner.back(), static_cast<Index>(soup.corner.size()));
  for (const Index v : soup.corner) CHECK(v >= 0 && v < num_vertices);
  for (Index p = 0; p < soup.num_polygons(); ++p) {
    CHECK_GE(soup.first_corner[p + 1] - soup.first_corner[p], 3);
  }
}

}  // namespace

Inspected Inspect(const PolygonSoup& soup, PreflightReport* report) {
  CheckIsSoup(soup);
  *report = {};
  report->num_vertices = static_cast<Index>(soup.position.size());
  report->num_polygons = soup.num_polygons();
  Inspected inspected;
  BackgroundTask inspection(soup.num_polygons(), [&] {
    InspectVertices(soup, report);
    inspected.components = CollectComponents(soup);
  });
  Assembly& assembly = inspected.assembly;
  BadFaces bad;
  assembly.triangles = SplitIntoTriangles(soup, &bad);
  report->repeated_vertex_faces = std::move(bad.repeated_vertex);
  report->zero_area_faces = std::move(bad.zero_area);
  assembly.gluing =
      GlueEdges(assembly.triangles.vertex, report->num_vertices, assembly.triangles.mate);
  assembly.orientation = OrientTriangles(assembly.triangles.vertex, assembly.gluing);
  inspection.Wait();
  report->components = static_cast<Index>(inspected.components.size());
  InspectConnectivity(soup, assembly, report);
  return inspected;
}

std::vector<OneSided> FindOneSided(const Assembly& assembly) {
  std::vector<OneSided> found;
  for (const Index h : assembly.orientation.one_sided) {
    found.push_back({Triangulation::Face(h),
                     {assembly.triangles.vertex[Triangulation::Next(h)],
                      assembly.triangles.vertex[Triangulation::Prev(h)]}});
  }
  return found;
}

Surface BuildSurface(const PolygonSoup& soup, Assembly assembly) {
  TurnTriangles(assembly.orientation.turn, &assembly.triangles, &assembly.gluing.mate);
  Surface surface;
  std::vector<Index> surface_vertex(soup.position.size(), kNone);
  const std::vector<bool> used = UsedVertices(soup);
  for (std::size_t v = 0; v < used.size(); ++v) {
    if (!used[v]) continue;
    surface_vertex[v] = static_cast<Index>(surface.position.size());
    surface.position.push_back(soup.position[v]);
    surface.soup_vertex.push_back(static_cast<Index>(v));
  }
  for (Index& v : assembly.triangles.vertex) v = surface_vertex[v];
  surface.soup_polygon = std::move(assembly.triangles.polygon);
  surface.soup_corner = std::move(assembly.triangles.corner);
  surface.triangulation =
      NumberEdges(static_cast<Index>(surface.position.size()), std::move(assembly.triangles.vertex),
                  std::move(assembly.gluing.mate));
  return surface;
}

}  // namespace cirque
