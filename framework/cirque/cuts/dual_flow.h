#pragma once

#include <cstdint>
#include <vector>

#include "cirque/core/types.h"

namespace cirque {

/// Flow from sources to sinks through an undirected graph whose joints carry only so much, and the
/// cheapest joints that part the two (E. Dinic, 1970; L. Ford, D. Fulkerson, "Maximal flow through a
/// network", 1956).
class DualFlow {
 public:
  explicit DualFlow(Index num_nodes);

  /// Joins two nodes; `capacity` >= 0, either way. All of them add up to less than 2^62.
  void Join(Index a, Index b, std::int64_t capacity);
  void SetSource(Index node);
  void SetSink(Index node);

  /// Per node whether it lies on the sources' side of a cut of least capacity. Among equal cuts that
  /// nearest to the sources.
  std::vector<bool> MinimumCut();

 private:
  struct Joint {
    Index a, b;
    std::int64_t capacity;
  };
  struct Arc {
    Index to, back;     ///< a node, and the arc the other way
    std::int64_t rest;  ///< what it can carry yet
  };

  void LayOutArcs();
  bool MeasureDistances();
  void SendBlockingFlow();
  std::vector<bool> ReachedFromSource() const;

  std::vector<Joint> joints_;
  std::vector<Index> node_;   ///< sources are one node, the last but one, and sinks the last
  std::vector<Index> first_;  ///< per node its first arc; one more
  std::vector<Arc> arcs_;     ///< node by node
  std::vector<Index> distance_, next_;
};

}  // namespace cirque
