#include "experiments/verify_map/segment_tree.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace cirque::verify_map {

SegmentTree::SegmentTree(std::vector<Segment> segments)
    : segments_(std::move(segments)), order_(segments_.size()) {
  boxes_.reserve(segments_.size());
  for (const Segment& s : segments_) {
    boxes_.emplace_back(s.tail.cwiseMin(s.tip), s.tail.cwiseMax(s.tip));
  }
  std::iota(order_.begin(), order_.end(), 0);
  if (!order_.empty()) Build(0, static_cast<int>(order_.size()));
}

int SegmentTree::Build(int begin, int end) {
  constexpr int kLeafSize = 4;
  const int node = static_cast<int>(nodes_.size());
  nodes_.emplace_back();
  Eigen::AlignedBox2d box;
  for (int i = begin; i < end; ++i) box.extend(boxes_[order_[i]]);
  nodes_[node].box = box;
  nodes_[node].begin = begin;
  nodes_[node].end = end;
  if (end - begin <= kLeafSize) return node;
  const int axis = box.sizes().x() >= box.sizes().y() ? 0 : 1;
  const auto key = [&](int s) { return boxes_[s].min()[axis] / 2 + boxes_[s].max()[axis] / 2; };
  const int middle = begin + (end - begin) / 2;
  std::nth_element(order_.begin() + begin, order_.begin() + middle, order_.begin() + end,
                   [&](int a, int b) { return std::pair(key(a), a) < std::pair(key(b), b); });
  Build(begin, middle);
  const int right = Build(middle, end);
  nodes_[node].right = right;
  return node;
}

void SegmentTree::VisitTouchingBoxes(const std::function<bool(int, int)>& visit) const {
  if (!nodes_.empty()) VisitWithin(0, visit);
}

bool SegmentTree::VisitWithin(int node, const std::function<bool(int, int)>& visit) const {
  const Node& n = nodes_[node];
  if (n.right != 0) {
    return VisitWithin(node + 1, visit) && VisitWithin(n.right, visit) &&
           VisitBetween(node + 1, n.right, visit);
  }
  for (int i = n.begin; i < n.end; ++i) {
    for (int j = i + 1; j < n.end; ++j) {
      if (!VisitPair(order_[i], order_[j], visit)) return false;
    }
  }
  return true;
}

bool SegmentTree::VisitBetween(int a, int b, const std::function<bool(int, int)>& visit) const {
  const Node &m = nodes_[a], &n = nodes_[b];
  if (!m.box.intersects(n.box)) return true;
  const bool split_a = m.right != 0 && (n.right == 0 || m.end - m.begin >= n.end - n.begin);
  if (split_a) return VisitBetween(a + 1, b, visit) && VisitBetween(m.right, b, visit);
  if (n.right != 0) return VisitBetween(a, b + 1, visit) && VisitBetween(a, n.right, visit);
  for (int i = m.begin; i < m.end; ++i) {
    for (int j = n.begin; j < n.end; ++j) {
      if (!VisitPair(order_[i], order_[j], visit)) return false;
    }
  }
  return true;
}

bool SegmentTree::VisitPair(int i, int j, const std::function<bool(int, int)>& visit) const {
  if (!boxes_[i].intersects(boxes_[j])) return true;
  return visit(std::min(i, j), std::max(i, j));
}

}  // namespace cirque::verify_map
