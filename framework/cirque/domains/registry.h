#pragma once

#include <string>

#include "cirque/core/registry.h"
#include "cirque/domains/domain.h"

namespace cirque {

/// The domains, one line each.
const Registry<Domain>& Domains();

/// Whether some domain reads this member of a request.
bool IsReadBySomeDomain(const std::string& option);

/// MapSurface (domain.h) with a table of domains other than the library's, such as one with a
/// domain more.
StatusOr<SurfaceMap> MapSurface(const Surface& surface, const MapRequest& request,
                                const SolveControl& control, Certificate* failed,
                                const Registry<Domain>& domains);

}  // namespace cirque
