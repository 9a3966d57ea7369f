#include <algorithm>
#include <array>
#include <numeric>

#include "cirque/generators/planar_delaunay.h"

namespace cirque {
namespace {

using Iterator = std::vector<Index>::iterator;

/// How the curve runs through a cell: it enters and leaves at the cell's two ends along `cross`, on
/// the side where `along` is least (or greatest, when its direction is reversed).
struct Frame {
  int along = 0;
  std::array<bool, 2> reversed = {false, false};  ///< per axis

  Frame Transposed() const { return {1 - along, reversed}; }
  Frame TransposedAndReversed() const { return {1 - along, {!reversed[0], !reversed[1]}}; }
};

class HilbertSorter {
 public:
  explicit HilbertSorter(const std::vector<Eigen::Vector2d>& points) : points_(points) {}

  /// Sorts a cell: halves it along one axis, each half along the other (the second half backwards),
  /// and turns the first and the last quarter so that the curve connects.
  void Sort(Iterator begin, Iterator end, const Frame& frame) const {
    if (end - begin <= 1) return;
    const int cross = 1 - frame.along;
    const Iterator middle = Halve(begin, end, frame.along, frame.reversed[frame.along]);
    const Iterator first = Halve(begin, middle, cross, frame.reversed[cross]);
    const Iterator last = Halve(middle, end, cross, !frame.reversed[cross]);
    Sort(begin, first, frame.Transposed());
    Sort(first, middle, frame);
    Sort(middle, last, frame);
    Sort(last, end, frame.TransposedAndReversed());
  }

 private:
  Iterator Halve(Iterator begin, Iterator end, int axis, bool reversed) const {
    const Iterator middle = begin + (end - begin) / 2;
    if (begin == end) return middle;
    std::nth_element(begin, middle, end, [&](Index i, Index j) {
      const double x = points_[i][axis], y = points_[j][axis];
      return x == y ? i < j : (x < y) != reversed;
    });
    return middle;
  }

  const std::vector<Eigen::Vector2d>& points_;
};

}  // namespace

std::vector<Index> HilbertOrder(const std::vector<Eigen::Vector2d>& points) {
  std::vector<Index> order(points.size());
  std::iota(order.begin(), order.end(), 0);
  HilbertSorter(points).Sort(order.begin(), order.end(), {});
  return order;
}

}  // namespace cirque
