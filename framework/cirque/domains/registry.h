#pragma once

#include <string>

#include "cirque/core/registry.h"
#include "cirque/domains/domain.h"

namespace cirque {

/// The domains, one line each.
const Registry<Domain>& Domains();

/// Whether some domain reads this member of a request.
bool IsReadBySomeDomain(const std::string& option);

}  // namespace cirque
