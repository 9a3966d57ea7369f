#pragma once

#include "cirque/core/infeasibility.h"

#include "experiments/verify_map/infeasibility_check.h"
#include "experiments/verify_map/topology.h"

namespace cirque::verify_map {

/// Takes the triangles at the proof's removed vertex out of the surface and of the proof, and in a
/// surface with boundary those beyond chords, as CheckInfeasibility says. False, with errors in the report,
/// where proof or surface do not allow it. @pre the proof has the form that the surface needs.
bool RemoveVertex(Surface* surface, InfeasibilityCertificate* proof, InfeasibilityReport* report);

}  // namespace cirque::verify_map
