#include "cirque/math/overlap_geometry.h"

#include <algorithm>
#include <numeric>
#include <utility>

#include "cirque/math/predicates.h"

namespace cirque {
namespace {

using Eigen::Vector2d;

constexpr Index kLeafSize = 8;  // of the tree, in boxes

double Cross(const Vector2d& a, const Vector2d& b) { return a.x() * b.y() - a.y() * b.x(); }

/// Whether a side of s has all of t on its outer side, exactly.
bool SideSeparates(const PlaneTriangle& s, const PlaneTriangle& t) {
  for (std::size_t k = 0; k < 3; ++k) {
    const Vector2d &a = s[k], &b = s[(k + 1) % 3];
    const bool outside = std::all_of(
        t.begin(), t.end(), [&](const Vector2d& p) { return OrientationSign(a, b, p) <= 0; });
    if (outside) return true;
  }
  return false;
}

/// The parts to the left and to the right of the line from a to b.
struct Halves {
  ConvexPolygon left, right;
};

Halves Split(const ConvexPolygon& polygon, const Vector2d& a, const Vector2d& b) {
  Halves halves;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vector2d &p = polygon[i], &q = polygon[(i + 1) % polygon.size()];
    const double at_p = Cross(b - a, p - a), at_q = Cross(b - a, q - a);
    if (at_p >= 0) halves.left.push_back(p);
    if (at_p <= 0) halves.right.push_back(p);
    if ((at_p > 0 && at_q < 0) || (at_p < 0 && at_q > 0)) {
      const Vector2d crossing = p + at_p / (at_p - at_q) * (q - p);
      halves.left.push_back(crossing);
      halves.right.push_back(crossing);
    }
  }
  return halves;
}

}  // namespace

bool InteriorsMeet(const PlaneTriangle& s, const PlaneTriangle& t) {
  return !SideSeparates(s, t) && !SideSeparates(t, s);
}

double Area(const ConvexPolygon& polygon) {
  double twice = 0;
  for (std::size_t i = 2; i < polygon.size(); ++i) {
    twice += Cross(polygon[i - 1] - polygon[0], polygon[i] - polygon[0]);
  }
  return twice / 2;
}

ConvexPolygon CutByTriangle(ConvexPolygon polygon, const PlaneTriangle& triangle,
                            std::vector<ConvexPolygon>* outside) {
  for (std::size_t k = 0; k < 3 && polygon.size() >= 3; ++k) {
    Halves halves = Split(polygon, triangle[k], triangle[(k + 1) % 3]);
    if (halves.right.size() >= 3) outside->push_back(std::move(halves.right));
    polygon = std::move(halves.left);
  }
  if (polygon.size() < 3) polygon.clear();
  return polygon;
}

BoxTree::BoxTree(std::vector<Eigen::AlignedBox2d> boxes)
    : boxes_(std::move(boxes)), order_(boxes_.size()) {
  std::iota(order_.begin(), order_.end(), 0);
  if (!boxes_.empty()) Build(0, static_cast<Index>(boxes_.size()));
}

Index BoxTree::Build(Index begin, Index end) {
  const auto id = static_cast<Index>(nodes_.size());
  Node node{.begin = begin, .end = end};
  for (Index k = begin; k < end; ++k) node.box.extend(boxes_[order_[k]]);
  nodes_.push_back(node);
  if (end - begin <= kLeafSize) return id;
  const int axis = node.box.sizes().x() >= node.box.sizes().y() ? 0 : 1;
  const Index middle = begin + (end - begin) / 2;
  std::nth_element(order_.begin() + begin, order_.begin() + middle, order_.begin() + end,
                   [&](Index i, Index j) {
                     return boxes_[i].min()[axis] + boxes_[i].max()[axis] <
                            boxes_[j].min()[axis] + boxes_[j].max()[axis];
                   });
  const Index left = Build(begin, middle), right = Build(middle, end);
  nodes_[id].left = left;
  nodes_[id].right = right;
  return id;
}

}  // namespace cirque
