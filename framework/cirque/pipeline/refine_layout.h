#pragma once

#include <atomic>
#include <optional>
#include <string>
#include <vector>

#include "cirque/core/metric.h"
#include "cirque/core/status.h"
#include "cirque/core/triangulation.h"
#include "cirque/intrinsic/input_chart.h"
#include "cirque/intrinsic/intrinsic_surface.h"
#include "cirque/layout/planar_layout.h"
#include "cirque/pipeline/summaries.h"

namespace cirque {

/// Whether a text is a value of ParameterizeOptions::refine_map; the error says what is wrong.
Status CheckRefineMap(const std::string& refine_map);

/// A layout's surface, flat metric, cut and cones.
struct LaidOutSurface {
  const IntrinsicSurface& surface;
  const InputChart& flat;
  const Cut& cut;
  const std::vector<Index>& cones;
  const std::atomic<bool>* cancelled;
};

/// Refines a layout without flipped faces as `refine_map` says (RefineMap), unless that is "none".
/// Errors: as CheckRefineMap; cancelled.
Status RefineLayout(const LaidOutSurface& of, const std::string& refine_map, PlanarLayout* layout,
                    std::optional<MapRefinementSummary>* summary);

}  // namespace cirque
