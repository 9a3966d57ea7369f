#pragma once

#include <memory>
#include <string>

#include "cirque/core/registry.h"

namespace cirque {

/// What an objective says about one edge: g(s) = max over a in Q_e of [ s.a - phi(a) ], its
/// maximiser a (the gradient of g) and its (generalised) Hessian. At a boundary edge only the left
/// entries mean anything.
struct EdgeConjugate {
  double value = 0;
  double alpha_l = 0, alpha_r = 0;      ///< [rad]
  double h_ll = 0, h_lr = 0, h_rr = 0;  ///< d alpha / d s
};

/// A separable, convex distance phi_e(alpha_l, alpha_r) of an edge's two opposite corner angles
/// from reference angles, with the set Q_e = {alpha_l >= eps, alpha_r >= eps, alpha_l + alpha_r <=
/// pi - eps} (boundary: [eps, pi - eps]) that they may range over. A new objective is these four
/// functions; the dual energy, the primal strategies and the KKT report all follow from them.
class AngleObjective {
 public:
  virtual ~AngleObjective() = default;

  /// phi of an interior edge's two angles, of a boundary edge's one.
  virtual double Interior(double ref_l, double ref_r, double alpha_l, double alpha_r) const = 0;
  virtual double Boundary(double ref, double alpha) const = 0;

  /// Their conjugates over Q_e at the slopes s.
  virtual EdgeConjugate InteriorConjugate(double ref_l, double ref_r, double eps, double s_l,
                                          double s_r) const = 0;
  virtual EdgeConjugate BoundaryConjugate(double ref, double eps, double s) const = 0;
};

/// The table of objectives, one line an entry in angle_objective_registry.cc.
const Registry<std::shared_ptr<const AngleObjective>>& AngleObjectives();

}  // namespace cirque
