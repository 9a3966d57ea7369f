#include "cirque/mesh/assembly.h"

#include <algorithm>
#include <limits>
#include <span>
#include <tuple>
#include <utility>

#include <Eigen/Geometry>

#include "cirque/core/grouping.h"
#include "cirque/core/parallel.h"
#include "cirque/core/triangulation.h"

namespace cirque {
namespace {

using Corners = std::span<const Index>;

constexpr std::size_t kNoApex = std::numeric_limits<std::size_t>::max();

Corners CornersOf(const PolygonSoup& soup, Index p) {
  return Corners(soup.corner)
      .subspan(soup.first_corner[p], soup.first_corner[p + 1] - soup.first_corner[p]);
}

bool RepeatsVertex(Corners corners) {
  if (corners.size() == 3) {
    return corners[0] == corners[1] || corners[1] == corners[2] || corners[2] == corners[0];
  }
  std::vector<Index> sorted(corners.size());
  std::copy(corners.begin(), corners.end(), sorted.begin());
  std::sort(sorted.begin(), sorted.end());
  return std::adjacent_find(sorted.begin(), sorted.end()) != sorted.end();
}

bool HasZeroAreaInFan(const PolygonSoup& soup, Corners corners, std::size_t apex) {
  const std::size_t size = corners.size();
  const auto point = [&](std::size_t i) { return soup.position[corners[(apex + i) % size]]; };
  for (std::size_t i = 1; i + 1 < size; ++i) {
    if (IsZeroArea(point(0), point(i), point(i + 1))) return true;
  }
  return false;
}

/// The first corner whose fan has no triangle of zero area; the number of corners when there is
/// none.
std::size_t FindApex(const PolygonSoup& soup, Corners corners) {
  const auto finite = [&](Index v) { return soup.position[v].allFinite(); };
  if (!std::all_of(corners.begin(), corners.end(), finite)) return 0;
  // A triangle has only one fan.
  const std::size_t last = corners.size() == 3 ? 1 : corners.size();
  for (std::size_t apex = 0; apex < last; ++apex) {
    if (!HasZeroAreaInFan(soup, corners, apex)) return apex;
  }
  return corners.size();
}

void AppendFan(Corners corners, std::size_t apex, Index polygon, TriangleSoup* triangles) {
  const std::size_t size = corners.size();
  for (std::size_t i = 1; i + 1 < size; ++i) {
    const Index h = static_cast<Index>(triangles->vertex.size());
    for (const std::size_t k : {std::size_t{0}, i, i + 1}) {
      triangles->vertex.push_back(corners[(apex + k) % size]);
    }
    triangles->polygon.push_back(polygon);
    // Across the edge from the apex to corner i lies the triangle before, across the one from
    // corner i + 1 the triangle behind.
    triangles->mate.push_back(kNone);
    triangles->mate.push_back(i + 2 < size ? h + 5 : kNone);
    triangles->mate.push_back(i > 1 ? h - 2 : kNone);
  }
}

}  // namespace

bool IsZeroArea(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c) {
  const double longest =
      std::max({(b - a).stableNorm(), (c - b).stableNorm(), (a - c).stableNorm()});
  // Scaled first, so that tiny and huge triangles neither underflow nor overflow.
  const Eigen::Vector3d ab = (b - a) / longest, ac = (c - a) / longest;
  return !(ab.cross(ac).norm() > 1e-12);
}

TriangleSoup SplitIntoFans(const PolygonSoup& soup, BadFaces* bad) {
  TriangleSoup triangles;
  triangles.vertex.reserve(soup.corner.size());
  triangles.mate.reserve(soup.corner.size());
  triangles.polygon.reserve(soup.num_polygons());
  std::vector<std::size_t> apex(soup.num_polygons());
  ParallelFor(soup.num_polygons(), [&](Index p) {
    const Corners corners = CornersOf(soup, p);
    apex[p] = RepeatsVertex(corners) ? kNoApex : FindApex(soup, corners);
  });
  for (Index p = 0; p < soup.num_polygons(); ++p) {
    if (apex[p] == kNoApex) {
      bad->repeated_vertex.push_back(p);
      continue;
    }
    const Corners corners = CornersOf(soup, p);
    if (apex[p] == corners.size()) bad->zero_area.push_back(p);
    AppendFan(corners, apex[p], p, &triangles);
  }
  return triangles;
}

namespace {

/// The end points of every halfedge, the smaller first.
struct EndPoints {
  std::vector<Index> low, high;

  bool Equal(Index h, Index g) const { return low[h] == low[g] && high[h] == high[g]; }
};

EndPoints CollectEndPoints(const std::vector<Index>& triangles) {
  EndPoints ends{std::vector<Index>(triangles.size()), std::vector<Index>(triangles.size())};
  ParallelFor(static_cast<Index>(triangles.size()), [&](Index h) {
    std::tie(ends.low[h], ends.high[h]) =
        std::minmax(triangles[Triangulation::Next(h)], triangles[Triangulation::Prev(h)]);
  });
  return ends;
}

/// The halfedges without a mate, those with equal end points one behind the other, increasing: by
/// a counting sort and short ones at every vertex.
std::vector<Index> SortByEndPoints(const EndPoints& ends, const std::vector<Index>& mate,
                                   Index num_vertices) {
  std::vector<Index> single;
  single.reserve(mate.size());
  for (Index h = 0; h < static_cast<Index>(mate.size()); ++h) {
    if (mate[h] == kNone) single.push_back(h);
  }
  Buckets at = SortIntoBuckets(ends.low, num_vertices, single);
  ParallelFor(num_vertices, [&](Index v) {
    std::sort(
        at.item.begin() + at.first[v], at.item.begin() + at.first[v + 1],
        [&](Index h, Index g) { return std::pair(ends.high[h], h) < std::pair(ends.high[g], g); });
  });
  return std::move(at.item);
}

}  // namespace

Gluing GlueEdges(const std::vector<Index>& triangles, Index num_vertices, std::vector<Index> mate) {
  const EndPoints ends = CollectEndPoints(triangles);
  const std::vector<Index> sorted = SortByEndPoints(ends, mate, num_vertices);
  Gluing gluing;
  gluing.num_edges = static_cast<Index>(mate.size() - sorted.size()) / 2;
  gluing.mate = std::move(mate);
  gluing.on_boundary.assign(triangles.size(), false);
  for (std::size_t first = 0, last = 0; first < sorted.size(); first = last) {
    const Index h = sorted[first];
    while (last < sorted.size() && ends.Equal(h, sorted[last])) ++last;
    ++gluing.num_edges;
    if (last - first == 1) gluing.on_boundary[h] = true;
    if (last - first > 2) gluing.non_manifold_edges.emplace_back(ends.low[h], ends.high[h]);
    if (last - first != 2) continue;
    gluing.mate[h] = sorted[first + 1];
    gluing.mate[sorted[first + 1]] = h;
  }
  return gluing;
}

std::vector<Index> CornerFans(const std::vector<Index>& triangles, const Gluing& gluing) {
  const Index num_corners = static_cast<Index>(triangles.size());
  DisjointSets fans(num_corners);
  for (Index h = 0; h < num_corners; ++h) {
    const Index g = gluing.mate[h];
    if (g == kNone || g < h) continue;
    const Index ends[2] = {Triangulation::Next(h), Triangulation::Prev(h)};
    const bool opposite = triangles[ends[0]] != triangles[Triangulation::Next(g)];
    fans.Unite(ends[0], opposite ? Triangulation::Prev(g) : Triangulation::Next(g));
    fans.Unite(ends[1], opposite ? Triangulation::Next(g) : Triangulation::Prev(g));
  }
  std::vector<Index> fan(num_corners);
  for (Index h = 0; h < num_corners; ++h) fan[h] = fans.Find(h);
  return fan;
}

Index CountBoundaryLoops(const std::vector<Index>& fan, const Gluing& gluing) {
  const Index num_halfedges = static_cast<Index>(fan.size());
  DisjointSets loops(num_halfedges);
  std::vector<Index> boundary_edge_at(num_halfedges, kNone);  // per fan
  for (Index h = 0; h < num_halfedges; ++h) {
    if (!gluing.on_boundary[h]) continue;
    for (const Index corner : {Triangulation::Next(h), Triangulation::Prev(h)}) {
      Index& other = boundary_edge_at[fan[corner]];
      if (other != kNone) loops.Unite(h, other);
      other = h;
    }
  }
  Index count = 0;
  for (Index h = 0; h < num_halfedges; ++h) {
    if (gluing.on_boundary[h] && loops.Find(h) == h) ++count;
  }
  return count;
}

namespace {

/// Walks over one piece of the surface from `seed`, which stays as it is. Returns its triangles.
std::vector<Index> OrientPiece(const std::vector<Index>& triangles, const Gluing& gluing,
                               Index seed, std::vector<bool>* seen, Orientation* orientation) {
  std::vector<Index> piece = {seed};
  (*seen)[seed] = true;
  for (std::size_t next = 0; next < piece.size(); ++next) {
    const Index f = piece[next];
    for (Index h = 3 * f; h < 3 * f + 3; ++h) {
      const Index g = gluing.mate[h];
      if (g == kNone) continue;
      const bool disagree = triangles[Triangulation::Next(h)] == triangles[Triangulation::Next(g)];
      const bool turn = orientation->turn[f] != disagree;
      const Index neighbour = Triangulation::Face(g);
      if (!(*seen)[neighbour]) {
        (*seen)[neighbour] = true;
        orientation->turn[neighbour] = turn;
        piece.push_back(neighbour);
      } else if (orientation->turn[neighbour] != turn && orientation->one_sided == kNone) {
        orientation->one_sided = h;
      }
    }
  }
  return piece;
}

}  // namespace

Orientation OrientTriangles(const std::vector<Index>& triangles, const Gluing& gluing) {
  const Index num_faces = static_cast<Index>(triangles.size() / 3);
  Orientation orientation;
  orientation.turn.assign(num_faces, false);
  std::vector<bool> seen(num_faces, false);
  for (Index seed = 0; seed < num_faces; ++seed) {
    if (seen[seed]) continue;
    const std::vector<Index> piece = OrientPiece(triangles, gluing, seed, &seen, &orientation);
    const auto turned =
        std::count_if(piece.begin(), piece.end(), [&](Index f) { return orientation.turn[f]; });
    if (2 * turned <= static_cast<std::ptrdiff_t>(piece.size())) continue;
    for (const Index f : piece) orientation.turn[f] = !orientation.turn[f];
  }
  return orientation;
}

void TurnTriangles(const std::vector<bool>& turn, std::vector<Index>* triangles,
                   std::vector<Index>* mate) {
  if (std::find(turn.begin(), turn.end(), true) == turn.end()) return;
  const auto moved = [&](Index h) {
    if (h == kNone || h % 3 == 0 || !turn[Triangulation::Face(h)]) return h;
    return h % 3 == 1 ? h + 1 : h - 1;
  };
  const std::vector<Index> old_triangles = *triangles, old_mate = *mate;
  for (Index h = 0; h < static_cast<Index>(old_mate.size()); ++h) {
    (*triangles)[moved(h)] = old_triangles[h];
    (*mate)[moved(h)] = moved(old_mate[h]);
  }
}

}  // namespace cirque
