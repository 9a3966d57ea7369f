#include "cirque/mesh/surface.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include <Eigen/Geometry>
#include <glog/logging.h>

namespace cirque {

EdgeLengths MeasureEdgeLengths(const Surface& surface) {
  const Triangulation& t = surface.triangulation;
  EdgeLengths lengths;
  lengths.value.resize(t.num_edges());
  for (Index e = 0; e < t.num_edges(); ++e) {
    const Index h = t.edge_halfedge[e];
    const Eigen::Vector3d edge = surface.position[t.Tip(h)] - surface.position[t.Tail(h)];
    lengths.value[e] = std::hypot(edge.x(), edge.y(), edge.z());
  }
  return lengths;
}

namespace {

constexpr double kNeedle = 1e-6;  ///< [rad]

/// The angle at p between q and r.
double AngleAt(const Eigen::Vector3d& p, const Eigen::Vector3d& q, const Eigen::Vector3d& r) {
  const Eigen::Vector3d a = q - p, b = r - p;
  return std::atan2(a.cross(b).norm(), a.dot(b));
}

}  // namespace

void MeasureNeedles(const Surface& surface, CornerAngles* angles) {
  const Triangulation& t = surface.triangulation;
  for (Index f = 0; f < t.num_faces(); ++f) {
    auto corner = angles->value.segment<3>(3 * f);
    Eigen::Index widest = 0;
    if (corner.minCoeff() >= kNeedle) continue;
    corner.maxCoeff(&widest);
    const auto point = [&](Eigen::Index k) -> const Eigen::Vector3d& {
      return surface.position[t.vertex[3 * f + k % 3]];
    };
    // Of long sides the differences are exact enough, of short ones the cross product.
    for (const Eigen::Index k : {(widest + 1) % 3, (widest + 2) % 3}) {
      corner[k] = AngleAt(point(k), point(k + 1), point(k + 2));
    }
    corner[widest] = kPi - corner[(widest + 1) % 3] - corner[(widest + 2) % 3];
  }
}

std::vector<bool> EdgesInsidePolygons(const Surface& surface) {
  const Triangulation& t = surface.triangulation;
  const std::vector<Index>& corner = surface.soup_corner;
  std::vector<bool> inside(t.num_edges(), false);
  if (corner.empty()) return inside;
  for (Index e = 0; e < t.num_edges(); ++e) {
    const Index h = t.edge_halfedge[e], g = t.twin[h];
    if (g == kNone || corner[h] == kNone) continue;
    inside[e] = corner[Triangulation::Next(h)] == corner[Triangulation::Prev(g)] &&
                corner[Triangulation::Prev(h)] == corner[Triangulation::Next(g)];
  }
  return inside;
}

PolygonSoup TrianglesOf(const Surface& surface) {
  PolygonSoup soup;
  soup.position = surface.position;
  soup.corner = surface.triangulation.vertex;
  for (Index f = 1; f <= surface.triangulation.num_faces(); ++f) {
    soup.first_corner.push_back(3 * f);
  }
  return soup;
}

namespace {

using Ends = std::pair<Index, Index>;

Ends EndsOfSide(const std::vector<Index>& corner, Index h) {
  const Index from = corner[h % 3 == 2 ? h - 2 : h + 1], to = corner[h % 3 == 0 ? h + 2 : h - 1];
  return std::minmax(from, to);
}

/// The sides opposite the corners, numbered so that equal ends have equal numbers, in the order in
/// which they first appear.
std::vector<Index> NumberSides(const std::vector<Index>& corner, std::vector<Ends>* ends) {
  std::vector<Index> order(corner.size()), number(corner.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(),
                   [&](Index a, Index b) { return EndsOfSide(corner, a) < EndsOfSide(corner, b); });
  std::vector<Index> first(corner.size());
  for (std::size_t i = 0; i < order.size(); ++i) {
    const bool same = i > 0 && EndsOfSide(corner, order[i]) == EndsOfSide(corner, order[i - 1]);
    first[order[i]] = same ? first[order[i - 1]] : order[i];
  }
  for (Index h = 0; h < static_cast<Index>(corner.size()); ++h) {
    if (first[h] == h) {
      number[h] = static_cast<Index>(ends->size());
      ends->push_back(EndsOfSide(corner, h));
    } else {
      number[h] = number[first[h]];
    }
  }
  return number;
}

PolygonSoup SubdivideOnce(const PolygonSoup& soup) {
  std::vector<Ends> ends;
  const std::vector<Index> side = NumberSides(soup.corner, &ends);
  PolygonSoup fine;
  fine.position = soup.position;
  for (const auto& [a, b] : ends) {
    fine.position.push_back(0.5 * (soup.position[a] + soup.position[b]));
  }
  const auto old_count = static_cast<Index>(soup.position.size());
  fine.corner.reserve(4 * soup.corner.size());
  for (std::size_t c = 0; c < soup.corner.size(); c += 3) {
    const Index* v = &soup.corner[c];
    const Index m[3] = {old_count + side[c], old_count + side[c + 1], old_count + side[c + 2]};
    const Index corners[] = {v[0], m[2], m[1], m[2], v[1], m[0],
                             m[1], m[0], v[2], m[0], m[1], m[2]};
    fine.corner.insert(fine.corner.end(), std::begin(corners), std::end(corners));
  }
  for (std::size_t c = 3; c <= fine.corner.size(); c += 3) {
    fine.first_corner.push_back(static_cast<Index>(c));
  }
  return fine;
}

}  // namespace

PolygonSoup MidpointSubdivision(const PolygonSoup& soup, int levels) {
  CHECK_EQ(soup.corner.size(), 3 * static_cast<std::size_t>(soup.num_polygons()));
  PolygonSoup result = soup;
  for (int level = 0; level < levels; ++level) result = SubdivideOnce(result);
  return result;
}

}  // namespace cirque
