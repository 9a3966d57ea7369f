#pragma once

#include "cirque/core/infeasibility.h"
#include "cirque/core/triangulation.h"

namespace cirque {

/// Whether the inequality of core/infeasibility.h holds for the doubles of `proof` exactly, in
/// integer arithmetic: strictly for epsilon > 0. For epsilon = 0 equality is enough as soon as A'y
/// is not zero: coherent angles lie in the interior of every Q_e, where a linear function that is
/// not constant stays below its maximum. False for numbers that are not finite and for epsilon
/// outside [0, 1/3).
bool ProvesExactly(const Triangulation& triangulation, const InfeasibilityCertificate& proof);

}  // namespace cirque
