#pragma once

#include <functional>
#include <vector>

#include <Eigen/Geometry>

#include "experiments/verify_map/exact.h"

namespace cirque::verify_map {

/// A tree of bounding boxes over segments, each node split at the median of its longer side. Unlike
/// a uniform grid it does not care how the lengths are distributed: a conformal map's boundary
/// edges may differ by e^20.
class SegmentTree {
 public:
  struct Segment {
    Point tail, tip;
  };

  explicit SegmentTree(std::vector<Segment> segments);

  /// Calls visit(i, j), i < j, for every two segments whose bounding boxes touch, in an order that
  /// depends on the segments only, until it returns false. O(n log n + pairs) on curves.
  void VisitTouchingBoxes(const std::function<bool(int, int)>& visit) const;

 private:
  struct Node {
    Eigen::AlignedBox2d box;
    int begin = 0, end = 0;  ///< of order_
    int right = 0;           ///< the left child follows its parent; 0 marks a leaf
  };

  int Build(int begin, int end);
  bool VisitWithin(int node, const std::function<bool(int, int)>& visit) const;
  bool VisitBetween(int a, int b, const std::function<bool(int, int)>& visit) const;
  bool VisitPair(int i, int j, const std::function<bool(int, int)>& visit) const;

  std::vector<Segment> segments_;
  std::vector<Eigen::AlignedBox2d> boxes_;
  std::vector<int> order_;
  std::vector<Node> nodes_;
};

}  // namespace cirque::verify_map
