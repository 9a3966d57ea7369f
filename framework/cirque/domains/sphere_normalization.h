#pragma once

#include <string>
#include <vector>

#include "cirque/core/status.h"
#include "cirque/layout/sphere_chart.h"
#include "cirque/mesh/surface.h"

namespace cirque {

/// How the Moebius map that is left free is fixed, up to a rotation:
///   none                   points spread about their median in the plane
///   uniform                centre of mass of the vertices at 0
///   surface_area           the same, vertices weighted by a third of their triangles' area
///   image_area             the same with the area of the triangles on the sphere
///   least_area_distortion  least mean square of the log area ratio
///   (layout/log_scale_normalization.h)
const std::vector<std::string>& SphereNormalizations();

/// The vertices of a surface in the plane, one of them at infinity.
struct PlaneWithPole {
  Index pole = kNone;
  std::vector<Eigen::Vector2d> position;  ///< per vertex; the pole's means nothing
};

/// All vertices on the sphere.
std::vector<Eigen::Vector3d> LiftAll(const PlaneWithPole& plane, const SphereChart& chart);

/// A third of the area of its triangles for every vertex, total 1.
std::vector<double> VertexAreas(const Triangulation& triangulation,
                                const std::vector<Eigen::Vector3d>& position);

/// The chart to the sphere and how well it meets its condition.
struct NormalizedChart {
  SphereChart chart;
  std::vector<double> weights;  ///< per vertex, total 1: those whose centre of mass is reported
  int iterations = 0;           ///< Newton steps
  double residual = 0;          ///< centre of mass, or gradient of the area distortion
};

/// The chart of that normalisation. Errors: unknown name; kNotConverged when the condition is met
/// worse than by 1e-12 (log scale: by a gradient of 1e-9).
StatusOr<NormalizedChart> NormalizeChart(const Surface& surface, const PlaneWithPole& plane,
                                         const std::string& normalization);

/// LiftAll, with `principal_axes` turned as described at DomainOptions.
std::vector<Eigen::Vector3d> LiftAll(const Surface& surface, const PlaneWithPole& plane,
                                     const SphereChart& chart, bool principal_axes);

/// The rotation to the principal axes described at DomainOptions.
Eigen::Matrix3d PrincipalAxes(const std::vector<Eigen::Vector3d>& points,
                              const std::vector<double>& weights);

}  // namespace cirque
