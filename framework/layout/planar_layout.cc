#include "cirque/layout/planar_layout.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <vector>

namespace cirque {
namespace {

/// Direction [rad] of every halfedge, halfedge 0 along the x axis, breadth first over faces.
std::vector<double> HalfedgeDirections(const Triangulation& t, const CornerAngles& angles) {
  std::vector<double> direction(t.num_halfedges());
  std::vector<bool> placed(t.num_faces(), false);
  std::vector<Index> queue;
  queue.reserve(t.num_faces());
  const auto place = [&](Index h, double towards) {
    placed[Triangulation::Face(h)] = true;
    queue.push_back(Triangulation::Face(h));
    for (int k = 0; k < 3; ++k) {
      direction[h] = towards;
      towards += kPi - angles.value[Triangulation::Prev(h)];
      h = Triangulation::Next(h);
    }
  };
  place(0, 0);
  for (std::size_t head = 0; head < queue.size(); ++head) {
    for (Index h = 3 * queue[head]; h < 3 * queue[head] + 3; ++h) {
      const Index g = t.twin[h];
      if (g != kNone && !placed[Triangulation::Face(g)]) {
        place(g, std::remainder(direction[h] + kPi, 2 * kPi));
      }
    }
  }
  return direction;
}

/// The vector of edge e along its halfedge.
class EdgeVectors {
 public:
  EdgeVectors(const Triangulation& t, const std::vector<double>& direction,
              const EdgeLengths& lengths)
      : t_(t), direction_(direction), lengths_(lengths) {}

  Eigen::Vector2d operator()(Index e) const {
    const double a = direction_[t_.edge_halfedge[e]];
    return lengths_.value[e] * Eigen::Vector2d(std::cos(a), std::sin(a));
  }

 private:
  const Triangulation& t_;
  const std::vector<double>& direction_;
  const EdgeLengths& lengths_;
};

/// Kruskal's minimum spanning tree: its edges as a graph in compressed rows.
class SpanningTree {
 public:
  SpanningTree(const Triangulation& t, const EdgeLengths& lengths)
      : parent_(t.num_vertices), first_(t.num_vertices + 1, 0) {
    std::iota(parent_.begin(), parent_.end(), 0);
    std::vector<Index> order(t.num_edges());
    std::iota(order.begin(), order.end(), 0);
    std::sort(order.begin(), order.end(), [&](Index a, Index b) {
      return std::pair(lengths.value[a], a) < std::pair(lengths.value[b], b);
    });
    std::vector<Index> tree;
    for (const Index e : order) {
      const Index a = Root(t.Tail(t.edge_halfedge[e])), b = Root(t.Tip(t.edge_halfedge[e]));
      if (a == b) continue;
      parent_[a] = b;
      tree.push_back(e);
    }
    shortest_ = order.empty() ? kNone : order.front();
    Compress(t, tree);
  }

  Index shortest_edge() const { return shortest_; }

  template <class Visit>
  void ForEachEdgeAt(Index v, const Visit& visit) const {
    for (Index i = first_[v]; i < first_[v + 1]; ++i) visit(incident_[i]);
  }

 private:
  Index Root(Index v) {
    while (parent_[v] != v) v = parent_[v] = parent_[parent_[v]];
    return v;
  }

  void Compress(const Triangulation& t, const std::vector<Index>& tree) {
    const auto ends = [&](Index e) {
      return std::array{t.Tail(t.edge_halfedge[e]), t.Tip(t.edge_halfedge[e])};
    };
    for (const Index e : tree) {
      for (const Index v : ends(e)) ++first_[v + 1];
    }
    std::partial_sum(first_.begin(), first_.end(), first_.begin());
    incident_.resize(2 * tree.size());
    std::vector<Index> next(first_.begin(), first_.end() - 1);
    for (const Index e : tree) {
      for (const Index v : ends(e)) incident_[next[v]++] = e;
    }
  }

  std::vector<Index> parent_, first_, incident_;
  Index shortest_ = kNone;
};

std::vector<Eigen::Vector2d> PlaceVertices(const Triangulation& t, const SpanningTree& tree,
                                           const EdgeVectors& vector) {
  std::vector<Eigen::Vector2d> position(t.num_vertices, Eigen::Vector2d::Zero());
  std::vector<bool> placed(t.num_vertices, false);
  std::vector<Index> queue = {t.Tail(t.edge_halfedge[tree.shortest_edge()])};
  placed[queue.front()] = true;
  for (std::size_t head = 0; head < queue.size(); ++head) {
    const Index v = queue[head];
    tree.ForEachEdgeAt(v, [&](Index e) {
      const Index tail = t.Tail(t.edge_halfedge[e]), tip = t.Tip(t.edge_halfedge[e]);
      const Index w = tail == v ? tip : tail;
      if (placed[w]) return;
      placed[w] = true;
      position[w] = tail == v ? Eigen::Vector2d(position[v] + vector(e))
                              : Eigen::Vector2d(position[v] - vector(e));
      queue.push_back(w);
    });
  }
  return position;
}

}  // namespace

PlanarLayout LayOutByDirections(const Triangulation& t, const CornerAngles& flat_angles,
                                const EdgeLengths& lengths) {
  const std::vector<double> direction = HalfedgeDirections(t, flat_angles);
  const EdgeVectors vector(t, direction, lengths);
  const std::vector<Eigen::Vector2d> position = PlaceVertices(t, SpanningTree(t, lengths), vector);
  PlanarLayout layout;
  for (Index e = 0; e < t.num_edges(); ++e) {
    const Index h = t.edge_halfedge[e];
    const Eigen::Vector2d placed = position[t.Tip(h)] - position[t.Tail(h)];
    layout.closure = std::max(layout.closure, (placed - vector(e)).norm() / lengths.value[e]);
  }
  layout.uv.value.resize(t.num_halfedges());
  for (Index h = 0; h < t.num_halfedges(); ++h) layout.uv.value[h] = position[t.vertex[h]];
  return layout;
}

}  // namespace cirque
