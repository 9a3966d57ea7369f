#pragma once

#include <utility>
#include <vector>

#include <Eigen/Core>

#include "cirque/core/solve_summary.h"
#include "cirque/core/types.h"
#include "cirque/math/moebius.h"
#include "cirque/solver/solver_strategy.h"

namespace cirque {

/// Points on the unit sphere with their weighted centre of mass at 0, and how they got there.
struct LorentzNormalization {
  std::vector<Eigen::Vector3d> points;
  /// Applied one after the other they carry the given points, or any others, to their new
  /// positions. (As one ball vector their product need not be representable: points within 1e-12 of
  /// each other need one that is 1e-24 from the sphere.)
  std::vector<LorentzBoost> boosts;
  SolveSummary summary;
};

/// Minimises the Lorentz energy (energy/lorentz_energy.h) by Newton's method in hyperbolic space,
/// always at the centre: step from x = 0, boost all points by the step, repeat. Steps are searched
/// along geodesics, where the energy is convex, so it converges from every start at which a
/// minimum exists; the gradient, the centre of mass of the boosted points for weights of sum 1, is
/// at most limits.gradient_tolerance at the end. (Ball coordinates instead fail where points crowd:
/// Newton's steps leave the ball.)
///
/// Bad input (a vector that is no unit vector to 1e-6, a weight that is not positive, no point, a
/// point with half of all weight, where the energy has no minimum) ends as kInvalidStart with a
/// message; the energy of the current points at 0 is always 0, so the summary's values say nothing.
LorentzNormalization MinimizeLorentz(const std::vector<Eigen::Vector3d>& points,
                                     const std::vector<double>& weights,
                                     const SolverLimits& limits = {},
                                     const SolveControl& control = {});

/// Edges between points on the unit sphere and what they measure elsewhere.
struct ScaledEdges {
  std::vector<std::pair<Index, Index>> ends;
  std::vector<double> length;  ///< > 0, in the metric to compare with
  std::vector<double> weight;  ///< >= 0, not all 0
};

/// The boosts that minimise a functional, to be applied one after the other.
struct LogScaleNormalization {
  std::vector<LorentzBoost> boosts;
  double value = kUnset;     ///< E at the end
  double gradient = kUnset;  ///< its largest derivative there, 0 at a minimum
  bool converged = false;
  int iterations = 0;
};

/// Minimises the area distortion of a map to the sphere over the Moebius group: the weighted mean
/// square
///   E   = sum_e w_e U_e^2 / sum_e w_e,
///   U_e = log |v_i - v_j| - log length_e,
/// of the log scale of the edges. Twice the log scale is the log of the area ratio, so lengths are
/// to be in the unit that gives the surface the area 4 pi. The boost by x scales chords exactly,
///   U_e(x) = U_e + 1/2 (f_i + f_j),   f_v = 1/2 log(1 - x.x) - log(1 - v.x),
/// so that at x = 0, with m_e = (v_i + v_j)/2 and shares w of sum 1,
///   grad E = 2 sum w U m,
///   Hess E = 2 sum w [m m' + U ((v_i v_i' + v_j v_j')/2 - I)].
/// Newton's method, re-centred as MinimizeLorentz is, with backtracking; where the Hessian is not
/// positive definite its first, Gauss-Newton part alone. E need not be convex: the minimum found is
/// one below the start. (The weighted mean of U itself is minus the Lorentz energy, but for a
/// constant.)
///
/// Ends unconverged at limits.max_iterations, or where no step makes E smaller.
LogScaleNormalization MinimizeLogScale(std::vector<Eigen::Vector3d> points,
                                       const ScaledEdges& edges, const SolverLimits& limits = {});

}  // namespace cirque
