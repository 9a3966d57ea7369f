#pragma once

#include <vector>

#include <Eigen/Core>

#include "cirque/cones/cone.h"
#include "cirque/cones/cone_problem.h"

namespace cirque {

/// Curvature gathered at one vertex.
struct CurvatureCluster {
  Index vertex = kNone;  ///< of the greatest |mu| in the cluster
  double curvature = 0;  ///< [rad], all of it
};

/// The clusters of a curvature measure mu (V, [rad]): connected sets of vertices of one sign with
/// |mu| above `threshold`, those of greatest |curvature| first.
std::vector<CurvatureCluster> ClusterCurvature(const Triangulation& triangulation,
                                               const Eigen::VectorXd& mu, double threshold);

/// At most `count` cones at the clusters of greatest curvature, as far as the corners allow, with
/// the admissible curvatures of least distortion. Where there are fewer clusters than a closed
/// surface needs, vertices with many corners are added. Error as of ConeChoice::Make.
StatusOr<std::vector<Cone>> ConesAtClusters(const ConeProblem& problem,
                                            const std::vector<CurvatureCluster>& clusters,
                                            int count);

}  // namespace cirque
