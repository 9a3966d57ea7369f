#pragma once

#include <vector>

#include <Eigen/Core>

#include "cirque/core/metric.h"
#include "cirque/core/triangulation.h"

namespace cirque {

/// The linear constraints A alpha = b of an angle fit and their multipliers' numbering: one row a
/// triangle (sum pi), then one row a vertex whose target interval is not all of [0, pi * corners].
/// Column h of A has a one in the row of the corner's face and, when its vertex is constrained, in
/// the row of that vertex.
class AngleConstraints {
 public:
  AngleConstraints(const Triangulation& triangulation, const ConeTargets& targets);

  int num_faces() const { return num_faces_; }
  int num_rows() const { return num_faces_ + static_cast<int>(constrained_vertices_.size()); }
  const std::vector<Index>& constrained_vertices() const { return constrained_vertices_; }
  const std::vector<Index>& corners() const { return corners_; }  ///< per vertex their number

  /// The row of the vertex at corner h, kNone when that vertex is free.
  int VertexRow(Index h) const { return row_of_vertex_[triangulation_.vertex[h]]; }

  /// (A'y)_h.
  double Slope(const double* y, Index h) const {
    const int row = VertexRow(h);
    return y[Triangulation::Face(h)] + (row == kNone ? 0 : y[row]);
  }

  /// The interval of a row's sum [rad]: [pi, pi] for a triangle, the target for a vertex.
  double Lower(int row) const { return lower_[row]; }
  double Upper(int row) const { return upper_[row]; }

  /// A alpha; into `sums`, of as many rows.
  void Apply(const Eigen::VectorXd& alpha, Eigen::Ref<Eigen::VectorXd> sums) const;
  Eigen::VectorXd Apply(const Eigen::VectorXd& alpha) const;

  /// True when some vertex sum may range over an interval.
  bool HasRanges() const { return lower_ != upper_; }

  /// True when every vertex is constrained: then y_f = 1, y_v = -1 is in the kernel of A'.
  bool HasGauge() const { return num_rows() == num_faces_ + triangulation_.num_vertices; }

  const Triangulation& triangulation() const { return triangulation_; }

 private:
  const Triangulation& triangulation_;
  int num_faces_;
  std::vector<Index> corners_, constrained_vertices_;
  std::vector<int> row_of_vertex_;
  std::vector<double> lower_, upper_;
};

}  // namespace cirque
