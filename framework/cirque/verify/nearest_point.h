#pragma once

#include <vector>

#include <Eigen/Core>

#include "cirque/core/types.h"

namespace cirque::verify {

/// Finds the point nearest to another, in O(log n) wherever the points lie: a tree that halves them
/// by x, y and z in turn (J. Bentley, 1975).
class NearestPoint {
 public:
  /// The points of these numbers; no two of them may be equal, and all must be finite.
  NearestPoint(const std::vector<Eigen::Vector3d>& points, std::vector<Index> numbers);

  /// The number of the nearest point; kNone where there are no points.
  Index To(const Eigen::Vector3d& p) const;

 private:
  void Sort(int begin, int end, int axis);
  void Search(int begin, int end, int axis, const Eigen::Vector3d& p, Index* nearest,
              double* squared_distance) const;

  const std::vector<Eigen::Vector3d>& points_;
  std::vector<Index> numbers_;
};

}  // namespace cirque::verify
