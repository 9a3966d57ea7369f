#pragma once

#include <string>

#include "experiments/audit_energies/audit.h"

namespace cirque::audit_energies {

/// The framework's energies in 50 digits, from their definitions.
ReferenceValue CirclePatternReference(const EnergyInput& input, const Reals& log_radii);
ReferenceValue CoherentAngleBarrierReference(const EnergyInput& input, const Reals& angles);
ReferenceValue LorentzReference(const EnergyInput& input, const Reals& x);

/// Of the dual of the angle fit with the objective of that name: the conjugate of an edge is the
/// largest of its values at every point of Q_e that can be the maximiser, found side by side.
Reference DualReference(const std::string& objective);

}  // namespace cirque::audit_energies
