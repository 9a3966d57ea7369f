#pragma once

#include <Eigen/Core>

#include "cirque/core/infeasibility.h"
#include "cirque/core/metric.h"
#include "cirque/core/status.h"
#include "cirque/core/triangulation.h"
#include "cirque/energy/angle_constraints.h"
#include "cirque/intrinsic/intrinsic_surface.h"

namespace cirque {

/// Certificates of infeasibility (core/infeasibility.h): how a fit finds them, which are known before
/// anything is solved, and the test without rounding that every one has passed.

/// What multipliers y (a row each) certify:
///   sum_f y_f + sum_v y_v (y_v > 0 ? lower_v : upper_v) - sum_e max over a in Q_e of (A'y)_e . a
/// in units of pi. Positive exactly when y certifies that no coherent angles with this margin
/// [rad] exist. Homogeneous in y.
double InfeasibilityMargin(const AngleConstraints& constraints, double epsilon,
                           const Eigen::VectorXd& y);

/// Whether the certificate's inequality holds for its doubles exactly, in integer arithmetic:
/// strictly for epsilon > 0. For epsilon = 0 equality is enough as soon as A'y is not zero: coherent
/// angles lie in the interior of every Q_e, where a linear function that is not constant stays below
/// its maximum. False for numbers that are not finite, for the wrong number of them and for epsilon
/// outside [0, pi / 3).
bool HoldsExactly(const Triangulation& triangulation, const InfeasibilityCertificate& certificate);

/// Tries to turn multipliers along which the dual falls without bound into a certificate: first one
/// for margin 0 (no coherent angles at all; rounding y to small integer multiples finds those that
/// hold with equality there), then one for `epsilon` [rad]. Empty: y certifies nothing. What is
/// returned has passed HoldsExactly.
InfeasibilityCertificate FindInfeasibilityCertificate(const AngleConstraints& constraints,
                                                      double epsilon, const Eigen::VectorXd& y);

/// The certificate of given multipliers at margin 0 without any test in floating point: for those
/// known in advance. Empty when they certify nothing.
InfeasibilityCertificate InfeasibilityCertificateFrom(const AngleConstraints& constraints,
                                                      const Eigen::VectorXd& y);

/// Watches a fit's multipliers for a certificate of infeasibility: where no coherent angles exist
/// they run off along one, so both the iterate and its last step are candidates, except where that
/// hardly moved.
class InfeasibilityWatch {
 public:
  /// `margin` of Q_e [rad]; negative: there are no inequalities, nothing can be certified.
  InfeasibilityWatch(const AngleConstraints& constraints, double margin)
      : constraints_(constraints), margin_(margin) {}

  /// True once a certificate has been found.
  bool Found(const Eigen::VectorXd& y);

  const InfeasibilityCertificate& certificate() const { return certificate_; }

 private:
  const AngleConstraints& constraints_;
  const double margin_;
  Eigen::VectorXd previous_;
  InfeasibilityCertificate certificate_;
};

/// Refuses angle sums that no angles can have, before anything is solved. Messages name the
/// vertices (0-based) and say what is missing. Errors:
///   kInvalidInput  the wrong number of targets; one that is not finite or negative; lower > upper
///   kInfeasible    a vertex that must reach pi or more at each of its corners on average (an inner
///                  vertex of valence 1 or 2 at 2 pi, a cone angle of valence * pi); one whose sum
///                  must be 0; on a surface where every vertex is constrained, sums of the targets
///                  that miss pi F by more than 1e-9 rad (Gauss-Bonnet: sum of lower > pi F, or of
///                  upper < pi F)
/// With kInfeasible, `certificate` (may be null) gets the certificate, unless rounding is all that
/// speaks against the exact inequality: then it is empty.
Status CheckTargets(const IntrinsicSurface& surface, const ConeTargets& targets,
                    InfeasibilityCertificate* certificate = nullptr);

/// What of that holds on every triangulation of the surface: all but the corners.
Status CheckAngleSums(const IntrinsicSurface& surface, const ConeTargets& targets,
                      InfeasibilityCertificate* certificate = nullptr);

}  // namespace cirque
