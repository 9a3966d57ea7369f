#pragma once

#include <atomic>
#include <optional>
#include <string>

#include "cirque/core/metric.h"
#include "cirque/core/status.h"
#include "cirque/domains/curve_fit.h"
#include "cirque/intrinsic/intrinsic_surface.h"
#include "cirque/math/closed_curve.h"
#include "cirque/pipeline/certificate.h"

namespace cirque {

/// Refines a map without flipped faces whose boundary lies on a curve, as `refine_map` says: first what
/// lies inside. Then, in rounds, boundary vertices off the curve's corners and its beginning slide along
/// its tangents and go back onto it, as much farther along, as large a share of the way as flips nothing,
/// and the inside is refined once more; while a round lowers the objective by a percent. Errors:
/// cancelled.
Status RefineOnCurve(const IntrinsicSurface& surface, const ClosedCurve& curve,
                     const std::string& refine_map, const std::atomic<bool>* cancelled,
                     VerticesOnCurve* on, CornerUv* uv,
                     std::optional<MapRefinementSummary>* summary);

}  // namespace cirque
