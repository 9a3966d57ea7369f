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
  struct Arc {
    Index to;
    std::int64_t rest;  ///< what it can carry yet
  };

  void AddArcs(Index a, Index b, std::int64_t there, std::int64_t back);
  bool Level();
  bool Augment();

  std::int64_t infinity_ = 1;           ///< more than all joints carry
  std::vector<Arc> arcs_;               ///< arc 2 i and its way back 2 i + 1
  std::vector<std::vector<Index>> at_;  ///< per node its arcs; at last those of source and sink
  std::vector<Index> level_, next_;
  std::vector<Index> sources_, sinks_;
};

}  // namespace cirque
