#pragma once

#include <vector>

#include <Eigen/Core>

#include "experiments/verify_map/sphere_check.h"
#include "experiments/verify_map/topology.h"

namespace cirque::verify_map {

/// Signed areas of the spherical triangles over 4 pi.
double CoveringDegree(const FanMesh& mesh, const std::vector<Eigen::Vector3d>& sphere);

/// The smallest intersection angle of the circumcircles of two neighbours on the sphere [rad].
double SphericalDelaunayMargin(const FanMesh& mesh, const std::vector<Index>& twin,
                               const std::vector<Eigen::Vector3d>& sphere);

/// Length of the centre of mass, uniform or weighted by a third of the triangles' area on IN.
double CentreUniform(const FanMesh& mesh, const std::vector<Eigen::Vector3d>& sphere);
double CentreByArea(const FanMesh& mesh, const std::vector<Eigen::Vector3d>& position,
                    const std::vector<Eigen::Vector3d>& sphere);

SphereDistortion MeasureOnSphere(const FanMesh& mesh, const std::vector<Eigen::Vector3d>& position,
                                 const std::vector<Eigen::Vector3d>& sphere);

}  // namespace cirque::verify_map
