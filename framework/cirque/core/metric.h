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

/// For every vertex the closed interval for its angle sum Theta_v [rad]. Interior default [2 pi, 2
/// pi]; boundary default free: [0, pi * corners]. A cone is any other interval of an interior
/// vertex.
struct ConeTargets {
  std::vector<double> lower, upper;

  bool IsFixed(int v) const { return lower[v] == upper[v]; }
};

/// Interior vertices flat (2 pi), boundary vertices free.
ConeTargets FreeBoundaryTargets(const Triangulation& triangulation);

/// Corner angles of a flat, Delaunay triangulation: all >= epsilon, triangle sums pi, vertex sums
/// within their targets, alpha_l + alpha_r <= pi - epsilon on interior edges.
struct CoherentAngles {
  Eigen::VectorXd value;  ///< 3F [rad], index = halfedge opposite
  double epsilon = 0;     ///< the margin that was asked for [rad]
};

/// F natural logarithms of the circumradii, defined up to one constant.
struct LogRadii {
  Eigen::VectorXd value;
};

/// A point of the plane for every corner (3F), so that a vertex on a seam can have several.
struct CornerUv {
  std::vector<Eigen::Vector2d> value;
};

}  // namespace cirque
