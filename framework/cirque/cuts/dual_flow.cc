#include "cirque/cuts/dual_flow.h"

#include <algorithm>
#include <numeric>

namespace cirque {

DualFlow::DualFlow(Index num_nodes) : node_(num_nodes) { std::iota(node_.begin(), node_.end(), 0); }

void DualFlow::Join(Index a, Index b, std::int64_t capacity) {
  joints_.push_back({a, b, capacity});
}

void DualFlow::SetSource(Index node) { node_[node] = static_cast<Index>(node_.size()); }

void DualFlow::SetSink(Index node) { node_[node] = static_cast<Index>(node_.size()) + 1; }

void DualFlow::LayOutArcs() {
  const std::size_t nodes = node_.size() + 2;
  std::erase_if(joints_, [&](const Joint& j) { return node_[j.a] == node_[j.b]; });
  first_.assign(nodes + 1, 0);
  for (const Joint& j : joints_) ++first_[node_[j.a] + 1], ++first_[node_[j.b] + 1];
  std::partial_sum(first_.begin(), first_.end(), first_.begin());
  std::vector<Index> at(first_.begin(), first_.end() - 1);
  arcs_.resize(2 * joints_.size());
  for (const Joint& j : joints_) {
    const Index a = node_[j.a], b = node_[j.b], there = at[a]++, back = at[b]++;
    arcs_[there] = {b, back, j.capacity};
    arcs_[back] = {a, there, j.capacity};
  }
}

/// Numbers the nodes by their distance to the sink over arcs that can carry more, as far as the source
/// is; whether that reaches it.
bool DualFlow::MeasureDistances() {
  const auto source = static_cast<Index>(node_.size()), sink = source + 1;
  distance_.assign(node_.size() + 2, kNone);
  distance_[sink] = 0;
  std::vector<Index> queue = {sink};
  for (std::size_t i = 0; i < queue.size() && distance_[source] == kNone; ++i) {
    const Index node = queue[i];
    for (Index a = first_[node]; a < first_[node + 1]; ++a) {
      const Arc& arc = arcs_[a];
      if (distance_[arc.to] != kNone || arcs_[arc.back].rest <= 0) continue;
      distance_[arc.to] = distance_[node] + 1;
      queue.push_back(arc.to);
    }
  }
  return distance_[source] != kNone;
}

/// Paths towards the sink until every one is blocked; each goes on from where the one before was.
void DualFlow::SendBlockingFlow() {
  const auto source = static_cast<Index>(node_.size()), sink = source + 1;
  next_.assign(first_.begin(), first_.end() - 1);
  std::vector<Index> path;
  Index node = source;
  while (true) {
    if (node == sink) {
      std::int64_t least = arcs_[path[0]].rest;
      for (const Index a : path) least = std::min(least, arcs_[a].rest);
      for (const Index a : path) {
        arcs_[a].rest -= least;
        arcs_[arcs_[a].back].rest += least;
      }
      const auto full =
          std::find_if(path.begin(), path.end(), [&](Index a) { return arcs_[a].rest == 0; });
      node = arcs_[arcs_[*full].back].to;
      path.erase(full, path.end());
    }
    Index& a = next_[node];
    const auto leads_on = [&](const Arc& arc) {
      return arc.rest > 0 && distance_[arc.to] == distance_[node] - 1;
    };
    while (a < first_[node + 1] && !leads_on(arcs_[a])) ++a;
    if (a < first_[node + 1]) {
      path.push_back(a);
      node = arcs_[a].to;
      continue;
    }
    if (node == source) return;
    node = arcs_[arcs_[path.back()].back].to;
    path.pop_back();
    ++next_[node];
  }
}

std::vector<bool> DualFlow::ReachedFromSource() const {
  const auto source = static_cast<Index>(node_.size());
  std::vector<bool> reached(node_.size() + 2, false);
  reached[source] = true;
  std::vector<Index> queue = {source};
  for (std::size_t i = 0; i < queue.size(); ++i) {
    for (Index a = first_[queue[i]]; a < first_[queue[i] + 1]; ++a) {
      if (arcs_[a].rest <= 0 || reached[arcs_[a].to]) continue;
      reached[arcs_[a].to] = true;
      queue.push_back(arcs_[a].to);
    }
  }
  return reached;
}

std::vector<bool> DualFlow::MinimumCut() {
  LayOutArcs();
  while (MeasureDistances()) SendBlockingFlow();
  const std::vector<bool> reached = ReachedFromSource();
  std::vector<bool> side;
  for (const Index node : node_) side.push_back(reached[node]);
  return side;
}

}  // namespace cirque
