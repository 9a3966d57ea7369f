#pragma once

#include <vector>

#include <Eigen/Core>
#include <ceres/sized_cost_function.h>

#include "cirque/core/metric.h"
#include "cirque/core/triangulation.h"
#include "cirque/energy/dual_laplacian.h"
#include "cirque/energy/energy.h"
#include "cirque/math/circle_angle.h"

namespace cirque {

/// The exact least-squares form of one interior edge of a circle pattern, in the two log radii
/// beside it:
///   r(rho_i, rho_j) = sign(d - d_e) sqrt(2 (psi_e(d) - psi_e(d_e))),   d = rho_i - rho_j,
/// psi_e' = 2 (alpha_i - phi_i(d)), d_e = log(sin alpha_j / sin alpha_i). Smooth, also at d_e.
/// jacobians[0][0] = dr/dd = -jacobians[1][0].
class CirclePatternResidual final : public ceres::SizedCostFunction<1, 1, 1> {
 public:
  CirclePatternResidual(double alpha_i, double alpha_j) : alpha_i_(alpha_i), alpha_j_(alpha_j) {}

  bool Evaluate(double const* const* rho, double* residual, double** jacobians) const override;

 private:
  double alpha_i_, alpha_j_;  ///< coherent corner angles opposite the edge [rad]
};

/// The Euclidean circle-pattern energy of log radii rho (Bobenko & Springborn; KSS06 eq. 4 with the
/// boundary factor 2 that the thesis lacks), theta* = alpha_l + alpha_r at an interior edge and
/// alpha at a boundary one:
///   S(rho) = sum_int [ Im Li2(e^{d + i theta}) + Im Li2(e^{-d + i theta}) - theta* (rho_i + rho_j)
///   ]
///            - sum_bdry 2 theta* rho_i + 2 pi sum_f rho_f,            d = rho_i - rho_j
///   dS/drho_i = 2 pi - sum_int 2 phi_i - sum_bdry 2 theta*
/// At its minimum phi_i is the corner angle opposite the edge in the flat triangle i. Convex;
/// invariant under adding a constant to rho (the gauge: face 0 is fixed).
///
/// The constructor takes *coherent* angles, which also split S into one convex function an edge
/// (EdgeExcess): its exact least-squares form.
class CirclePatternEnergy final : public Energy {
 public:
  /// `triangulation` must outlive the energy. @pre all angles positive, alpha_l + alpha_r < pi.
  CirclePatternEnergy(const Triangulation& triangulation, const CoherentAngles& angles);

  int NumParameters() const override { return num_faces_; }
  bool Evaluate(const double* rho, double* value, double* gradient) const override;
  bool Gradient(const double* rho, double* gradient) const override;
  bool Share(const double* rho, const std::vector<bool>& own, double* share) const override;
  bool Hessian(const double* rho, SparseMatrix* lower) const override;
  std::vector<int> GaugeParameters() const override { return {0}; }
  ResidualForm residual_form() const override { return ResidualForm::kExact; }
  void AddResidualBlocks(double* rho, ceres::Problem* problem) const override;

  /// That of the triangulation, for other weights on the same pattern.
  const DualLaplacian& laplacian() const { return laplacian_; }

  /// The constant with 1/2 |r|^2 = S - ResidualOffset().
  double ResidualOffset() const;

 private:
  /// The terms of the faces that `counts` says so of, and of the edges on whose left they are.
  template <class Counts>
  double Sum(const double* rho, const Counts& counts) const;

  struct InteriorEdge {
    Index h, g;               ///< the halfedge and its twin
    double alpha_i, alpha_j;  ///< their corner angles opposite the edge
    CircleAngle angle;        ///< of intersection, accurate where theta or theta* is tiny
    /// The faces left of them.
    int i() const { return Triangulation::Face(h); }
    int j() const { return Triangulation::Face(g); }
    /// d_e: the log ratio at which both halves agree with the coherent angles.
    double natural_d() const;
  };
  class EdgeChunk;

  int num_faces_;
  std::vector<InteriorEdge> edges_;
  DualLaplacian laplacian_;
  Eigen::VectorXd boundary_star_;  ///< per face: 2 pi - sum over its boundary edges of 2 theta*
};

}  // namespace cirque
