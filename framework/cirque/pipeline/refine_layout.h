#pragma once

#include <atomic>
#include <string>
#include <vector>

#include "cirque/core/metric.h"
#include "cirque/core/status.h"
#include "cirque/core/triangulation.h"
#include "cirque/intrinsic/input_chart.h"
#include "cirque/layout/planar_layout.h"
#include "cirque/pipeline/certificate.h"

namespace cirque {

/// Whether a text is a value of ParameterizeOptions::refine_map; the error says what is wrong.
Status CheckRefineMap(const std::string& refine_map);

/// Refines a layout without flipped faces as `refine_map` says (RefineMap), unless that is "none".
/// `lengths` are the surface's. Fills in the certificate's values map_refinement_steps, ..._before
/// and ..._after. Errors: as CheckRefineMap; cancelled.
Status RefineLayout(const Triangulation& triangulation, const EdgeLengths& lengths,
                    const InputChart& flat, const Cut& cut, const std::vector<Index>& cones,
                    const std::string& refine_map, const std::atomic<bool>* cancelled,
                    PlanarLayout* layout, Certificate* certificate);

}  // namespace cirque
