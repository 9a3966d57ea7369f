#pragma once

#include <vector>

#include <Eigen/Geometry>

#include "cirque/core/types.h"

namespace cirque {

/// A binary tree of boxes in the plane, halved at the median along the longer side: finds those
/// that meet a given box in O(log n + found), however much their sizes differ.
class BoxTree {
 public:
  explicit BoxTree(std::vector<Eigen::AlignedBox2d> boxes);

  /// Calls visit(i) for every box i that has a point in common with `box`.
  template <class Visit>
  void VisitMeeting(const Eigen::AlignedBox2d& box, const Visit& visit) const {
    std::vector<Index> stack = {0};
    while (!stack.empty() && !nodes_.empty()) {
      const Node& node = nodes_[stack.back()];
      stack.pop_back();
      if (!node.box.intersects(box)) continue;
      if (node.left != kNone) {
        stack.push_back(node.left);
        stack.push_back(node.right);
        continue;
      }
      for (Index k = node.begin; k < node.end; ++k) {
        if (boxes_[order_[k]].intersects(box)) visit(order_[k]);
      }
    }
  }

 private:
  struct Node {
    Eigen::AlignedBox2d box = {};
    Index begin = 0, end = 0;  ///< of order_
    Index left = kNone, right = kNone;
  };

  Index Build(Index begin, Index end);

  std::vector<Eigen::AlignedBox2d> boxes_;
  std::vector<Index> order_;
  std::vector<Node> nodes_;  ///< the root first
};

}  // namespace cirque
