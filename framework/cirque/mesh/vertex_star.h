#pragma once

#include <cstddef>
#include <vector>

#include <Eigen/Core>

#include "cirque/core/types.h"

namespace cirque {

/// Which of its neighbours a vertex is to be collapsed to, and how good that is.
struct CollapseChoice {
  std::size_t at;     ///< in the ring
  double score = 0;   ///< of the triangles that come the least thickness times cosine of the turn
  double cosine = 1;  ///< of the largest turn
};

/// A vertex with the faces around it.
struct VertexStar {
  bool closed = true;
  /// The neighbours counter-clockwise, on the boundary from side to side.
  std::vector<Index> ring;
  std::vector<Index> face;  ///< between each and the next
  // What Measure fills in:
  std::vector<Eigen::Vector3d> normal;  ///< of the faces, as long as twice their areas
  std::vector<double> side_squared;     ///< of the ring's edges

  std::size_t size() const { return face.size(); }
  Index Next(std::size_t k) const { return k + 1 < ring.size() ? ring[k + 1] : ring[0]; }

  /// Returns the least thickness of the faces: twice the area over the square of the longest side,
  /// 0.87 where all are equal, 0 without area.
  double Measure(const std::vector<Eigen::Vector3d>& position, Index vertex);

  /// The cosine of the angle by which the boundary turns at a vertex on it.
  double BoundaryCosine(const std::vector<Eigen::Vector3d>& position, Index vertex) const;

  /// Scores a choice: thickness, and turns by which the triangles' normals differ from those of the
  /// faces that they come from. False where one has no score above `least`. @pre Measure.
  bool Score(const std::vector<Eigen::Vector3d>& position, double least,
             CollapseChoice* choice) const;
};

}  // namespace cirque
