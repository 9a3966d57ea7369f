#pragma once

namespace cirque {

/// A function of one variable with its first two derivatives at a point: what an element of a sum
/// (an edge, a corner) hands to value, gradient and Hessian alike.
struct ScalarJet {
  double value = 0.0;
  double slope = 0.0;
  double curvature = 0.0;
};

/// A least-squares residual r of one variable and dr/dx: r^2/2 is the convex function that it
/// stands for, the sign of r tells the side of the minimum, so that r is smooth there.
struct ResidualJet {
  double value = 0.0;
  double slope = 0.0;
};

}  // namespace cirque
