#pragma once

#include "cirque/math/scalar_jet.h"

namespace cirque {

/// The two triangles at an edge, seen from their circumcentres. Circles of radii e^{rho_i} and
/// e^{rho_j} meet under the exterior angle theta in (0, pi); d = rho_i - rho_j, let
/// theta* = pi - theta. Everything here is free of overflow for |d| up to 1e4 and beyond, theta
/// from 1e-12 to pi - 1e-12.
///
/// Source: Bobenko, Springborn, Variational principles for circle patterns, Trans. AMS 356 (2004).

/// The intersection angle of the two circles and what the formulas need of it. Made from the corner
/// angles it keeps its relative accuracy also where theta* is tiny, which pi - theta would lose.
struct CircleAngle {
  double theta = 0.0;
  double sine = 0.0;              ///< sin theta
  double one_minus_cosine = 0.0;  ///< 1 - cos theta

  static CircleAngle FromExterior(double theta);
  /// theta = pi - alpha_i - alpha_j, alpha_i and alpha_j > 0 the angles opposite the edge; their
  /// sum is rounded only in the result.
  static CircleAngle FromCorners(double alpha_i, double alpha_j);

  /// That theta alone.
  static double Theta(double alpha_i, double alpha_j);
};

/// Half the angle [rad] under which face i sees the edge,
///   phi = atan2(sin theta, e^d - cos theta) = theta*/2 - atan(tanh(d/2) tan(theta*/2)),
/// which is also the corner angle opposite the edge. Relative error a few ulp, in the far tail
/// phi ~ e^{-d} sin theta too. HalfAngle(d, theta) + HalfAngle(-d, theta) = theta*.
double HalfAngle(double d, double theta);
double HalfAngle(double d, const CircleAngle& angle);

/// -2 dphi/dd = sin theta / (cosh d - cos theta): the weight of the edge in the Hessian of the
/// circle-pattern energy. Positive until it underflows; relative error a few ulp.
double HalfAngleWeight(double d, double theta);
double HalfAngleWeight(double d, const CircleAngle& angle);

/// dphi / dtheta* at fixed d: (e^-d + cos theta*) / (2 cosh d + 2 cos theta*), in (0, 1); those of d
/// and -d add up to 1.
double HalfAngleByThetaStar(double d, double theta_star);

/// The scalar element functions of the circle-pattern energy at an edge; notation of
/// circle_angle.h. The coherent angles alpha_i, alpha_j > 0 lie opposite the edge and have a
/// sum below pi; theta = pi - alpha_i - alpha_j.

/// psi(d) = Im Li2(e^{d + i theta}) + Im Li2(e^{-d + i theta})
///        = p d + Cl2(theta* + p) + Cl2(theta* - p) - Cl2(2 theta*),
/// slope p = 2 atan(tanh(d/2) tan(theta*/2)), curvature HalfAngleWeight(d, theta). Even, convex,
/// psi ~ theta* |d|. Relative error of each of the three about 1e-13 for |d| up to 1e4, theta from
/// 1e-12 to pi - 1e-12 (theta as given).
/// Source: Bobenko, Springborn, Trans. AMS 356 (2004); Lewin, Polylogarithms (1981), chapter 5.
ScalarJet EdgePotential(double d, double theta);

/// The value alone, where phi_i = HalfAngle(d, theta) and phi_j = HalfAngle(-d, theta) are known.
double EdgePotentialValue(double d, double theta, double phi_i, double phi_j);

/// d_e = log(sin alpha_j / sin alpha_i), where HalfAngle(d_e, theta) = alpha_i; relatively accurate
/// also where theta is small and with it d_e.
double MinimalLogRatio(double alpha_i, double alpha_j);

/// E(d) = psi_e(d) - psi_e(d_e), psi_e = psi + (alpha_i - alpha_j) d: the convex nonnegative part
/// that the edge adds to the energy. Slope 2 (alpha_i - phi_i(d)), curvature as for psi.
/// All relative errors below 1e-10, apart from that of d - d_e by rounding d_e: E is exact for a d
/// moved by a few ulp of d_e.
ScalarJet EdgeExcess(double d, double alpha_i, double alpha_j);

/// r(d) = sign(d - d_e) sqrt(2 E(d)) and dr/dd (sqrt(psi_e''(d_e)) at d_e): smooth and increasing.
/// Accuracy as for E.
ResidualJet EdgeResidual(double d, double alpha_i, double alpha_j);

}  // namespace cirque
