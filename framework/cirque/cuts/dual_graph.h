#pragma once

#include <functional>
#include <queue>
#include <utility>
#include <vector>

#include <Eigen/Core>

#include "cirque/core/grouping.h"
#include "cirque/core/triangulation.h"
#include "cirque/intrinsic/intrinsic_surface.h"

namespace cirque {

/// The dual of a surface: a node for every polygon, which closed edges hold together; a joint across
/// every edge that may be opened and is not yet.
class DualGraph {
 public:
  struct Joint {
    Index edge, a, b;     ///< an edge of the surface, and the nodes on its two sides
    double cost, length;  ///< of opening it; between centroids, straight across it
  };

  /// Closed are edges of infinite cost; those of the given cut are open.
  DualGraph(const IntrinsicSurface& surface, const Eigen::VectorXd& cost, const Cut& given);

  Index size() const { return size_; }
  double Area(Index node) const { return area_[node]; }
  const std::vector<Joint>& joints() const { return joints_; }

  /// Calls visit(joint, the node across it).
  template <class Visit>
  void ForEachJointAt(Index node, const Visit& visit) const {
    for (Index i = ends_.first[node]; i < ends_.first[node + 1]; ++i) {
      const Joint& joint = joints_[ends_.item[i] / 2];
      visit(joint, ends_.item[i] % 2 == 0 ? joint.b : joint.a);
    }
  }

 private:
  void Number(const Triangulation& t, const Eigen::VectorXd& cost, const Cut& given);

  Index size_ = 0;
  std::vector<Index> of_face_;  ///< F
  std::vector<double> area_;
  std::vector<Joint> joints_;
  Buckets ends_;  ///< 2 j and 2 j + 1 of joint j, by node
};

/// Dijkstra's algorithm from nodes at distance 0 on, through nodes that `may_pass` allows and only
/// where that brings one nearer than `distance` says. `reach(node, from)` is told of every node that
/// got nearer.
template <class MayPass, class Reach>
void Spread(const DualGraph& graph, const std::vector<Index>& sources, const MayPass& may_pass,
            const Reach& reach, std::vector<double>* distance) {
  using Item = std::pair<double, Index>;
  std::priority_queue<Item, std::vector<Item>, std::greater<>> queue;
  for (const Index node : sources) {
    (*distance)[node] = 0;
    queue.emplace(0, node);
  }
  while (!queue.empty()) {
    const double so_far = queue.top().first;
    const Index node = queue.top().second;
    queue.pop();
    if (so_far > (*distance)[node]) continue;
    graph.ForEachJointAt(node, [&](const DualGraph::Joint& joint, Index across) {
      const double there = so_far + joint.length;
      if (there >= (*distance)[across] || !may_pass(node, across)) return;
      (*distance)[across] = there;
      reach(across, node);
      queue.emplace(there, across);
    });
  }
}

}  // namespace cirque
