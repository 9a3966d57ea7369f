#pragma once

#include <vector>

#include <Eigen/Core>

#include "cirque/core/triangulation.h"

namespace cirque {

/// One length per edge of a Triangulation: with it, the intrinsic metric.
struct EdgeLengths {
  Eigen::VectorXd value;
};

/// 3F corner angles [rad], indexed by the halfedge opposite the corner. Each face sums to pi.
struct CornerAngles {
  Eigen::VectorXd value;
};

/// For every vertex the closed interval for its angle sum Theta_v [rad]. Interior default [2 pi, 2 pi];
/// boundary default free: [0, pi * corners]. A cone is any other interval of an interior vertex.
struct ConeTargets {
  std::vector<double> lower, upper;

  bool IsFixed(int v) const { return lower[v] == upper[v]; }
};

/// Interior vertices flat (2 pi), boundary vertices free.
ConeTargets FreeBoundaryTargets(const Triangulation& triangulation);

/// Corner angles of a flat Delaunay triangulation:
///   alpha >= margin                           at every corner,
///   alpha_l + alpha_r <= pi - margin          at every interior edge,
///   sum of alpha in f = pi                    for every face f,
///   sum of alpha at v in [lower_v, upper_v]   for every vertex v.
struct CoherentAngles {
  Eigen::VectorXd value;  ///< 3F [rad], index = halfedge opposite
  double epsilon = 0;     ///< the largest of the margins [rad]; 0: a flat surface as it is
};

/// F natural logarithms of the circumradii, defined up to one constant.
struct LogRadii {
  Eigen::VectorXd value;
};

/// A point of the plane for every corner (3F), so that a vertex on a seam can have several.
struct CornerUv {
  std::vector<Eigen::Vector2d> value;
};

/// How far the prescribed angle sums are from what a flat metric needs [rad]: triangle sums add up
/// to pi F, so vertex sums must. That is Gauss-Bonnet: the curvatures 2 pi - Theta_v inside and
/// pi - Theta_v on the boundary add up to 2 pi chi.
struct GaussBonnetDefect {
  double lower = 0;  ///< sum of the targets' lower ends minus pi F
  double upper = 0;  ///< sum of the targets' upper ends minus pi F

  /// Whether some choice within the intervals adds up, to within `tolerance` [rad].
  bool IsZeroPossible(double tolerance) const { return lower <= tolerance && upper >= -tolerance; }
};

/// The defect. Equals 2 pi chi when every vertex of a closed surface is flat; exact where all targets
/// are multiples of pi / 2. @pre one interval a vertex.
GaussBonnetDefect MeasureGaussBonnetDefect(const Triangulation& triangulation,
                                           const ConeTargets& targets);

}  // namespace cirque
