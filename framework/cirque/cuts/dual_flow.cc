#include "cirque/cuts/dual_flow.h"

#include <algorithm>

namespace cirque {

DualFlow::DualFlow(Index num_nodes) : at_(num_nodes + 2) {}

void DualFlow::AddArcs(Index a, Index b, std::int64_t there, std::int64_t back) {
  at_[a].push_back(static_cast<Index>(arcs_.size()));
  arcs_.push_back({b, there});
  at_[b].push_back(static_cast<Index>(arcs_.size()));
  arcs_.push_back({a, back});
}

void DualFlow::Join(Index a, Index b, std::int64_t capacity) {
  infinity_ += capacity;
  AddArcs(a, b, capacity, capacity);
}

void DualFlow::SetSource(Index node) { sources_.push_back(node); }

void DualFlow::SetSink(Index node) { sinks_.push_back(node); }

/// Numbers the nodes by their distance from the source over arcs that can carry more; whether the
/// sink is reached.
bool DualFlow::Level() {
  const auto source = static_cast<Index>(at_.size()) - 2, sink = source + 1;
  level_.assign(at_.size(), kNone);
  level_[source] = 0;
  std::vector<Index> queue = {source};
  for (std::size_t i = 0; i < queue.size(); ++i) {
    for (const Index a : at_[queue[i]]) {
      if (arcs_[a].rest <= 0 || level_[arcs_[a].to] != kNone) continue;
      level_[arcs_[a].to] = level_[queue[i]] + 1;
      queue.push_back(arcs_[a].to);
    }
  }
  return level_[sink] != kNone;
}

/// Sends what one path by rising levels can carry; whether there was one.
bool DualFlow::Augment() {
  const auto source = static_cast<Index>(at_.size()) - 2, sink = source + 1;
  std::vector<Index> path;
  Index node = source;
  while (node != sink) {
    Index& k = next_[node];
    const auto count = static_cast<Index>(at_[node].size());
    while (k < count) {
      const Arc& arc = arcs_[at_[node][k]];
      if (arc.rest > 0 && level_[arc.to] == level_[node] + 1) break;
      ++k;
    }
    if (k < count) {
      path.push_back(at_[node][k]);
      node = arcs_[path.back()].to;
      continue;
    }
    if (node == source) return false;
    node = arcs_[path.back() ^ 1].to;
    path.pop_back();
    ++next_[node];
  }
  std::int64_t least = infinity_;
  for (const Index a : path) least = std::min(least, arcs_[a].rest);
  for (const Index a : path) {
    arcs_[a].rest -= least;
    arcs_[a ^ 1].rest += least;
  }
  return true;
}

std::vector<bool> DualFlow::MinimumCut() {
  const auto source = static_cast<Index>(at_.size()) - 2, sink = source + 1;
  for (const Index node : sources_) AddArcs(source, node, infinity_, 0);
  for (const Index node : sinks_) AddArcs(node, sink, infinity_, 0);
  while (Level()) {
    next_.assign(at_.size(), 0);
    while (Augment()) {
    }
  }
  std::vector<bool> reached(at_.size() - 2);
  for (std::size_t node = 0; node < reached.size(); ++node) reached[node] = level_[node] != kNone;
  return reached;
}

}  // namespace cirque
