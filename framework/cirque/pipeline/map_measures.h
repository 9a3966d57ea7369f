#pragma once

#include "cirque/core/metric.h"
#include "cirque/core/solve_summary.h"
#include "cirque/core/status.h"
#include "cirque/pipeline/parameterize.h"

namespace cirque {

/// Fills in the certificate's overlap and figures of distortion for result->uv and result->cut.
void MeasureDistortion(const Triangulation& triangulation, const EdgeLengths& lengths,
                       Parameterization* result);

/// The certificate's figures of distortion of a map of flat triangles.
DistortionSummary DistortionOf(const Triangulation& triangulation, const EdgeLengths& lengths,
                               const CornerUv& uv);

}  // namespace cirque
