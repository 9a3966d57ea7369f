#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "cirque/core/types.h"

namespace cirque {

/// A binary tree of boxes in the plane or in space, halved again and again along a curve that fills the cube about their
/// centres (G. M. Morton, "A computer oriented geodetic data base", 1966): finds those that meet a given set in
/// O(log n + found), however much their sizes differ. Built in linear time.
template <int N>
class BoxTreeOf {
 public:
  using Box = Eigen::AlignedBox<double, N>;

  explicit BoxTreeOf(std::vector<Box> boxes);

  /// Calls visit(i) for every box i of which meets(box) holds, which must hold of every box around
  /// such a one. Where it holds of none any more the search is over.
  template <class Meets, class Visit>
  void VisitWhere(const Meets& meets, const Visit& visit) const {
    // One node of every level waits, and halving leads through fewer levels than an index has bits.
    std::array<Index, 8 * sizeof(Index)> waiting = {0};
    for (std::size_t count = nodes_.empty() ? 0 : 1; count > 0;) {
      const Node& node = nodes_[waiting[--count]];
      if (!meets(node.box)) continue;
      if (node.left != kNone) {
        waiting[count++] = node.left;
        waiting[count++] = node.right;
        continue;
      }
      for (Index k = node.begin; k < node.end; ++k) {
        if (meets(boxes_[order_[k]])) visit(order_[k]);
      }
    }
  }

  /// Calls visit(i) for every box i that has a point in common with `box`.
  template <class Visit>
  void VisitMeeting(const Box& box, const Visit& visit) const {
    VisitWhere([&](const Box& other) { return other.intersects(box); }, visit);
  }

 private:
  struct Node {
    Box box = {};
    Index begin = 0, end = 0;  ///< of order_
    Index left = kNone, right = kNone;
  };

  Index Build(Index begin, Index end);

  std::vector<Box> boxes_;
  std::vector<Index> order_;  ///< the boxes leaf by leaf
  std::vector<Node> nodes_;   ///< the root first
};

extern template class BoxTreeOf<2>;
extern template class BoxTreeOf<3>;

using BoxTree = BoxTreeOf<2>;

}  // namespace cirque
