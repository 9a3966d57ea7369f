#pragma once

#include <vector>

#include <Eigen/Core>

#include "cirque/core/solve_summary.h"
#include "cirque/math/lorentz.h"
#include "cirque/solver/solver_strategy.h"

namespace cirque {

/// Points on the unit sphere with their weighted centre of mass at 0, and how they got there.
struct LorentzNormalization {
  std::vector<Eigen::Vector3d> points;
  /// Applied one after the other they carry the given points, or any others, to the new places. (As
  /// one ball vector their product need not be representable: points within 1e-12 of each other
  /// want one that is 1e-24 from the sphere.)
  std::vector<LorentzBoost> boosts;
  SolveSummary summary;
};

/// Minimises the Lorentz energy (energy/lorentz_energy.h) by Newton's method in hyperbolic space,
/// always at the centre: step from x = 0, boost all points by the step, repeat. Steps are searched
/// along geodesics, where the energy is convex, so it converges from every start at which a
/// minimum exists; the gradient, the centre of mass of the boosted points for weights of sum 1, is
/// at most limits.gradient_tolerance at the end. (Ball coordinates instead fail where points crowd:
/// Newton's steps leave the ball.)
/// Bad input (a vector that is no unit vector to 1e-6, a weight that is not positive, no point, a
/// point with half of all weight, where the energy has no minimum) ends as kInvalidStart with a
/// message; the energy of the current points at 0 is always 0, so the summary's values say nothing.
LorentzNormalization MinimizeLorentz(const std::vector<Eigen::Vector3d>& points,
                                     const std::vector<double>& weights,
                                     const SolverLimits& limits = {},
                                     const SolveControl& control = {});

}  // namespace cirque
