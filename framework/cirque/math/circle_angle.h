#pragma once

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

}  // namespace cirque
