#include "cirque/verify/nearest_point.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace cirque::verify {

NearestPoint::NearestPoint(const std::vector<Eigen::Vector3d>& points, std::vector<Index> numbers)
    : points_(points), numbers_(std::move(numbers)) {
  Sort(0, static_cast<int>(numbers_.size()), 0);
}

/// Puts the point of median coordinate in the middle and the lesser ones before it.
void NearestPoint::Sort(int begin, int end, int axis) {
  if (end - begin < 2) return;
  const int middle = begin + (end - begin) / 2;
  std::nth_element(numbers_.begin() + begin, numbers_.begin() + middle, numbers_.begin() + end,
                   [&](Index a, Index b) {
                     return std::pair(points_[a][axis], a) < std::pair(points_[b][axis], b);
                   });
  Sort(begin, middle, (axis + 1) % 3);
  Sort(middle + 1, end, (axis + 1) % 3);
}

Index NearestPoint::To(const Eigen::Vector3d& p) const {
  Index nearest = kNone;
  double squared_distance = std::numeric_limits<double>::infinity();
  Search(0, static_cast<int>(numbers_.size()), 0, p, &nearest, &squared_distance);
  return nearest;
}

void NearestPoint::Search(int begin, int end, int axis, const Eigen::Vector3d& p, Index* nearest,
                          double* squared_distance) const {
  if (begin == end) return;
  const int middle = begin + (end - begin) / 2;
  const Eigen::Vector3d& here = points_[numbers_[middle]];
  if (const double squared = (here - p).squaredNorm(); squared < *squared_distance) {
    *squared_distance = squared;
    *nearest = numbers_[middle];
  }
  const double beyond = p[axis] - here[axis];
  const auto search_side = [&](bool upper) {
    Search(upper ? middle + 1 : begin, upper ? end : middle, (axis + 1) % 3, p, nearest,
           squared_distance);
  };
  search_side(beyond > 0);
  if (beyond * beyond <= *squared_distance) search_side(!(beyond > 0));
}

}  // namespace cirque::verify
