#include "cirque/verify/topology.h"

#include <algorithm>
#include <iterator>
#include <numeric>
#include <tuple>
#include <utility>

#include <fmt/format.h>

#include "cirque/core/count.h"
#include "cirque/core/grouping.h"
#include "cirque/verify/polygon_check.h"

namespace cirque::verify {
namespace {

/// A halfedge under the name of its undirected edge: its vertices and, of a diagonal, its face and
/// where its ends are among the corners of that.
struct EdgeUse {
  Index low, high, inside = kNone, low_place = kNone, high_place = kNone, halfedge = kNone;

  auto Edge() const { return std::tie(low, high, inside, low_place, high_place); }
  bool SameEdge(const EdgeUse& other) const { return Edge() == other.Edge(); }
  bool operator<(const EdgeUse& other) const {
    return SameEdge(other) ? halfedge < other.halfedge : Edge() < other.Edge();
  }
};

std::vector<EdgeUse> SortedEdgeUses(const TriangleMesh& mesh) {
  std::vector<EdgeUse> uses(mesh.vertex.size());
  for (Index h = 0; h < static_cast<Index>(uses.size()); ++h) {
    const auto [low, high] = std::minmax({mesh.Tail(h), mesh.Tip(h)});
    uses[h] = {low, high};
    uses[h].halfedge = h;
    if (!mesh.diagonal[h]) continue;
    uses[h].inside = mesh.face[h / 3];
    std::tie(uses[h].low_place, uses[h].high_place) =
        std::minmax({mesh.place[h], mesh.place[TriangleMesh::Next(h)]});
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
          fmt::format("face {} has {}; 3 or more are needed", p, Count(end - begin, "corner")));
    }
    for (Index c = begin; c < end; ++c) {
      if (soup.corner[c] >= 0 && soup.corner[c] < num_vertices) continue;
      return Status::InvalidInput(fmt::format("face {} names vertex {}, but there are only {}", p,
                                              soup.corner[c], num_vertices));
    }
  }
  return {};
}

void DropRepeatedCorners(const std::function<bool(const FaceCorner&, const FaceCorner&)>& same,
                         std::vector<FaceCorner>* corners) {
  const auto repeats = [&](const FaceCorner& a, const FaceCorner& b) {
    return a.vertex == b.vertex && same(a, b);
  };
  const std::size_t before = corners->size();
  corners->erase(std::unique(corners->begin(), corners->end(), repeats), corners->end());
  while (corners->size() > 1 && repeats(corners->back(), corners->front())) corners->pop_back();
  if (corners->size() == before) return;
  for (std::size_t k = 0; k < corners->size(); ++k) (*corners)[k].place = static_cast<int>(k);
}

void AddTriangles(Index face, int num_corners, const std::vector<FaceCorner>& corners,
                  const std::vector<int>& triangles, TriangleMesh* mesh) {
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    const FaceCorner& corner = corners[triangles[i]];
    const FaceCorner& next = corners[triangles[i % 3 == 2 ? i - 2 : i + 1]];
    mesh->vertex.push_back(corner.vertex);
    mesh->soup_corner.push_back(corner.soup_corner);
    mesh->place.push_back(corner.place);
    mesh->diagonal.push_back(next.place != (corner.place + 1) % num_corners);
    if (i % 3 == 0) mesh->face.push_back(face);
  }
}

namespace {

/// Triangles of a polygon without a repeated vertex in any: ears, the first that will do. Where none
/// will, what is left is cut into a fan.
std::vector<int> CutWithoutRepeats(const std::vector<FaceCorner>& corners) {
  std::vector<int> triangles, left(corners.size());
  std::iota(left.begin(), left.end(), 0);
  const auto vertex = [&](std::size_t k) { return corners[left[k % left.size()]].vertex; };
  while (left.size() > 3) {
    std::size_t k = 0;
    const auto fits = [&] {
      return vertex(k) != vertex(k + 1) && vertex(k + 1) != vertex(k + 2) &&
             vertex(k) != vertex(k + 2);
    };
    while (k < left.size() && !fits()) ++k;
    if (k == left.size()) k = 0;
    const std::size_t tip = (k + 1) % left.size();
    triangles.insert(triangles.end(), {left[k], left[tip], left[(k + 2) % left.size()]});
    left.erase(left.begin() + static_cast<std::ptrdiff_t>(tip));
  }
  triangles.insert(triangles.end(), left.begin(), left.end());
  return triangles;
}

bool RepeatsVertex(const std::vector<FaceCorner>& corners) {
  std::vector<Index> vertices;
  for (const FaceCorner& corner : corners) vertices.push_back(corner.vertex);
  std::sort(vertices.begin(), vertices.end());
  return std::adjacent_find(vertices.begin(), vertices.end()) != vertices.end();
}

}  // namespace

StatusOr<TriangleMesh> FanTriangulate(const PolygonSoup& soup, const std::vector<bool>* keep) {
  Status faces = CheckFaces(soup);
  if (!faces.ok()) return faces;
  TriangleMesh mesh;
  mesh.num_vertices = static_cast<Index>(soup.position.size());
  std::vector<FaceCorner> corners;
  for (Index p = 0; p < soup.num_polygons(); ++p) {
    if (keep && !(*keep)[p]) continue;
    corners.clear();
    for (Index c = soup.first_corner[p]; c < soup.first_corner[p + 1]; ++c) {
      corners.push_back({soup.corner[c], c, static_cast<int>(corners.size())});
    }
    DropRepeatedCorners([](const FaceCorner&, const FaceCorner&) { return true; }, &corners);
    if (corners.size() < 3) {
      return Status::InvalidInput(fmt::format("face {} has vertex {} twice; remove it", p,
                                              soup.corner[soup.first_corner[p]]));
    }
    const auto n = static_cast<int>(corners.size());
    AddTriangles(p, n, corners, RepeatsVertex(corners) ? CutWithoutRepeats(corners) : CutFan(n),
                 &mesh);
  }
  return mesh;
}

StatusOr<std::vector<Index>> PairHalfedges(const TriangleMesh& mesh, Joints joints) {
  std::vector<Index> twin(mesh.vertex.size(), kNone);
  const std::vector<EdgeUse> uses = SortedEdgeUses(mesh);
  for (std::size_t i = 0; i < uses.size();) {
    std::size_t j = i;
    while (j < uses.size() && uses[j].SameEdge(uses[i])) ++j;
    if (uses[i].low == uses[i].high) {
      return Status::InvalidInput(fmt::format("face {} has vertex {} twice; remove it",
                                              mesh.face[uses[i].halfedge / 3], uses[i].low));
    }
    if (j - i > 2 && joints == Joints::kRefuse) {
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
    std::swap(mesh->place[3 * f + 1], mesh->place[3 * f + 2]);
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

void SplitFans(const std::vector<Index>& twin, TriangleMesh* mesh) {
  DisjointSets fans(static_cast<Index>(twin.size()));
  for (Index h = 0; h < static_cast<Index>(twin.size()); ++h) {
    if (twin[h] == kNone) continue;
    fans.Unite(h, TriangleMesh::Next(twin[h]));
    fans.Unite(TriangleMesh::Next(h), twin[h]);
  }
  std::vector<Index> vertex_of(twin.size(), kNone);  // per first corner of a fan
  std::vector<bool> taken(mesh->num_vertices, false);
  if (mesh->origin.empty()) {
    mesh->origin.resize(mesh->num_vertices);
    std::iota(mesh->origin.begin(), mesh->origin.end(), 0);
  }
  for (Index c = 0; c < static_cast<Index>(twin.size()); ++c) {
    Index& v = vertex_of[fans.Find(c)];
    if (v == kNone) {
      v = mesh->vertex[c];
      if (taken[v]) {
        mesh->origin.push_back(Index(mesh->origin[v]));
        v = mesh->num_vertices++;
      } else {
        taken[v] = true;
      }
    }
    mesh->vertex[c] = v;
  }
}

namespace {

/// Pairs and orients; `turned` is what runs the other way than it did at first.
StatusOr<std::vector<Index>> Glue(Joints joints, TriangleMesh* mesh, std::vector<Index>* turned) {
  StatusOr<std::vector<Index>> twin = PairHalfedges(*mesh, joints);
  if (!twin.ok()) return twin.status();
  const StatusOr<std::vector<Index>> now = OrientConsistently(*twin, mesh);
  if (!now.ok()) return now.status();
  if (now->empty()) return twin;
  std::vector<Index> both;
  std::set_symmetric_difference(turned->begin(), turned->end(), now->begin(), now->end(),
                                std::back_inserter(both));
  *turned = std::move(both);
  return PairHalfedges(*mesh, joints);
}

}  // namespace

StatusOr<Surface> BuildSurface(TriangleMesh mesh, Joints joints) {
  std::vector<Index> turned;
  StatusOr<std::vector<Index>> twin = Glue(joints, &mesh, &turned);
  if (!twin.ok()) return twin.status();
  if (joints == Joints::kOpen) {
    SplitFans(*twin, &mesh);
    twin = Glue(joints, &mesh, &turned);
    if (!twin.ok()) return twin.status();
  } else if (Status fans = CheckOneFanPerVertex(mesh, *twin); !fans.ok()) {
    return fans;
  }
  return Surface{std::move(mesh), *std::move(twin), std::move(turned)};
}

}  // namespace cirque::verify
