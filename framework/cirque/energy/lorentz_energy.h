#pragma once

#include <vector>

#include <Eigen/Core>

#include "cirque/energy/energy.h"

namespace cirque {

/// One point's part of the Lorentz energy, with its gradient and Hessian in x.
struct LorentzJet {
  double value = 0;
  Eigen::Vector3d slope = Eigen::Vector3d::Zero();
  Eigen::Matrix3d curvature = Eigen::Matrix3d::Zero();
};

/// log(1 - v.x) - 1/2 log(1 - x.x) for a unit vector v and |x| < 1: the signed hyperbolic distance
/// from x to the horosphere at v through the centre of Klein's ball. Slope x/(1 - x.x) - v/(1 -
/// v.x), curvature (I + 2 x x'/(1 - x.x))/(1 - x.x) - v v'/(1 - v.x)^2, both to a few ulp of their
/// largest entry however near x is to v or to the sphere.
LorentzJet LorentzElement(const Eigen::Vector3d& v, const Eigen::Vector3d& x);

/// The energy whose minimum centres points on the unit sphere:
///   S(x) = sum_v w_v [ log(1 - v.x) - 1/2 log(1 - x.x) ],   |x| < 1.
/// The boost by the minimiser (LorentzBoost) moves the weighted centre of mass to 0. S is convex
/// along hyperbolic geodesics, hence has one minimum, but not convex in x: minimise it where points
/// crowd by MinimizeLorentz (solver/lorentz_normalization.h), which re-centres.
/// Source: Springborn, A unique representation of polyhedral types, Math. Z. 249 (2005).
class LorentzEnergy final : public Energy {
 public:
  /// Unit vectors and their positive weights, which must outlive the energy.
  LorentzEnergy(const std::vector<Eigen::Vector3d>& points, const std::vector<double>& weights);

  int NumParameters() const override { return 3; }
  bool Evaluate(const double* x, double* value, double* gradient) const override;
  bool Hessian(const double* x, SparseMatrix* lower) const override;
  bool IsConvex() const override { return false; }

  /// One block of three residuals on three scalars.
  ResidualForm residual_form() const override { return ResidualForm::kGradient; }
  void AddResidualBlocks(double* x, ceres::Problem* problem) const override;

  /// Value, gradient and Hessian at once. @pre |x| < 1.
  LorentzJet Jet(const Eigen::Vector3d& x) const;

 private:
  const std::vector<Eigen::Vector3d>& points_;
  const std::vector<double>& weights_;
};

}  // namespace cirque
