#pragma once

#include <array>
#include <vector>

#include <Eigen/Core>

#include "cirque/core/metric.h"
#include "cirque/core/triangulation.h"
#include "cirque/energy/energy.h"
#include "cirque/intrinsic/ptolemy_complex.h"

namespace cirque {

/// One triangle's part of the conformal-equivalence energy, of the logarithms x_k of its sides, side
/// k opposite corner k.
struct EquivalenceJet {
  double value = 0;
  std::array<double, 3> slope{};      ///< by x_k
  std::array<double, 3> cotangent{};  ///< cot alpha_k, what the second derivatives are made of
};

/// 2 sum_k (alpha_k x_k + L(alpha_k)) - pi sum_k x_k, L Lobachevsky's function, with slopes
/// 2 alpha_k - pi: convex, and where there is no such triangle linear, with the angles 0, 0, pi of
/// the degenerate one. (Bobenko, Pinkall, Springborn 2015, section 4.2.)
EquivalenceJet EquivalenceElement(const std::array<double, 3>& log_side,
                                  const LogTriangle& triangle);

/// Which scales are sought, for which angle sums.
struct ScaleTargets {
  std::vector<int> parameter;  ///< V: number of the vertex's scale; kNone: held at u = 0
  Eigen::VectorXd angle_sum;   ///< of each scale: prescribed sum over its vertices' corners [rad]
};

/// A scale for every vertex whose angle sum is prescribed (lower = upper); the others are held.
ScaleTargets TargetsOfScales(const ConeTargets& targets);

/// The energy whose minimum is a discretely conformally equivalent flat metric: of log scales u at
/// the vertices, with l~_ij = e^((u_i + u_j) / 2) l_ij,
///   E(u) = sum_ijk [ 2 sum_k (alpha_k log l~_ij + L(alpha_k)) - pi sum log l~_ij ]
///          + sum_i Theta_i u_i
///   dE/du_i = Theta_i - sum of the corner angles alpha at i
///   d2E/du_i du_j = -1/2 (cot alpha_k + cot alpha_l),
/// half the cotangent Laplacian whose weights are sums of cotangents. Convex; where no vertex is
/// held, invariant under adding a constant to u if the targets obey Gauss-Bonnet (the gauge: scale
/// 0 is fixed).
///
/// On a fixed triangulation (kNever) a minimum need not exist among triangles; E then is that of
/// Bobenko, Pinkall and Springborn (2015, section 4), once continuously differentiable. With
/// Ptolemy flips (kPtolemy) every u is evaluated on the triangulation that is Delaunay for it. E
/// then depends on u alone and is twice continuously differentiable, strictly convex but for the
/// gauge, and on a closed surface has a minimum for all Theta > 0 with Gauss-Bonnet: the existence
/// of that metric (X. Gu, F. Luo, J. Sun, T. Wu, "A discrete uniformization theorem for polyhedral
/// surfaces", J. Differential Geom. 109, 2018; Springborn 2020). Across a flip four points lie on
/// a circle, the flipped edge's angles add up to pi and the weight of both diagonals is 0.
///
/// With flips the triangulation of the last point is kept, where the next one begins: one energy is
/// not to be evaluated by several threads at once.
class ConformalEquivalenceEnergy final : public Energy {
 public:
  enum class Flips { kNever, kPtolemy };

  /// `log_lengths`: E. `scaled_by`: V, scales that u is counted from, so that small ones of either
  /// keep their digits; empty: 0.
  ConformalEquivalenceEnergy(const Triangulation& triangulation, const Eigen::VectorXd& log_lengths,
                             ScaleTargets targets, Flips flips = Flips::kPtolemy,
                             const std::vector<TripleDouble>& scaled_by = {});

  int NumParameters() const override { return static_cast<int>(targets_.angle_sum.size()); }
  bool Evaluate(const double* u, double* value, double* gradient) const override;
  bool Gradient(const double* u, double* gradient) const override;
  bool Hessian(const double* u, SparseMatrix* lower) const override;
  std::vector<int> GaugeParameters() const override;
  double LeastDamping() const override { return flips_ == Flips::kNever ? 1e-9 : 0; }

  /// The scale of every vertex (V), 0 where held.
  Eigen::VectorXd ScaleOfVertices(const double* u) const;

 private:
  bool MoveTo(const double* u) const;
  void AddSlopes(double* gradient) const;

  const ScaleTargets targets_;
  const Flips flips_;
  mutable PtolemyComplex complex_;              ///< Delaunay for scale_
  mutable Eigen::VectorXd scale_;               ///< V, of the last point
  mutable std::vector<LogTriangle> triangles_;  ///< there
  mutable bool has_moved_ = false;              ///< to the triangulation of that point
};

}  // namespace cirque
