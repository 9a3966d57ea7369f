#include "cirque/mesh/farthest_vertices.h"

#include <algorithm>
#include <functional>
#include <limits>
#include <queue>
#include <utility>

#include <glog/logging.h>

#include "cirque/core/grouping.h"

namespace cirque {
namespace {

/// Distances along edges to a growing set of vertices.
class EdgeDistances {
 public:
  EdgeDistances(const Triangulation& t, const EdgeLengths& lengths)
      : t_(t),
        lengths_(lengths),
        corners_at_(SortIntoBuckets(t.vertex, t.num_vertices)),
        distance_(t.num_vertices, std::numeric_limits<double>::infinity()) {}

  double operator()(Index v) const { return distance_[v]; }

  /// Dijkstra from v, no farther than v is the nearest of the set: all additions together cost
  /// little more than a few plain runs.
  void Add(Index v) {
    using Item = std::pair<double, Index>;
    std::priority_queue<Item, std::vector<Item>, std::greater<>> queue;
    const auto reach = [&](Index w, double distance) {
      if (distance >= distance_[w]) return;
      distance_[w] = distance;
      queue.emplace(distance, w);
    };
    reach(v, 0);
    while (!queue.empty()) {
      const auto [distance, u] = queue.top();
      queue.pop();
      if (distance > distance_[u]) continue;
      for (Index i = corners_at_.first[u]; i < corners_at_.first[u + 1]; ++i) {
        const Index next = Triangulation::Next(corners_at_.item[i]);
        const Index prev = Triangulation::Prev(corners_at_.item[i]);
        reach(t_.vertex[next], distance + lengths_.value[t_.edge[prev]]);
        reach(t_.vertex[prev], distance + lengths_.value[t_.edge[next]]);
      }
    }
  }

 private:
  const Triangulation& t_;
  const EdgeLengths& lengths_;
  Buckets corners_at_;
  std::vector<double> distance_;
};

}  // namespace

std::vector<Index> FarthestVertices(const Triangulation& t, const EdgeLengths& lengths,
                                    const std::vector<Index>& candidates, Index count) {
  CHECK_LE(count, static_cast<Index>(candidates.size()));
  std::vector<Index> chosen;
  EdgeDistances distance(t, lengths);
  while (static_cast<Index>(chosen.size()) < count) {
    // The first maximum: at the start all distances are infinite.
    chosen.push_back(*std::max_element(candidates.begin(), candidates.end(), [&](Index a, Index b) {
      return distance(a) < distance(b);
    }));
    distance.Add(chosen.back());
  }
  return chosen;
}

}  // namespace cirque
