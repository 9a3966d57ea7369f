#pragma once

#include <Eigen/Core>

#include "cirque/core/infeasibility.h"
#include "cirque/energy/angle_constraints.h"

namespace cirque {

/// sum_f y_f + sum_v y_v (y_v > 0 ? lower_v : upper_v) - sum_e max over Q_e of (A'y)_e . a, in
/// units of pi: positive exactly when y proves that no coherent angles with this margin exist.
/// Homogeneous in y.
double InfeasibilityMargin(const AngleConstraints& constraints, double epsilon,
                           const Eigen::VectorXd& y);

/// Tries to turn multipliers along which the dual falls without bound into a proof: first one for
/// margin 0 (no coherent angles at all; rounding y to small integer multiples finds proofs that
/// hold with equality there), then one for `epsilon`. An empty proof means that y proves nothing;
/// one that is returned has passed ProvesExactly.
InfeasibilityCertificate ProveInfeasible(const AngleConstraints& constraints, double epsilon,
                                         const Eigen::VectorXd& y);

/// ProveInfeasible for given multipliers at margin 0 without any test in floating point: for proofs
/// known in advance. Empty when they prove nothing.
InfeasibilityCertificate CertificateFrom(const AngleConstraints& constraints,
                                         const Eigen::VectorXd& y);

/// Watches a fit's multipliers for a proof of infeasibility: where no coherent angles exist they
/// run off along one, so both the iterate and its last step are candidates, but where that hardly
/// moved.
class InfeasibilityWatch {
 public:
  /// `margin` of Q_e; negative: there are no inequalities, nothing can be proven.
  InfeasibilityWatch(const AngleConstraints& constraints, double margin)
      : constraints_(constraints), margin_(margin) {}

  /// True once a proof has been found.
  bool Found(const Eigen::VectorXd& y);

  const InfeasibilityCertificate& proof() const { return proof_; }

 private:
  const AngleConstraints& constraints_;
  const double margin_;
  Eigen::VectorXd previous_;
  InfeasibilityCertificate proof_;
};

}  // namespace cirque
