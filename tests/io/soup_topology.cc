#include "tests/io/soup_topology.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>

#include <Eigen/Geometry>
#include <fmt/format.h>

namespace cirque {
namespace {

class UnionFind {
 public:
  explicit UnionFind(Index n) : parent_(n) { std::iota(parent_.begin(), parent_.end(), 0); }
  Index Find(Index i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }
  void Join(Index i, Index j) { parent_[Find(i)] = Find(j); }

 private:
  std::vector<Index> parent_;
};

void CollectEdges(const PolygonSoup& soup, SoupTopology* t) {
  for (Index f = 0; f < soup.num_polygons(); ++f) {
    if (soup.first_corner[f + 1] - soup.first_corner[f] != 3) t->defect = "not a triangle";
    for (int k = 0; k < 3; ++k) {
      const auto corner = [&](int i) { return soup.corner[soup.first_corner[f] + i % 3]; };
      const std::pair<Index, Index> edge{corner(k + 1), corner(k + 2)};
      if (edge.first == edge.second) t->defect = fmt::format("face {} repeats a vertex", f);
      if (!t->opposite.emplace(edge, corner(k)).second) {
        t->defect = fmt::format("directed edge {} {} twice", edge.first, edge.second);
      }
      ++t->valence[corner(k)];
    }
  }
}

/// Boundary loops, and from the umbrellas whether every vertex has a single fan.
void CountLoops(SoupTopology* t) {
  std::map<Index, Index> next;
  for (const auto& [edge, corner] : t->opposite) {
    const bool boundary = !t->opposite.contains({edge.second, edge.first});
    t->edges += boundary || edge.first < edge.second;
    if (!boundary) continue;
    ++t->boundary_edges;
    t->on_boundary[edge.first] = true;
    if (!next.emplace(edge).second) t->defect = fmt::format("vertex {} pinched", edge.first);
  }
  std::set<Index> seen;
  for (const auto& [start, unused] : next) {
    if (seen.contains(start)) continue;
    ++t->loops;
    for (Index v = start; seen.insert(v).second;) v = next.at(v);
  }
}

void CheckUmbrellas(const PolygonSoup& soup, SoupTopology* t) {
  // Corners of one vertex that share an edge at it are joined; each vertex must end in one class.
  const auto corners = static_cast<Index>(soup.corner.size());
  UnionFind fans(corners), pieces(t->vertices);
  std::map<std::pair<Index, Index>, Index> corner_at;  // (vertex, next vertex) -> corner
  for (Index c = 0; c < corners; ++c) {
    const Index next = c % 3 == 2 ? c - 2 : c + 1;
    corner_at[{soup.corner[c], soup.corner[next]}] = c;
    pieces.Join(soup.corner[c], soup.corner[next]);
  }
  for (Index c = 0; c < corners; ++c) {
    const Index prev = c % 3 == 0 ? c + 2 : c - 1;
    const auto across = corner_at.find({soup.corner[c], soup.corner[prev]});
    if (across != corner_at.end()) fans.Join(c, across->second);
  }
  std::map<Index, Index> fan_of;
  for (Index c = 0; c < corners; ++c) {
    if (fan_of.emplace(soup.corner[c], fans.Find(c)).first->second != fans.Find(c)) {
      t->defect = fmt::format("vertex {} has several fans", soup.corner[c]);
    }
  }
  for (Index v = 0; v < t->vertices; ++v) t->components += pieces.Find(v) == v;
}

}  // namespace

SoupTopology MeasureTopology(const PolygonSoup& soup) {
  SoupTopology t;
  t.vertices = static_cast<Index>(soup.position.size());
  t.faces = soup.num_polygons();
  t.valence.assign(t.vertices, 0);
  t.on_boundary.assign(t.vertices, false);
  CollectEdges(soup, &t);
  CountLoops(&t);
  CheckUmbrellas(soup, &t);
  if (std::count(t.valence.begin(), t.valence.end(), 0) > 0) t.defect = "isolated vertex";
  return t;
}

double SmallestAngle(const PolygonSoup& soup) {
  double smallest = 4;
  for (std::size_t c = 0; c < soup.corner.size(); ++c) {
    const std::size_t f = c / 3 * 3;
    const Eigen::Vector3d& p = soup.position[soup.corner[c]];
    const Eigen::Vector3d u = soup.position[soup.corner[f + (c + 1) % 3]] - p;
    const Eigen::Vector3d v = soup.position[soup.corner[f + (c + 2) % 3]] - p;
    smallest = std::min(smallest, std::atan2(u.cross(v).norm(), u.dot(v)));
  }
  return smallest;
}

}  // namespace cirque
