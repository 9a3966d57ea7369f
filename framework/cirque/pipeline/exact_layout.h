#pragma once

#include "cirque/core/status.h"
#include "cirque/intrinsic/intrinsic_surface.h"
#include "cirque/layout/exact_map.h"
#include "cirque/pipeline/cut_and_place.h"
#include "cirque/pipeline/parameterization.h"
#include "cirque/pipeline/summaries.h"

namespace cirque {

/// Lays out the triangulation that was solved on (FlatSurface::exact) by itself, as CutAndPlace
/// does the job's surface, its seams along its own edges, and fills in result's exact_map, which is
/// linear on those triangles: no triangle of it is flipped, and no vertex was moved. Given cuts
/// stay where their edges do. Errors: as CutAndPlace and MakeExactMap; kInvalidInput for an
/// overlay above ParameterizeOptions::exact_limit.
Status LayOutExactly(const ParameterizeJob& job, Parameterization* result);

/// Of an exact map's own triangles, each measured by itself.
DistortionSummary DistortionOf(const IntrinsicSurface& surface, const ExactMap& map);

}  // namespace cirque
