#pragma once

#include <atomic>

#include <Eigen/Core>

#include "cirque/core/status.h"
#include "cirque/core/triangulation.h"
#include "cirque/intrinsic/intrinsic_surface.h"

namespace cirque {

/// The cut with further edges opened so that it leaves at least `count` patches, connected ones of
/// any topology, with cheap borders.
///
/// Parts grow about seeds that are far from each other; each seed then moves to where its part is
/// farthest from other parts, some times (P. Sander et al., "Multi-chart geometry images", 2003).
/// Then every two neighbouring parts are parted anew by cuts of least cost (DualFlow) about seeds
/// that are held fast with as much around them as is 1.2, 2 or 5 times nearer to the one than
/// to the other; of these cuts and the border as it is the one of least
///   cost (1 / area_a + 1 / area_b)
/// holds, which is a short one that leaves no crumbs (a great circle of a sphere, the neck of two
/// balls), until none gets better. Reproducible; O(F log F) and the minimum cuts.
///
/// `edge_cost`: E, >= 0; infinity where an edge must stay closed. Errors: invalid input where there
/// are fewer faces (with closed edges: polygons) than that; cancelled.
StatusOr<Cut> PartIntoCharts(const IntrinsicSurface& surface, const Eigen::VectorXd& edge_cost,
                             const Cut& given, Index count,
                             const std::atomic<bool>* cancelled = nullptr);

}  // namespace cirque
