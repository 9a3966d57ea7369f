#pragma once

#include <Eigen/Core>

#include "cirque/core/solve_summary.h"
#include "cirque/energy/circle_pattern_energy.h"
#include "cirque/linear/system_solver.h"

namespace cirque {

/// A start for the log radii from the dual side (Rivin, Annals of Math. 139, 1994; Leibon, Geom.
/// Topol. 6, 2002). Among the angles of an interior edge that keep every triangle's sum,
///   phi_i = alpha_i + x_e,   phi_j = alpha_j - x_e,
/// the pattern's own maximise the concave volume
///   V(x) = sum_int L(phi_i) + L(phi_j)
///   V'   = log(sin phi_j / sin phi_i) =: G
///   -V'' = sin theta* / (sin phi_i sin phi_j).
/// Its Newton step is a weighted least-squares problem for the multipliers, which are the log radii:
///   minimise sum w (rho_i - rho_j - G)^2,   w = -1 / V'';
///   x += t w (G - (rho_i - rho_j)).
/// The first rho is the least-squares start (docs/mathematics.md, Radii). From there Newton on the
/// radii is lost among saturated half-angles where circles nearly touch (theta near its margin: 37
/// and over 100 steps measured on cgal meshes); on the angles, which those edges hardly constrain,
/// the same linear systems need 1 to 7, and the iterates stay coherent.
///
/// Stops when the circle-pattern energy's gradient at rho (F) is at most `gradient_max` [rad], or
/// when no more progress is made; no failure of its own: what is missing, the strategy that starts
/// from rho makes up or reports. `solver` then is ready for that strategy. The summary counts linear
/// algebra only.
SolveSummary MaximizePatternVolume(const Triangulation& triangulation, const CoherentAngles& angles,
                                   const CirclePatternEnergy& energy, double gradient_max,
                                   SystemSolver* solver, Eigen::VectorXd* rho);

/// Relative residual of the systems for changes of the multipliers.
inline constexpr double kVolumeTolerance = 1e-2;

/// Where MaximizePatternVolume makes its steps: on the whole surface, or on a rank's part of it.
class VolumeDomain {
 public:
  virtual ~VolumeDomain() = default;

  /// change = A^-1 (right_side - A rho), A damped. False where that fails.
  virtual bool SolveForChange(SparseMatrix* lower, const Eigen::VectorXd& right_side,
                              const Eigen::VectorXd& rho, Eigen::VectorXd* change) = 0;

  /// Of all parts, from this one's.
  virtual double Sum(double mine) = 0;
  virtual double Least(double mine) = 0;
  virtual double LargestEntry(const Eigen::VectorXd& gradient) = 0;

  /// Whether this part adds up the edges on whose left that face is.
  virtual bool Counts(Index face) const = 0;
};

/// MaximizePatternVolume in a domain, `angles` those of its triangulation.
void MaximizeVolume(const Triangulation& triangulation, const Eigen::VectorXd& angles,
                    const CirclePatternEnergy& energy, double gradient_max, VolumeDomain* domain,
                    Eigen::VectorXd* rho);

}  // namespace cirque
