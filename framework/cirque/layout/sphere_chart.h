#pragma once

#include <vector>

#include <Eigen/Core>

#include "cirque/core/metric.h"
#include "cirque/core/triangulation.h"

namespace cirque {

/// Stereographic projection of the plane onto the unit sphere, from a window of the plane:
///   z -> (2 w, 1 - |w|^2) / (1 + |w|^2),  w = (z - centre) / scale.
/// The window's centre goes to (0, 0, 1), its circle of radius `scale` to the equator, infinity to
/// (0, 0, -1); counter-clockwise triangles are so seen from outside.
///
/// Up to rotations of the sphere every Moebius map of the plane onto it is one of these, (centre,
/// scale) being the point of the upper half-space that goes to the centre of the ball. So boosts of
/// the sphere are applied to the chart, never to points: the points are projected once from the
/// plane, however far they lie apart there, and lose nothing on the way.
struct SphereChart {
  Eigen::Vector2d centre = Eigen::Vector2d::Zero();
  double scale = 1;

  Eigen::Vector3d Lift(const Eigen::Vector2d& z) const;

  /// Where the plane's infinity goes.
  static Eigen::Vector3d Infinity() { return {0, 0, -1}; }

  /// The chart that carries the point `y` of Poincare's ball, |y| < 1, of this one to the centre.
  SphereChart Recentred(const Eigen::Vector3d& y) const;
};

/// A chart in which the points are spread well to start from: centre and scale are weighted medians
/// (of the coordinates, then of the distances), which no far or crowded points draw away.
/// @pre at least one point; weights >= 0, not all 0.
SphereChart BalancedChart(const std::vector<Eigen::Vector2d>& points,
                          const std::vector<double>& weights);

/// The point of Poincare's ball that boosts carry to the centre, one after the other, each given by
/// the point that it carries there (LorentzBoost::centre).
Eigen::Vector3d CentreOfBoosts(const std::vector<Eigen::Vector3d>& centres);

/// Latitude and longitude of a map to the unit sphere as texture coordinates.
struct LatLong {
  CornerUv uv;                  ///< 3F
  std::vector<Index> at_poles;  ///< faces with (0, 0, 1) or (0, 0, -1) inside: no two-dimensional
                                ///< triangle is their image, their third side spans the seam
};

/// Per corner
///   u = longitude / 2 pi + 1/2,   v = latitude / pi + 1/2.
/// The u of a triangle lie within 1/2 of each other, the least of them in [0, 1): triangles across
/// the date line are all at its eastern end and reach beyond 1, so that the texture opens along one
/// path of edges and none is smeared over it. A corner at a pole of the sphere, where longitude has
/// no meaning, gets the mean u of its triangle's others.
LatLong LatLongUv(const Triangulation& triangulation, const std::vector<Eigen::Vector3d>& position);

}  // namespace cirque
