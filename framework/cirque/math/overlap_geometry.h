#pragma once

#include <array>
#include <vector>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "cirque/core/types.h"

namespace cirque {

/// The corners of a triangle in the plane, counter-clockwise.
using PlaneTriangle = std::array<Eigen::Vector2d, 3>;

/// Whether two triangles have an inner point in common, exactly.
bool InteriorsMeet(const PlaneTriangle& s, const PlaneTriangle& t);

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

/// The corners of a convex polygon, counter-clockwise.
using ConvexPolygon = std::vector<Eigen::Vector2d>;

/// Its area, 0 with fewer than three corners.
double Area(const ConvexPolygon& polygon);

/// Cuts a convex polygon along the sides of a counter-clockwise triangle. Appends the pieces
/// outside the triangle, at most three, to `outside`, and returns the piece inside, empty where
/// there is none. Corners are rounded to doubles.
ConvexPolygon CutByTriangle(ConvexPolygon polygon, const PlaneTriangle& triangle,
                            std::vector<ConvexPolygon>* outside);

}  // namespace cirque
