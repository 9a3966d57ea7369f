#pragma once

#include <string>
#include <vector>

#include "experiments/audit_energies/audit.h"

namespace cirque::audit_energies {

/// What a check looks at.
struct Subject {
  const Energy& energy;
  const AuditCase& audit_case;
  const Reference& reference;

  std::string Where(const AuditPoint& point, const std::string& what) const {
    return audit_case.name + ", " + point.name + ": " + what;
  }
};

/// Each notes the figures of one energy and case; see AuditEnergy.
void CheckGradient(const Subject& subject, Finding* finding);
void CheckHessian(const Subject& subject, Finding* finding);
void CheckDigits(const Subject& subject, Finding* finding);
void CheckSymmetry(const Subject& subject, Finding* finding);
void CheckConvexity(const Subject& subject, Finding* finding);
void CheckForms(const Subject& subject, Finding* finding);
void CheckDomain(const Subject& subject, Finding* finding);

struct Check {
  std::string name;
  double bound;
  void (*run)(const Subject&, Finding*);
};

/// All of them, in the order of the table.
const std::vector<Check>& Checks();

// What checks share.

/// Directions of largest entry 1 to look along: some parameters' axes, then random ones. Always the
/// same for the same n.
std::vector<Eigen::VectorXd> Directions(int n);

/// Evaluations; a refusal or a NaN inside the domain comes back as NaN.
double ValueAt(const Energy& energy, const Eigen::VectorXd& x);
Eigen::VectorXd GradientAt(const Energy& energy, const Eigen::VectorXd& x);

/// The full symmetric matrix, from the lower triangle.
Eigen::MatrixXd HessianAt(const Energy& energy, const Eigen::VectorXd& x);

}  // namespace cirque::audit_energies
