#pragma once

#include <string>
#include <vector>

#include "experiments/audit_energies/audit.h"

namespace cirque::audit_energies {

/// A table energy x check, each entry "ok" or the worst figure, then a line for each failure: what
/// was compared, where, figure and bound.
std::string ToText(const std::vector<AuditRow>& rows);

/// The same with every figure. Figures that are no number are null.
std::string ToJson(const std::vector<AuditRow>& rows);

/// Whether no row failed.
bool AllOk(const std::vector<AuditRow>& rows);

}  // namespace cirque::audit_energies
