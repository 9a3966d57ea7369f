#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <span>
#include <tuple>
#include <utility>
#include <vector>

#include <Eigen/Geometry>

#include "cirque/core/parallel.h"
#include "cirque/mesh/assembly.h"
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

double LargestSharpness(const Points& point, const PolygonTriangles& triangles) {
  double sharpness = -1;
  for (const auto& t : triangles) {
    sharpness = std::max(sharpness, Sharpness(point[t[0]], point[t[1]], point[t[2]]));
  }
  return sharpness;
}

/// The best of the fans whose triangles have an area: one that faces one way, of these the one with
/// the largest least angle, of these the one about the corner of least coordinates. Empty: none.
PolygonTriangles BestFan(const Points& point) {
  PolygonTriangles best;
  std::tuple<bool, double> best_key;
  std::size_t best_apex = 0;
  for (std::size_t apex = 0; apex < point.size(); ++apex) {
    PolygonTriangles fan = Fan(point.size(), apex);
    if (HasZeroArea(point, fan)) continue;
    const std::tuple<bool, double> key(!FaceOneWay(point, fan), LargestSharpness(point, fan));
    const bool better = best.empty() || key < best_key ||
                        (key == best_key && ComesBefore(point[apex], point[best_apex]));
    if (!better) continue;
    best = std::move(fan);
    best_key = key;
    best_apex = apex;
  }
  return best;
}

using Loop = std::vector<Index>;

/// The places of a polygon's corners, in turn, taken apart wherever it comes back to a point: loops
/// that come to no point twice. What it passes there and back at once is in none.
std::vector<Loop> LoopsOf(const Points& point) {
  std::vector<Loop> loops;
  Loop open;
  for (Index place = 0; place < static_cast<Index>(point.size()); ++place) {
    const auto back =
        std::find_if(open.begin(), open.end(), [&](Index at) { return point[at] == point[place]; });
    if (back != open.end()) {
      loops.emplace_back(back, open.end());
      open.erase(back, open.end());
    }
    open.push_back(place);
  }
  loops.push_back(std::move(open));
  std::erase_if(loops, [](const Loop& loop) { return loop.size() < 3; });
  return loops;
}

PolygonTriangles SplitLoops(const Points& point);

/// By ears, or by loops where the polygon comes back to a point. Empty: it has neither.
PolygonTriangles FindEarsOrLoops(const Points& point) {
  PolygonTriangles ears = CutEars(point);
  return ears.empty() || HasZeroArea(point, ears) ? SplitLoops(point) : ears;
}

/// A quad along its better diagonal; other polygons by ears or loops, or by a fan where there are
/// none (a polygon that crosses itself, or is bent).
PolygonTriangles FindSplit(const Points& point) {
  PolygonTriangles triangles;
  if (point.size() > 4) triangles = FindEarsOrLoops(point);
  return triangles.empty() ? BestFan(point) : triangles;
}

/// Loops that hang together at points or by bridges, each for itself, where all face one way. Empty:
/// there are none, or they do not.
PolygonTriangles SplitLoops(const Points& point) {
  const std::vector<Loop> loops = LoopsOf(point);
  if (loops.size() == 1 && loops[0].size() == point.size()) return {};
  const Eigen::Vector3d normal = NewellNormal(point);
  PolygonTriangles all;
  for (const Loop& loop : loops) {
    Points of_loop;
    for (const Index place : loop) of_loop.push_back(point[place]);
    const PolygonTriangles triangles = FindSplit(of_loop);
    if (triangles.empty() || !(NewellNormal(of_loop).dot(normal) > 0)) return {};
    for (const auto& t : triangles) all.push_back({loop[t[0]], loop[t[1]], loop[t[2]]});
  }
  return all;
}

/// What is known of a polygon before it is split.
struct Judgement {
  bool repeats_vertex = false, has_area = true;
  PolygonTriangles triangles;  ///< of more than three corners
};

Judgement Judge(const PolygonSoup& soup, Corners corners) {
  Judgement judgement;
  judgement.repeats_vertex = RepeatsVertex(corners);
  const auto finite = [&](Index v) { return soup.position[v].allFinite(); };
  if (!std::all_of(corners.begin(), corners.end(), finite)) return judgement;
  if (judgement.repeats_vertex) {
    // A keyhole, or loops: fans know nothing of those.
    judgement.triangles = FindEarsOrLoops(PointsOf(soup, corners));
    judgement.repeats_vertex = judgement.triangles.empty();
    return judgement;
  }
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
void Append(const PolygonSoup& soup, const PolygonTriangles& parts, Index polygon,
            TriangleSoup* triangles) {
  std::map<std::pair<Index, Index>, Index> open;  // places of an edge -> its halfedge
  for (const std::array<Index, 3>& part : parts) {
    const auto first = static_cast<Index>(triangles->vertex.size());
    triangles->polygon.push_back(polygon);
    for (Index k = 0; k < 3; ++k) {
      triangles->corner.push_back(soup.first_corner[polygon] + part[k]);
      triangles->vertex.push_back(soup.corner[triangles->corner.back()]);
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
  triangles.corner.reserve(soup.corner.size());
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
        Append(soup, whole, begin + i, &triangles);
      } else {
        Append(soup, judgement.triangles.empty() ? Fan(corners.size(), 0) : judgement.triangles,
               begin + i, &triangles);
      }
    }
  }
  RaiseValences(soup, &triangles);
  return triangles;
}

}  // namespace cirque
