#include "cirque/verify/topology.h"

#include <algorithm>
#include <tuple>
#include <utility>

#include <fmt/format.h>

#include "cirque/verify/polygon_check.h"

namespace cirque::verify {
namespace {

/// A halfedge under the name of its undirected edge: its vertices and, of a diagonal, its face.
struct EdgeUse {
  Index low, high, inside, halfedge;

  bool SameEdge(const EdgeUse& other) const {
    return low == other.low && high == other.high && inside == other.inside;
  }
  bool operator<(const EdgeUse& other) const {
    return std::tie(low, high, inside, halfedge) <
           std::tie(other.low, other.high, other.inside, other.halfedge);
  }
};

std::vector<EdgeUse> SortedEdgeUses(const TriangleMesh& mesh) {
  std::vector<EdgeUse> uses(mesh.vertex.size());
  for (Index h = 0; h < static_cast<Index>(uses.size()); ++h) {
    const auto [low, high] = std::minmax({mesh.Tail(h), mesh.Tip(h)});
    uses[h] = {low, high, mesh.diagonal[h] ? mesh.face[h / 3] : kNone, h};
  }
  std::sort(uses.begin(), uses.end());
  return uses;
}

/// For every triangle of the component of `seed` whether it runs against the seed; `against` holds
/// -1 where nobody has been.
Status SpreadOrientation(const TriangleMesh& mesh, const std::vector<Index>& twin, Index seed,
                         std::vector<signed char>* against, std::vector<Index>* component) {
  component->assign(1, seed);
  (*against)[seed] = 0;
  for (std::size_t i = 0; i < component->size(); ++i) {
    const Index f = (*component)[i];
    for (Index h = 3 * f; h < 3 * f + 3; ++h) {
      if (twin[h] == kNone) continue;
      const Index g = twin[h] / 3;
      const bool disagree = mesh.Tail(h) == mesh.Tail(twin[h]);
      const auto wanted = static_cast<signed char>((*against)[f] != 0 ? !disagree : disagree);
      if ((*against)[g] < 0) {
        (*against)[g] = wanted;
        component->push_back(g);
      } else if ((*against)[g] != wanted) {
        return Status::InvalidInput(fmt::format(
            "the surface is not orientable: going round from face {} to its neighbour {} comes "
            "back reversed; cut it along such a loop first",
            mesh.face[f], mesh.face[g]));
      }
    }
  }
  return {};
}

}  // namespace

Status CheckFaces(const PolygonSoup& soup) {
  const auto num_vertices = static_cast<Index>(soup.position.size());
  for (Index p = 0; p < soup.num_polygons(); ++p) {
    const Index begin = soup.first_corner[p], end = soup.first_corner[p + 1];
    if (end - begin < 3) {
      return Status::InvalidInput(
          fmt::format("face {} has {} corners; 3 or more are needed", p, end - begin));
    }
    for (Index c = begin; c < end; ++c) {
      if (soup.corner[c] >= 0 && soup.corner[c] < num_vertices) continue;
      return Status::InvalidInput(fmt::format("face {} names vertex {}, but there are only {}", p,
                                              soup.corner[c], num_vertices));
    }
  }
  return {};
}

namespace {

Status CheckVerticesOnce(const PolygonSoup& soup) {
  std::vector<Index> last_face(soup.position.size(), kNone);
  for (Index p = 0; p < soup.num_polygons(); ++p) {
    for (Index c = soup.first_corner[p]; c < soup.first_corner[p + 1]; ++c) {
      if (std::exchange(last_face[soup.corner[c]], p) != p) continue;
      return Status::InvalidInput(
          fmt::format("face {} has vertex {} twice; remove it", p, soup.corner[c]));
    }
  }
  return {};
}

}  // namespace

void AddTriangles(Index face, int num_corners, const std::vector<FaceCorner>& corners,
                  const std::vector<int>& triangles, TriangleMesh* mesh) {
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    const FaceCorner& corner = corners[triangles[i]];
    const FaceCorner& next = corners[triangles[i % 3 == 2 ? i - 2 : i + 1]];
    mesh->vertex.push_back(corner.vertex);
    mesh->soup_corner.push_back(corner.soup_corner);
    mesh->diagonal.push_back(next.place != (corner.place + 1) % num_corners);
    if (i % 3 == 0) mesh->face.push_back(face);
  }
}

StatusOr<TriangleMesh> FanTriangulate(const PolygonSoup& soup) {
  Status faces = CheckFaces(soup);
  if (faces.ok()) faces = CheckVerticesOnce(soup);
  if (!faces.ok()) return faces;
  TriangleMesh mesh;
  mesh.num_vertices = static_cast<Index>(soup.position.size());
  std::vector<FaceCorner> corners;
  for (Index p = 0; p < soup.num_polygons(); ++p) {
    corners.clear();
    for (Index c = soup.first_corner[p]; c < soup.first_corner[p + 1]; ++c) {
      corners.push_back({soup.corner[c], c, static_cast<int>(corners.size())});
    }
    const auto n = static_cast<int>(corners.size());
    AddTriangles(p, n, corners, CutFan(n), &mesh);
  }
  return mesh;
}

StatusOr<std::vector<Index>> PairHalfedges(const TriangleMesh& mesh) {
  std::vector<Index> twin(mesh.vertex.size(), kNone);
  const std::vector<EdgeUse> uses = SortedEdgeUses(mesh);
  for (std::size_t i = 0; i < uses.size();) {
    std::size_t j = i;
    while (j < uses.size() && uses[j].SameEdge(uses[i])) ++j;
    if (uses[i].low == uses[i].high) {
      return Status::InvalidInput(fmt::format("face {} has vertex {} twice; remove it",
                                              mesh.face[uses[i].halfedge / 3], uses[i].low));
    }
    if (j - i > 2) {
      return Status::InvalidInput(
          fmt::format("edge ({}, {}) has {} faces ({}, {}, {}, ...): not a surface; separate its "
                      "sheets first",
                      uses[i].low, uses[i].high, j - i, mesh.face[uses[i].halfedge / 3],
                      mesh.face[uses[i + 1].halfedge / 3], mesh.face[uses[i + 2].halfedge / 3]));
    }
    if (j - i == 2) {
      twin[uses[i].halfedge] = uses[i + 1].halfedge;
      twin[uses[i + 1].halfedge] = uses[i].halfedge;
    }
    i = j;
  }
  return twin;
}

StatusOr<std::vector<Index>> OrientConsistently(const std::vector<Index>& twin,
                                                TriangleMesh* mesh) {
  std::vector<signed char> against(mesh->num_triangles(), -1);
  std::vector<Index> turned, component;
  for (Index seed = 0; seed < mesh->num_triangles(); ++seed) {
    if (against[seed] >= 0) continue;
    const Status status = SpreadOrientation(*mesh, twin, seed, &against, &component);
    if (!status.ok()) return status;
    const auto minority =
        std::count_if(component.begin(), component.end(), [&](Index f) { return against[f] == 1; });
    const bool turn_these = 2 * minority <= static_cast<std::ptrdiff_t>(component.size());
    for (const Index f : component) {
      if ((against[f] == 1) == turn_these) turned.push_back(f);
    }
  }
  std::sort(turned.begin(), turned.end());
  for (const Index f : turned) {
    std::swap(mesh->vertex[3 * f + 1], mesh->vertex[3 * f + 2]);
    std::swap(mesh->soup_corner[3 * f + 1], mesh->soup_corner[3 * f + 2]);
    std::swap(mesh->diagonal[3 * f], mesh->diagonal[3 * f + 2]);
  }
  return turned;
}

Status CheckOneFanPerVertex(const TriangleMesh& mesh, const std::vector<Index>& twin) {
  std::vector<bool> corner_seen(mesh.vertex.size(), false), vertex_seen(mesh.num_vertices, false);
  for (Index start = 0; start < static_cast<Index>(mesh.vertex.size()); ++start) {
    if (corner_seen[start]) continue;
    const Index v = mesh.vertex[start];
    if (vertex_seen[v]) {
      return Status::InvalidInput(
          fmt::format("vertex {} joins several fans of faces (one holds face {}): not a surface; "
                      "split the vertex first",
                      v, mesh.face[start / 3]));
    }
    vertex_seen[v] = true;
    Index c = start;
    do {  // counterclockwise
      corner_seen[c] = true;
      c = twin[TriangleMesh::Prev(c)];
    } while (c != kNone && c != start);
    if (c == start) continue;
    for (c = start; twin[c] != kNone; corner_seen[c] = true) c = TriangleMesh::Next(twin[c]);
  }
  return {};
}

StatusOr<Surface> BuildSurface(TriangleMesh mesh) {
  StatusOr<std::vector<Index>> twin = PairHalfedges(mesh);
  if (!twin.ok()) return twin.status();
  StatusOr<std::vector<Index>> turned = OrientConsistently(*twin, &mesh);
  if (!turned.ok()) return turned.status();
  if (!turned->empty()) twin = PairHalfedges(mesh);
  Status fans = CheckOneFanPerVertex(mesh, *twin);
  if (!fans.ok()) return fans;
  return Surface{std::move(mesh), *std::move(twin), *std::move(turned)};
}

}  // namespace cirque::verify
