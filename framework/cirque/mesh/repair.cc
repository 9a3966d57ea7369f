#include "cirque/mesh/repair.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <numeric>
#include <set>
#include <utility>

#include <Eigen/Geometry>

#include "cirque/core/grouping.h"
#include "cirque/mesh/assembly.h"

namespace cirque {
namespace {

/// The soup as triangles glued along their edges.
struct GluedSoup {
  TriangleSoup triangles;
  Gluing gluing;
};

GluedSoup Glue(const PolygonSoup& soup, BadFaces* bad) {
  GluedSoup glued;
  glued.triangles = SplitIntoTriangles(soup, bad);
  glued.gluing = GlueEdges(glued.triangles.vertex, static_cast<Index>(soup.position.size()),
                           glued.triangles.mate);
  return glued;
}

/// Points no further apart than a distance, found by a grid of that width.
class NearPoints {
 public:
  NearPoints(const std::vector<Eigen::Vector3d>& points, double distance)
      : points_(points), distance_(distance) {}

  /// Unites the point with those known within the distance, and makes it known.
  void Unite(Index v, DisjointSets* sets) {
    const Cell at = CellOf(points_[v]);
    for (std::int64_t i = at[0] - 1; i <= at[0] + 1; ++i) {
      for (std::int64_t j = at[1] - 1; j <= at[1] + 1; ++j) {
        for (std::int64_t k = at[2] - 1; k <= at[2] + 1; ++k) UniteIn({i, j, k}, v, sets);
      }
    }
    cells_[at].push_back(v);
  }

 private:
  using Cell = std::array<std::int64_t, 3>;

  Cell CellOf(const Eigen::Vector3d& p) const {
    Cell cell;
    for (int i = 0; i < 3; ++i) {
      cell[i] = std::llround(std::floor((p[i] - points_.front()[i]) / distance_));
    }
    return cell;
  }

  void UniteIn(const Cell& cell, Index v, DisjointSets* sets) {
    const auto found = cells_.find(cell);
    if (found == cells_.end()) return;
    for (const Index w : found->second) {
      if ((points_[v] - points_[w]).norm() <= distance_) sets->Unite(v, w);
    }
  }

  const std::vector<Eigen::Vector3d>& points_;
  double distance_;
  std::map<Cell, std::vector<Index>> cells_;
};

double Diagonal(const std::vector<Eigen::Vector3d>& points) {
  Eigen::AlignedBox3d box;
  for (const Eigen::Vector3d& p : points) box.extend(p);
  return box.isEmpty() ? 0 : box.diagonal().stableNorm();
}

/// Makes the boundary vertices that lie together one, the first of them.
class Welder {
 public:
  Welder(const PolygonSoup& soup, double tolerance)
      : soup_(soup), distance_(tolerance * Diagonal(soup.position)) {}

  /// For every vertex that which it becomes.
  std::vector<Index> Representatives() const {
    const std::vector<bool> boundary = OnBoundary();
    const auto n = static_cast<Index>(boundary.size());
    DisjointSets sets(n);
    if (distance_ > 0) {
      NearPoints near(soup_.position, distance_);
      for (Index v = 0; v < n; ++v) {
        if (boundary[v]) near.Unite(v, &sets);
      }
    } else {
      const std::vector<Index> equal = FirstOfEqualPoints(soup_.position);
      std::vector<Index> first_on_boundary(n, kNone);
      for (Index v = 0; v < n; ++v) {
        if (!boundary[v]) continue;
        Index& first = first_on_boundary[equal[v]];
        if (first == kNone) first = v;
        sets.Unite(first, v);
      }
    }
    std::vector<Index> first(n);
    for (Index v = 0; v < n; ++v) first[v] = sets.Find(v);
    return first;
  }

 private:
  std::vector<bool> OnBoundary() const {
    BadFaces bad;
    const GluedSoup glued = Glue(soup_, &bad);
    std::vector<bool> boundary(soup_.position.size(), false);
    for (Index h = 0; h < static_cast<Index>(glued.triangles.vertex.size()); ++h) {
      if (!glued.gluing.on_boundary[h]) continue;
      boundary[glued.triangles.vertex[Triangulation::Next(h)]] = true;
      boundary[glued.triangles.vertex[Triangulation::Prev(h)]] = true;
    }
    return boundary;
  }

  const PolygonSoup& soup_;
  double distance_;
};

/// Renumbers the soup's corners; returns the vertices that have become another.
std::vector<Index> Weld(double tolerance, PolygonSoup* soup) {
  const std::vector<Index> first = Welder(*soup, tolerance).Representatives();
  std::vector<Index> welded;
  for (Index v = 0; v < static_cast<Index>(first.size()); ++v) {
    if (first[v] != v) welded.push_back(v);
  }
  for (Index& v : soup->corner) v = first[v];
  return welded;
}

/// Keeps those polygons of a repaired soup that `keep` says.
void KeepPolygons(const std::vector<bool>& keep, RepairedSoup* repaired) {
  PolygonSoup& soup = repaired->soup;
  std::vector<Index> first_corner = {0}, corner, of_polygon, of_corner;
  for (Index p = 0; p < soup.num_polygons(); ++p) {
    if (!keep[p]) continue;
    for (Index c = soup.first_corner[p]; c < soup.first_corner[p + 1]; ++c) {
      corner.push_back(soup.corner[c]);
      of_corner.push_back(repaired->corner[c]);
    }
    first_corner.push_back(static_cast<Index>(corner.size()));
    of_polygon.push_back(repaired->polygon[p]);
  }
  soup.first_corner = std::move(first_corner);
  soup.corner = std::move(corner);
  repaired->polygon = std::move(of_polygon);
  repaired->corner = std::move(of_corner);
}

/// The soup as it is, without texture.
RepairedSoup Untouched(const PolygonSoup& soup) {
  RepairedSoup repaired;
  repaired.soup.position = soup.position;
  repaired.soup.first_corner = soup.first_corner;
  repaired.soup.corner = soup.corner;
  repaired.vertex.resize(soup.position.size());
  repaired.polygon.resize(soup.num_polygons());
  repaired.corner.resize(soup.corner.size());
  for (std::vector<Index>* ids : {&repaired.vertex, &repaired.polygon, &repaired.corner}) {
    std::iota(ids->begin(), ids->end(), 0);
  }
  return repaired;
}

/// The corners of a polygon without those that repeat the vertex of the one before.
std::vector<Index> DifferentCorners(const PolygonSoup& soup, Index p) {
  std::vector<Index> kept;
  for (Index c = soup.first_corner[p]; c < soup.first_corner[p + 1]; ++c) {
    if (kept.empty() || soup.corner[kept.back()] != soup.corner[c]) kept.push_back(c);
  }
  while (kept.size() > 1 && soup.corner[kept.back()] == soup.corner[kept.front()]) {
    kept.pop_back();
  }
  return kept;
}

/// Leaves out corners that repeat the vertex of the one before, and polygons that keep fewer than
/// three.
void TrimPolygons(RepairedSoup* repaired, RepairSummary* summary) {
  RepairedSoup trimmed;
  for (Index p = 0; p < repaired->soup.num_polygons(); ++p) {
    const std::vector<Index> kept = DifferentCorners(repaired->soup, p);
    if (kept.size() < 3) {
      summary->repeated_vertex_faces.push_back(repaired->polygon[p]);
      continue;
    }
    for (const Index c : kept) {
      trimmed.soup.corner.push_back(repaired->soup.corner[c]);
      trimmed.corner.push_back(repaired->corner[c]);
    }
    trimmed.soup.first_corner.push_back(static_cast<Index>(trimmed.corner.size()));
    trimmed.polygon.push_back(repaired->polygon[p]);
  }
  repaired->soup.corner = std::move(trimmed.soup.corner);
  repaired->soup.first_corner = std::move(trimmed.soup.first_corner);
  repaired->corner = std::move(trimmed.corner);
  repaired->polygon = std::move(trimmed.polygon);
}

/// Sets aside the polygons that cannot be split into triangles with an area.
void SetBadFacesAside(RepairedSoup* repaired, RepairSummary* summary) {
  BadFaces bad;
  SplitIntoTriangles(repaired->soup, &bad);
  std::vector<bool> keep(repaired->polygon.size(), true);
  for (const auto& [faces, list] :
       {std::pair(&bad.repeated_vertex, &summary->repeated_vertex_faces),
        std::pair(&bad.zero_area, &summary->zero_area_faces)}) {
    for (const Index p : *faces) {
      keep[p] = false;
      list->push_back(repaired->polygon[p]);
    }
  }
  KeepPolygons(keep, repaired);
}

/// A polygon's vertices, increasing.
std::vector<Index> SortedVertices(const PolygonSoup& soup, Index p) {
  std::vector<Index> vertices(soup.corner.begin() + soup.first_corner[p],
                              soup.corner.begin() + soup.first_corner[p + 1]);
  std::sort(vertices.begin(), vertices.end());
  return vertices;
}

/// Sets aside the polygons at an edge of more than two faces that have the vertices of an earlier
/// one there.
void SetDuplicatesAside(RepairedSoup* repaired, RepairSummary* summary) {
  BadFaces bad;
  const GluedSoup glued = Glue(repaired->soup, &bad);
  if (glued.gluing.non_manifold_edges.empty()) return;
  std::vector<bool> crowded(repaired->polygon.size(), false);
  for (std::size_t h = 0; h < glued.triangles.vertex.size(); ++h) {
    if (glued.gluing.mate[h] == kNone && !glued.gluing.on_boundary[h]) {
      crowded[glued.triangles.polygon[h / 3]] = true;
    }
  }
  std::set<std::vector<Index>> known;
  std::vector<bool> keep(repaired->polygon.size(), true);
  for (Index p = 0; p < static_cast<Index>(keep.size()); ++p) {
    if (!crowded[p]) continue;
    keep[p] = known.insert(SortedVertices(repaired->soup, p)).second;
    if (!keep[p]) summary->duplicate_faces.push_back(repaired->polygon[p]);
  }
  KeepPolygons(keep, repaired);
}

/// Gives every fan of corners a vertex of its own; that of its first corner keeps the number.
void SplitFans(RepairedSoup* repaired, RepairSummary* summary) {
  PolygonSoup& soup = repaired->soup;
  BadFaces bad;
  const GluedSoup glued = Glue(soup, &bad);
  for (const auto& [a, b] : glued.gluing.non_manifold_edges) {
    summary->split_edges.emplace_back(std::minmax({repaired->vertex[a], repaired->vertex[b]}));
  }
  const std::vector<Index> fan = CornerFans(glued.triangles.vertex, glued.gluing);
  std::vector<Index> vertex_of_fan(fan.size(), kNone);
  std::vector<bool> taken(soup.position.size(), false);
  for (std::size_t h = 0; h < fan.size(); ++h) {
    Index& vertex = vertex_of_fan[fan[h]];
    if (vertex == kNone) {
      vertex = glued.triangles.vertex[h];
      if (taken[vertex]) {
        summary->split_vertices.push_back(repaired->vertex[vertex]);
        soup.position.push_back(Eigen::Vector3d(soup.position[vertex]));
        repaired->vertex.push_back(Index(repaired->vertex[vertex]));
        vertex = static_cast<Index>(soup.position.size()) - 1;
      } else {
        taken[vertex] = true;
      }
    }
    soup.corner[glued.triangles.corner[h]] = vertex;
  }
}

template <class T>
void SortAndUnique(std::vector<T>* list) {
  std::sort(list->begin(), list->end());
  list->erase(std::unique(list->begin(), list->end()), list->end());
}

}  // namespace

RepairedSoup RepairSoup(const PolygonSoup& soup, const RepairOptions& options,
                        RepairSummary* summary) {
  RepairedSoup repaired = Untouched(soup);
  TrimPolygons(&repaired, summary);
  SetBadFacesAside(&repaired, summary);
  if (options.mode == RepairMode::kWeld) {
    // Faces of no area are gone by now, so that the two sides of such a face are welded too.
    summary->welded_vertices = Weld(options.tolerance, &repaired.soup);
    TrimPolygons(&repaired, summary);
    SetBadFacesAside(&repaired, summary);
  }
  SetDuplicatesAside(&repaired, summary);
  SplitFans(&repaired, summary);
  for (std::vector<Index>* ids :
       {&summary->zero_area_faces, &summary->repeated_vertex_faces, &summary->split_vertices}) {
    SortAndUnique(ids);
  }
  SortAndUnique(&summary->split_edges);
  return repaired;
}

}  // namespace cirque
