#pragma once

#include "cirque/energy/registry.h"

namespace cirque {

/// Everything that energies are made from, for a generated terrain of about that many triangles:
/// flat targets, coherent angles of the quadratic fit. Made once.
const EnergyInput& Terrain(int triangles);

}  // namespace cirque
