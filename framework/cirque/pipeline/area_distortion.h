#pragma once

#include <memory>

#include <Eigen/Core>

#include "cirque/core/metric.h"
#include "cirque/energy/angle_objective.h"
#include "cirque/pipeline/flatten.h"

namespace cirque {

/// D = 1/2 sum_f a_f x_f^2 of a flat surface, x_f the logarithm of flat area over area of face f of
/// the triangulation where it was solved, a_f its area, all areas of total 1: half the square of
/// log_area_ratio_l2 there.
double AreaDistortion(const FlatSurface& flat);

/// dD / dTheta_v for every vertex (V; 0 where the angle sum is not prescribed), by the implicit
/// functions that the solves define: log radii rho(alpha) with grad S(rho, alpha) = 0, angles
/// alpha(Theta) = alpha(A' y) with A alpha = b. Two adjoint solves, with the Hessian of S and with
/// the dual's A P' A':
///   S'' lambda = D_rho,   q = D_alpha - lambda' (grad S)_alpha,   z = (A P' A')^-1 A P' q,
/// and dD / dTheta_v is z in the row of v. Where every vertex is prescribed it is known up to a
/// constant, since Gauss-Bonnet fixes the sum. D is smooth but where an inequality of the fit
/// becomes active.
///
/// `targets` are those of flat's triangulation, single angles; `objective` is that of the fit.
Eigen::VectorXd AreaDistortionGradient(const FlatSurface& flat, const ConeTargets& targets,
                                       const AngleObjective& objective);

}  // namespace cirque
