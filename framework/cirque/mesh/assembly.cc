#include "cirque/mesh/assembly.h"

#include <algorithm>
#include <tuple>
#include <utility>

#include "cirque/core/grouping.h"
#include "cirque/core/parallel.h"
#include "cirque/core/triangulation.h"

namespace cirque {
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
  bool is_one_sided = false;
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
      } else if (orientation->turn[neighbour] != turn && !is_one_sided) {
        is_one_sided = true;
        orientation->one_sided.push_back(h);
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

void TurnTriangles(const std::vector<bool>& turn, TriangleSoup* triangles,
                   std::vector<Index>* mate) {
  if (std::find(turn.begin(), turn.end(), true) == turn.end()) return;
  const auto moved = [&](Index h) {
    if (h == kNone || h % 3 == 0 || !turn[Triangulation::Face(h)]) return h;
    return h % 3 == 1 ? h + 1 : h - 1;
  };
  const std::vector<Index> old_mate = *mate;
  for (Index h = 0; h < static_cast<Index>(old_mate.size()); ++h) {
    (*mate)[moved(h)] = moved(old_mate[h]);
    if (h % 3 != 1 || moved(h) == h) continue;
    std::swap(triangles->vertex[h], triangles->vertex[h + 1]);
    std::swap(triangles->corner[h], triangles->corner[h + 1]);
  }
}

}  // namespace cirque
