#pragma once

#include <vector>

#include <Eigen/SparseCore>
#include <ceres/first_order_function.h>
#include <ceres/problem.h>

namespace cirque {

/// A symmetric matrix by its lower triangle, compressed by columns.
using SparseMatrix = Eigen::SparseMatrix<double, Eigen::ColMajor, int>;

/// A convex function of n parameters that strategies minimise. It is a ceres::FirstOrderFunction,
/// so any Ceres line search takes it as it is:
///   Evaluate(x, value, gradient): gradient may be null; false when x is outside the domain.
/// Beyond that it gives its sparse Hessian, and where one is known an exact least-squares form.
class Energy : public ceres::FirstOrderFunction {
 public:
  /// The gradient alone, for stopping tests and line searches that need no value. Same contract as
  /// Evaluate.
  virtual bool Gradient(const double* x, double* gradient) const {
    double value;
    return Evaluate(x, &value, gradient);
  }

  /// The (generalised) Hessian's lower triangle. Its pattern may depend on x. False outside the
  /// domain.
  virtual bool Hessian(const double* x, SparseMatrix* lower) const = 0;

  /// Parameters to hold fixed, because the energy does not change along a kernel of that dimension
  /// (one for the scale of a circle pattern). The gradient is orthogonal to the kernel.
  virtual std::vector<int> GaugeParameters() const { return {}; }

  /// Least multiple of the identity to add to the Hessian: positive where it can be singular beyond
  /// the gauge.
  virtual double LeastHessianShift() const { return 0; }

  /// True when AddResidualBlocks gives residuals r with 1/2 |r(x)|^2 = E(x) - constant for all x in
  /// the domain.
  virtual bool HasExactResiduals() const { return false; }

  /// Adds the residual blocks on scalar parameter blocks x[0], ..., x[n - 1] and holds the gauge
  /// parameters constant. The problem owns its cost functions. @pre HasExactResiduals().
  virtual void AddResidualBlocks(double* x, ceres::Problem* problem) const;
};

}  // namespace cirque
