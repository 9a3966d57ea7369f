#include "cirque/audit/audit_energy.h"
#include "cirque/audit/checks.h"

namespace cirque {

const std::vector<AuditCheck>& AuditChecks() {
  static const std::vector<AuditCheck> kTable = {
      {"gradient", 0.2, CheckGradient},  {"hessian", 0.2, CheckHessian},
      {"symmetry", 1e-6, CheckSymmetry}, {"convexity", 1e-12, CheckConvexity},
      {"forms", 1e-9, CheckForms},       {"domain", 0, CheckDomain},
  };
  return kTable;
}

}  // namespace cirque
