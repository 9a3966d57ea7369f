#pragma once

#include "cirque/core/metric.h"
#include "cirque/core/solve_summary.h"
#include "cirque/core/status.h"
#include "cirque/pipeline/parameterize.h"

namespace cirque {

/// Fills in overlap and the measures of the certificate for result->uv and result->cut.
void PutMeasures(const Triangulation& triangulation, const EdgeLengths& lengths,
                 Parameterization* result);

/// Fills in outcome, message and total time of a run; returns its status.
Status Conclude(const Status& status, const Timer& timer, Certificate* certificate);

/// Renumbers the proof's vertices as the input file has them.
void NumberAsInFile(const Surface& surface, InfeasibilityCertificate* proof);

}  // namespace cirque
