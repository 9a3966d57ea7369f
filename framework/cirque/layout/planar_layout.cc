#include "cirque/layout/planar_layout.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "cirque/core/grouping.h"
#include "cirque/core/parallel.h"
#include "cirque/core/sort_keys.h"

namespace cirque {
namespace {

/// Walks over the faces, breadth first within each patch.
class DirectionWalk {
 public:
  DirectionWalk(const Triangulation& open, const CornerAngles& angles)
      : t_(open),
        angles_(angles),
        direction_(open.num_halfedges()),
        placed_(open.num_faces(), false) {}

  Eigen::VectorXd Walk() {
    for (Index f = 0; f < t_.num_faces(); ++f) {
      if (placed_[f]) continue;
      queue_.clear();
      Place(3 * f, 0);
      for (std::size_t head = 0; head < queue_.size(); ++head) PlaceNeighbours(queue_[head]);
    }
    return std::move(direction_);
  }

 private:
  void Place(Index h, double towards) {
    placed_[Triangulation::Face(h)] = true;
    queue_.push_back(Triangulation::Face(h));
    for (int k = 0; k < 3; ++k) {
      direction_[h] = towards;
      towards += kPi - angles_.value[Triangulation::Prev(h)];
      h = Triangulation::Next(h);
    }
  }

  void PlaceNeighbours(Index face) {
    for (Index h = 3 * face; h < 3 * face + 3; ++h) {
      const Index g = t_.twin[h];
      if (g != kNone && !placed_[Triangulation::Face(g)]) {
        Place(g, std::remainder(direction_[h] + kPi, 2 * kPi));
      }
    }
  }

  const Triangulation& t_;
  const CornerAngles& angles_;
  Eigen::VectorXd direction_;
  std::vector<bool> placed_;
  std::vector<Index> queue_;
};

}  // namespace

Eigen::Vector2d OpenSurface::TargetVector(Index h) const {
  return lengths.value[triangulation.edge[h]] *
         Eigen::Vector2d(std::cos(direction[h]), std::sin(direction[h]));
}

std::vector<Eigen::Vector2d> OpenSurface::TargetVectors() const {
  std::vector<Eigen::Vector2d> target(triangulation.num_edges());
  ParallelFor(triangulation.num_edges(),
              [&](Index e) { target[e] = TargetVector(triangulation.edge_halfedge[e]); });
  return target;
}

EdgeLengths OpenedLengths(const Triangulation& t, const EdgeLengths& lengths,
                          const Triangulation& open) {
  EdgeLengths opened{Eigen::VectorXd(open.num_edges())};
  for (Index e = 0; e < open.num_edges(); ++e) {
    opened.value[e] = lengths.value[t.edge[open.edge_halfedge[e]]];
  }
  return opened;
}

OpenSurface OpenWithDirections(const Triangulation& t, const CornerAngles& flat_angles,
                               const EdgeLengths& lengths, const Cut& cut) {
  OpenSurface open;
  open.triangulation = CutOpen(t, cut);
  open.patches = ConnectedPatches(open.triangulation);
  open.direction = DirectionWalk(open.triangulation, flat_angles).Walk();
  open.lengths = OpenedLengths(t, lengths, open.triangulation);
  return open;
}

namespace {

/// Kruskal's minimum spanning tree of every patch, its edges as a graph in compressed rows.
class SpanningForest {
 public:
  SpanningForest(const Triangulation& t, const EdgeLengths& lengths) {
    std::vector<std::pair<double, Index>> order(t.num_edges());
    std::vector<std::pair<Index, Index>> ends(t.num_edges());
    ParallelFor(t.num_edges(), [&](Index e) {
      const Index h = t.edge_halfedge[e];
      order[e] = {lengths.value[e], e};
      ends[e] = {t.Tail(h), t.Tip(h)};
    });
    SortKeys(&order);
    DisjointSets sets(t.num_vertices);
    edges_.reserve(t.num_vertices);
    std::vector<Index> end;
    end.reserve(2 * t.num_vertices);
    for (const auto& [length, e] : order) {
      const auto [a, b] = ends[e];
      if (!sets.Unite(a, b)) continue;
      edges_.push_back(e);
      end.insert(end.end(), {a, b});
    }
    ends_at_ = SortIntoBuckets(end, t.num_vertices);
  }

  /// Shortest first.
  const std::vector<Index>& edges() const { return edges_; }

  template <class Visit>
  void ForEachEdgeAt(Index v, const Visit& visit) const {
    for (Index i = ends_at_.first[v]; i < ends_at_.first[v + 1]; ++i) {
      visit(edges_[ends_at_.item[i] / 2]);
    }
  }

 private:
  std::vector<Index> edges_;
  Buckets ends_at_;
};

class Placement {
 public:
  Placement(const OpenSurface& open, const std::vector<Eigen::Vector2d>& target)
      : t_(open.triangulation),
        forest_(t_, open.lengths),
        target_(target),
        position_(t_.num_vertices, Eigen::Vector2d::Zero()),
        placed_(t_.num_vertices, false) {}

  std::vector<Eigen::Vector2d> Place() {
    for (const Index e : forest_.edges()) {
      const Index root = t_.Tail(t_.edge_halfedge[e]);
      if (!placed_[root]) PlacePatch(root);
    }
    return std::move(position_);
  }

 private:
  void PlacePatch(Index root) {
    std::vector<Index> queue = {root};
    placed_[root] = true;
    for (std::size_t head = 0; head < queue.size(); ++head) {
      const Index v = queue[head];
      forest_.ForEachEdgeAt(v, [&](Index e) {
        const Index h = t_.edge_halfedge[e];
        const bool forward = t_.Tail(h) == v;
        const Index w = forward ? t_.Tip(h) : t_.Tail(h);
        if (placed_[w]) return;
        placed_[w] = true;
        position_[w] = position_[v] + (forward ? 1 : -1) * target_[e];
        queue.push_back(w);
      });
    }
  }

  const Triangulation& t_;
  SpanningForest forest_;
  const std::vector<Eigen::Vector2d>& target_;  ///< per edge, along its halfedge
  std::vector<Eigen::Vector2d> position_;
  std::vector<bool> placed_;
};

}  // namespace

PlanarLayout LayoutAt(const OpenSurface& open, const std::vector<Eigen::Vector2d>& target,
                      const std::vector<Eigen::Vector2d>& position) {
  const Triangulation& t = open.triangulation;
  PlanarLayout layout;
  layout.patches = open.patches;
  layout.patch_closure.assign(open.patches.count, 0);
  std::vector<double> missed(t.num_edges());
  ParallelFor(t.num_edges(), [&](Index e) {
    const Index h = t.edge_halfedge[e];
    const Eigen::Vector2d placed = position[t.Tip(h)] - position[t.Tail(h)];
    missed[e] = (placed - target[e]).norm() / open.lengths.value[e];
  });
  for (Index e = 0; e < t.num_edges(); ++e) {
    const Index f = Triangulation::Face(t.edge_halfedge[e]);
    double& worst = layout.patch_closure[open.patches.of_face[f]];
    worst = std::max(worst, missed[e]);
    layout.closure = std::max(layout.closure, worst);
  }
  layout.uv.value.resize(t.num_halfedges());
  ParallelFor(t.num_halfedges(), [&](Index c) { layout.uv.value[c] = position[t.vertex[c]]; });
  return layout;
}

PlanarLayout LayOutPatches(const Triangulation& t, const CornerAngles& flat_angles,
                           const EdgeLengths& lengths, const Cut& cut) {
  const OpenSurface open = OpenWithDirections(t, flat_angles, lengths, cut);
  const std::vector<Eigen::Vector2d> target = open.TargetVectors();
  return LayoutAt(open, target, Placement(open, target).Place());
}

PlanarLayout LayOutByDirections(const Triangulation& t, const CornerAngles& flat_angles,
                                const EdgeLengths& lengths) {
  return LayOutPatches(t, flat_angles, lengths, {std::vector<bool>(t.num_edges(), false)});
}

}  // namespace cirque
