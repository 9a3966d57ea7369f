#pragma once

#include <vector>

#include <ceres/first_order_function.h>
#include <ceres/problem.h>

#include "cirque/linear/sparse_matrix.h"

namespace cirque {

/// What AddResidualBlocks gives.
enum class ResidualForm {
  kAbsent,    ///< nothing
  kExact,     ///< residuals r with 1/2 |r(x)|^2 = E(x) - constant for all x in the domain
  kGradient,  ///< r = grad E with the Hessian as Jacobian: 1/2 |r|^2 is not E but vanishes with its
              ///< gradient, and J'J = H^2
};

class EnergySource;
class ParameterSpace;

/// Where an energy has a kink: at 0 of this parameter its slope jumps upwards by `jump` >= 0.
struct Kink {
  int parameter;
  double jump;
};

/// A function of n parameters that strategies minimise. It is a ceres::FirstOrderFunction, so any
/// Ceres line search takes it as it is:
///   Evaluate(x, value, gradient): gradient may be null; false when x is outside the domain, which
///   a NaN or an infinity always is.
/// Beyond that it gives its sparse Hessian, and where one is known a least-squares form.
class Energy : public ceres::FirstOrderFunction {
 public:
  /// The gradient alone, for stopping tests and line searches that need no value. Same contract as
  /// Evaluate.
  virtual bool Gradient(const double* x, double* gradient) const {
    double value;
    return Evaluate(x, &value, gradient);
  }

  /// What belongs to these parameters of the value of a sum over edges: every term is that of one
  /// parameter, so that the shares of parameters that together are all add up to the value. False
  /// outside the domain, and of energies that are taken as a whole (source()).
  virtual bool Share(const double* /*x*/, const std::vector<bool>& /*own*/,
                     double* /*share*/) const {
    return false;
  }

  /// How ranks take this energy in parts; null: they do not.
  virtual const EnergySource* source() const { return nullptr; }

  /// Where its vectors of parameters live.
  virtual const ParameterSpace& space() const;

  /// The (generalised) Hessian's lower triangle. Its pattern may depend on x. False outside the
  /// domain.
  virtual bool Hessian(const double* x, SparseMatrix* lower) const = 0;

  /// The lower triangle of a matrix near the Hessians around x but for few rows: a graph's weighted
  /// Laplacian, which multigrid takes better than what an energy's Hessian may have in those rows.
  /// False where the Hessian itself is such a matrix.
  virtual bool SmoothHessian(const double* /*x*/, SparseMatrix* /*lower*/) const { return false; }

  /// Whether the Hessian is positive semidefinite in the whole domain.
  virtual bool IsConvex() const { return true; }

  /// Parameters to hold fixed, because the energy does not change along a kernel of that dimension
  /// (one for the scale of a circle pattern). The gradient is orthogonal to the kernel.
  virtual std::vector<int> GaugeParameters() const { return {}; }

  /// Least multiple of the identity to add to the Hessian: positive where it can be singular beyond
  /// the gauge.
  virtual double LeastDamping() const { return 0; }

  /// The parameters at whose 0 the energy is not differentiable. There Evaluate gives the slope
  /// from below; everywhere else the energy is as smooth as without kinks.
  virtual std::vector<Kink> Kinks() const { return {}; }

  /// Lowers the energy where few entries of the gradient stand out, at the cost of those: minimises
  /// over single parameters in turn until no entry exceeds `threshold`. `gradient` is that at x
  /// before and after. Newton's linear systems see what happens all over the domain but
  /// not how the Hessian changes along the step; this sees the other half (nonlinear elimination:
  /// P. Lanzkron, D. Rose, J. Wilkes, SIAM J. Sci. Comput. 17, 1996). False, and nothing done, by
  /// energies that have no use for it.
  virtual bool Relax(double /*threshold*/, double* /*x*/, double* /*gradient*/) const {
    return false;
  }

  virtual ResidualForm residual_form() const { return ResidualForm::kAbsent; }

  /// Adds the residual blocks on scalar parameter blocks x[0], ..., x[n - 1] and holds the gauge
  /// parameters constant. The problem owns its cost functions. @pre residual_form() is not kAbsent.
  virtual void AddResidualBlocks(double* x, ceres::Problem* problem) const;

 protected:
  /// Whether all n parameters are finite, which every domain demands.
  bool AllFinite(const double* x) const;
};

}  // namespace cirque
