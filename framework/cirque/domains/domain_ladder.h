#pragma once

#include <string>
#include <vector>

#include "cirque/core/solve_summary.h"
#include "cirque/core/status.h"
#include "cirque/domains/domain.h"
#include "cirque/mesh/surface.h"

namespace cirque {

/// Maps a surface as it was asked for. Where that leads to no map, or to one that doubles hold only
/// inaccurately, the rungs that apply to the domain are tried, each once, in the order of
/// DomainLadderRungs(), each from the request as it was asked for, until one leads to an accurate
/// map. That, or else the first inaccurate one, is the result; where there is none, that of the
/// request itself, or the first proof on a rung that changes nothing but the way. The certificate's
/// ladder lists what was tried.
///
/// No rung is tried with the option `strict` or by a domain that does not read it; the plane has a
/// ladder of its own (pipeline/ladder.h), which the polygons climb first. What the user named (a
/// pole, corners, "none" for the refinement, a method of the solves) stays.
Status ClimbDomainLadder(const Domain& domain, const Surface& surface, const MapRequest& request,
                         const SolveControl& control, SurfaceMap* map);

/// The names of the rungs, in order.
std::vector<std::string> DomainLadderRungs();

}  // namespace cirque
