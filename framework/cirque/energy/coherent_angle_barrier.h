#pragma once

#include <memory>
#include <vector>

#include <Eigen/Core>

#include "cirque/core/metric.h"
#include "cirque/core/triangulation.h"
#include "cirque/energy/angle_objective.h"
#include "cirque/energy/energy.h"

namespace cirque {

/// The thesis's nonlinear energy of all 3F corner angles [rad], without the constraints on their
/// sums:
///   E(alpha) = sum_corners delta(alpha; alpha0) + sum_edges delta(theta; theta0),
///   theta = pi - alpha_l - alpha_r (boundary: pi - alpha),
/// delta the Itakura-Saito divergence of BarrierObjective, references clamped as it does. Strictly
/// convex; its domain is alpha > 0, theta > 0. Exact least squares: a residual a corner, in that
/// angle, and one an edge, in the angles opposite.
/// docs/errata.md says what is wrong with the printed formula.
class CoherentAngleBarrier final : public Energy {
 public:
  /// `epsilon` [rad]: the least reference angle.
  CoherentAngleBarrier(const Triangulation& triangulation, const CornerAngles& reference,
                       double epsilon);

  int NumParameters() const override { return static_cast<int>(reference_.size()); }
  bool Evaluate(const double* alpha, double* value, double* gradient) const override;
  bool Hessian(const double* alpha, SparseMatrix* lower) const override;
  ResidualForm residual_form() const override { return ResidualForm::kExact; }
  void AddResidualBlocks(double* alpha, ceres::Problem* problem) const override;

  /// How many reference angles, corners and intersections, were below epsilon.
  int num_clamped() const { return num_clamped_; }

 private:
  struct Edge {
    int l, r;          ///< its corners; r is kNone on the boundary
    double reference;  ///< theta0
  };

  double Clamp(double reference, double epsilon);
  double Theta(const Edge& edge, const double* alpha) const;
  bool IsInside(const double* alpha) const;

  std::shared_ptr<const AngleObjective> objective_;
  Eigen::VectorXd reference_;
  std::vector<Edge> edges_;
  int num_clamped_ = 0;
};

}  // namespace cirque
