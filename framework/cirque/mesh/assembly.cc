#include "cirque/mesh/assembly.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <span>
#include <tuple>
#include <utility>

#include <Eigen/Geometry>

#include "cirque/core/grouping.h"
#include "cirque/core/parallel.h"
#include "cirque/core/triangulation.h"
#include "cirque/mesh/ear_cutting.h"

namespace cirque {
namespace {

using Corners = std::span<const Index>;
using Points = std::vector<Eigen::Vector3d>;

constexpr Index kAtOnce = 1 << 18;  ///< polygons

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

/// The polygon's points, scaled by a power of two to about 1.
Points PointsOf(const PolygonSoup& soup, Corners corners) {
  double largest = 0;
  for (const Index v : corners) largest = std::max(largest, soup.position[v].cwiseAbs().maxCoeff());
  const int exponent = largest > 0 ? -std::ilogb(largest) : 0;
  Points points;
  for (const Index v : corners) {
    points.push_back(soup.position[v].unaryExpr([&](double x) { return std::ldexp(x, exponent); }));
  }
  return points;
}

PolygonTriangles Fan(std::size_t size, std::size_t apex) {
  PolygonTriangles triangles;
  for (std::size_t i = 1; i + 1 < size; ++i) {
    triangles.push_back({static_cast<Index>(apex), static_cast<Index>((apex + i) % size),
                         static_cast<Index>((apex + i + 1) % size)});
  }
  return triangles;
}

bool HasZeroArea(const Points& point, const PolygonTriangles& triangles) {
  return std::any_of(triangles.begin(), triangles.end(), [&](const auto& t) {
    return IsZeroArea(point[t[0]], point[t[1]], point[t[2]]);
  });
}

/// Whether all of them face the side that the polygon does, as they do inside a flat one.
bool FaceOneWay(const Points& point, const PolygonTriangles& triangles) {
  const Eigen::Vector3d normal = NewellNormal(point);
  return std::all_of(triangles.begin(), triangles.end(), [&](const auto& t) {
    return normal.dot((point[t[1]] - point[t[0]]).cross(point[t[2]] - point[t[0]])) > 0;
  });
}

/// The fan of the first corner whose triangles have an area and face one way; where there is none
/// (a polygon that is not convex, or has points on straight sides) ears; where there are none (it
/// crosses itself, or is bent) the first fan whose triangles have an area. Empty: there is none.
PolygonTriangles FindSplit(const Points& point) {
  PolygonTriangles first;
  for (std::size_t apex = 0; apex < point.size(); ++apex) {
    PolygonTriangles fan = Fan(point.size(), apex);
    if (HasZeroArea(point, fan)) continue;
    if (FaceOneWay(point, fan)) return fan;
    if (first.empty()) first = std::move(fan);
  }
  PolygonTriangles ears = CutEars(point);
  return !ears.empty() && !HasZeroArea(point, ears) ? ears : first;
}

/// What is known of a polygon before it is split.
struct Judgement {
  bool repeats_vertex = false, is_finite = true, has_area = true;
  PolygonTriangles triangles;  ///< of more than three corners
};

Judgement Judge(const PolygonSoup& soup, Corners corners) {
  Judgement judgement;
  judgement.repeats_vertex = RepeatsVertex(corners);
  const auto finite = [&](Index v) { return soup.position[v].allFinite(); };
  judgement.is_finite = std::all_of(corners.begin(), corners.end(), finite);
  if (judgement.repeats_vertex || !judgement.is_finite) return judgement;
  if (corners.size() == 3) {
    judgement.has_area = !IsZeroArea(soup.position[corners[0]], soup.position[corners[1]],
                                     soup.position[corners[2]]);
    return judgement;
  }
  judgement.triangles = FindSplit(PointsOf(soup, corners));
  judgement.has_area = !judgement.triangles.empty();
  return judgement;
}

/// Appends the triangles and glues them along the diagonals: two triangles of one polygon that
/// share the places of an edge.
void Append(Corners corners, const PolygonTriangles& parts, Index polygon,
            TriangleSoup* triangles) {
  std::map<std::pair<Index, Index>, Index> open;  // places of an edge -> its halfedge
  for (const std::array<Index, 3>& part : parts) {
    const auto first = static_cast<Index>(triangles->vertex.size());
    triangles->polygon.push_back(polygon);
    for (Index k = 0; k < 3; ++k) {
      triangles->vertex.push_back(corners[part[k]]);
      triangles->mate.push_back(kNone);
    }
    if (parts.size() == 1) return;
    for (Index k = 0; k < 3; ++k) {
      const std::pair<Index, Index> edge = std::minmax(part[(k + 1) % 3], part[(k + 2) % 3]);
      const auto [other, is_new] = open.try_emplace(edge, first + k);
      if (is_new) continue;
      triangles->mate[other->second] = first + k;
      triangles->mate[first + k] = other->second;
    }
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

TriangleSoup SplitIntoTriangles(const PolygonSoup& soup, BadFaces* bad) {
  TriangleSoup triangles;
  triangles.vertex.reserve(soup.corner.size());
  triangles.mate.reserve(soup.corner.size());
  triangles.polygon.reserve(soup.num_polygons());
  const PolygonTriangles whole = Fan(3, 0);
  std::vector<Judgement> judgements;
  // By parts: the judgements of all polygons at once would take more room than the mesh.
  for (Index begin = 0; begin < soup.num_polygons(); begin += kAtOnce) {
    const Index count = std::min(kAtOnce, soup.num_polygons() - begin);
    judgements.assign(count, {});
    ParallelFor(count, [&](Index i) { judgements[i] = Judge(soup, CornersOf(soup, begin + i)); });
    for (Index i = 0; i < count; ++i) {
      const Judgement& judgement = judgements[i];
      const Corners corners = CornersOf(soup, begin + i);
      if (judgement.repeats_vertex) {
        bad->repeated_vertex.push_back(begin + i);
        continue;
      }
      if (!judgement.has_area) bad->zero_area.push_back(begin + i);
      if (corners.size() == 3) {
        Append(corners, whole, begin + i, &triangles);
      } else {
        Append(corners, judgement.triangles.empty() ? Fan(corners.size(), 0) : judgement.triangles,
               begin + i, &triangles);
      }
    }
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
