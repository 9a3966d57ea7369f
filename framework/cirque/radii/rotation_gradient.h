#pragma once

#include <vector>

#include <Eigen/Core>

#include "cirque/core/metric.h"
#include "cirque/core/status.h"
#include "cirque/core/triangulation.h"
#include "cirque/intrinsic/dual_paths.h"

namespace cirque {

/// The derivatives of rotations of the flat metric, r_q = sum of w_h phi_h over the corners that
/// path q passes (FlatCornerAngles, w = +-1), by the coherent angles alpha whose pattern it is: 3F
/// x paths. The log radii are a function of alpha by grad S(rho, alpha) = 0, so that one solve a
/// path with the Hessian of S, the dual Laplacian, gives all:
///   phi_i = phi(d, theta*),  d = rho_i - rho_j,  theta* = alpha_i + alpha_j,
///   S'' lambda = sum over edges of (w_i - w_j) (dphi_i / dd) (e_i - e_j),
///   dr / dalpha_i = dr / dalpha_j = s (w_i + 2 lambda_i) + (1 - s) (w_j + 2 lambda_j),
/// s = dphi_i / dtheta* at fixed d; w + 2 lambda at a boundary edge. To first order changes of the
/// angles that keep all angle sums hardly change a rotation of a closed surface: a flat conformal
/// metric is given by its cones (M. Troyanov, "Les surfaces euclidiennes a singularites coniques",
/// 1986), and what is left is what the triangles differ from the smooth surface by.
///
/// Error (not converged): the Hessian has no factor, as at angles that are coherent but for
/// rounding.
StatusOr<Eigen::MatrixXd> RotationGradients(const Triangulation& triangulation,
                                            const CoherentAngles& angles, const LogRadii& log_radii,
                                            const std::vector<SignedCorners>& paths);

}  // namespace cirque
