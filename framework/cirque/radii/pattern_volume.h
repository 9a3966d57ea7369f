#pragma once

#include <Eigen/Core>

#include "cirque/core/metric.h"
#include "cirque/core/triangulation.h"
#include "cirque/energy/circle_pattern_energy.h"
#include "cirque/linear/system_solver.h"

namespace cirque {

/// A start for the log radii from the dual side (Rivin, Annals of Math. 139, 1994; Leibon, Geom.
/// Topol. 6, 2002). Among the angles phi_i = alpha_i + x_e, phi_j = alpha_j - x_e of an interior
/// edge that keep every triangle's sum, the pattern's own maximise the concave volume
///   V(x) = sum_int L(phi_i) + L(phi_j),
///   V' = log(sin phi_j / sin phi_i) =: G,      -V'' = sin theta* / (sin phi_i sin phi_j).
/// Its Newton step is a weighted least-squares problem for the multipliers, which are the log
/// radii:
///   minimise sum w (rho_i - rho_j - G)^2, w = -1 / V'';      x += t w (G - (rho_i - rho_j)).
/// The first rho is the least-squares start (docs/mathematics.md, Radii). From there Newton on the
/// radii is lost among saturated half-angles where circles nearly touch (theta near its margin: 37
/// and over 100 steps measured on cgal meshes); on the angles, which those edges hardly constrain,
/// the same linear systems need 1 to 7, and the iterates stay coherent.
///
/// Stops when the circle-pattern energy's gradient at rho is at most `gradient_max` [rad], or when
/// no more progress is made. `solver` then is ready for the radii's own strategy. The summary
/// counts linear algebra only.
SolveSummary MaximizePatternVolume(const Triangulation& triangulation, const CoherentAngles& angles,
                                   const CirclePatternEnergy& energy, double gradient_max,
                                   SystemSolver* solver, Eigen::VectorXd* rho);

}  // namespace cirque
