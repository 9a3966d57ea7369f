#pragma once

#include <functional>

#include "cirque/core/status.h"
#include "cirque/pipeline/ladder_rungs.h"
#include "cirque/pipeline/parameterization.h"

namespace cirque {

/// Takes a road, as far as it leads.
using TakeARoad = std::function<Status(const Road& road, Parameterization* result)>;

/// Takes the road that was asked for. Where it leads to no map, or to an inaccurate one, the rungs
/// of the ladder that apply are tried, each once, in the order of LadderRungs(), each from where the
/// road before it ended, until one leads to an accurate map. That, or else the first inaccurate
/// one, is the result; where there is none, that of the road asked for with its proof, or the first
/// proof about the same targets. The certificate's ladder lists what was tried. With
/// `asked.options.strict` no rung is.
///
/// Targets of the user stay as they are, and cones of a heuristic that the user named are moved and
/// widened (RepairCones) but not replaced, those of a file not even that. Cones where nobody asked
/// for any come to surfaces with a boundary only where no cut was given.
Status ClimbLadder(const LadderStart& start, const TakeARoad& take, Parameterization* result);

}  // namespace cirque
