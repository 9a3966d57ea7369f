#pragma once

#include <vector>

#include <Eigen/Core>

#include "cirque/cones/cone.h"
#include "cirque/cones/cone_fit.h"
#include "cirque/cones/cone_problem.h"

namespace cirque {

/// How far a field known up to a constant on closed surfaces (u, or ConeFit::Descent) is at each
/// vertex from its level at the cones so far, 0 with a boundary. Before there are cones on a closed
/// surface: from its end that lies away from where curvature of the sign of chi is wanted. V.
Eigen::VectorXd DistanceFromCones(const ConeProblem& problem, const ConeFit& fit,
                                  const Eigen::VectorXd& field);

/// At most `count` cones with the admissible curvatures of least distortion, each put where a
/// little curvature lowers the distortion of those before it most, among the vertices that are
/// `allowed` (V). Where these are too few for Gauss-Bonnet, vertices with many corners are added.
/// Error (invalid input) as of ConeChoice::Make.
StatusOr<std::vector<Cone>> PlaceByDescent(const ConeProblem& problem,
                                           const std::vector<bool>& allowed, int count);

/// The vertices that carry more curvature than `threshold` [rad] of a measure mu (V).
std::vector<bool> Support(const Eigen::VectorXd& mu, double threshold);

/// The number of connected sets of such vertices of one sign.
int NumClusters(const Triangulation& triangulation, const Eigen::VectorXd& mu, double threshold);

}  // namespace cirque
