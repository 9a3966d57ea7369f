#pragma once

#include <vector>

#include <Eigen/Core>

#include "cirque/audit/audit_energy.h"

namespace cirque {

/// Each notes the figures of one case; see AuditChecks.
void CheckGradient(const AuditCase& c, AuditFinding* finding);
void CheckHessian(const AuditCase& c, AuditFinding* finding);
void CheckSymmetry(const AuditCase& c, AuditFinding* finding);
void CheckConvexity(const AuditCase& c, AuditFinding* finding);
void CheckForms(const AuditCase& c, AuditFinding* finding);
void CheckDomain(const AuditCase& c, AuditFinding* finding);

// What checks share, an auditor's own among them.

/// Directions of largest entry 1 to look along: some parameters' axes, then random ones. Always the
/// same for the same n.
std::vector<Eigen::VectorXd> Directions(int n);

/// Evaluations; a refusal or a NaN inside the domain comes back as NaN.
double ValueAt(const Energy& energy, const Eigen::VectorXd& x);
Eigen::VectorXd GradientAt(const Energy& energy, const Eigen::VectorXd& x);

/// The full symmetric matrix n x n, from the lower triangle.
Eigen::MatrixXd HessianAt(const Energy& energy, const Eigen::VectorXd& x);

}  // namespace cirque
