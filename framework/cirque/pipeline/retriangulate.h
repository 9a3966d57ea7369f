#pragma once

#include "cirque/core/status.h"
#include "cirque/pipeline/certificate.h"
#include "cirque/pipeline/flat_surface.h"

namespace cirque {

/// Looks for a triangulation of the same metric that suits the job's targets better than result's
/// `intrinsic`. Infeasibility and active inequalities are matters of the triangulation: where
/// theta_e is at its bound the four points lie on a circle, so that the other diagonal is as good in
/// the flat metric, and its theta may grow on the other side. Up to `options.retriangulate` rounds of
/// an angle fit and of flips in the surface's own metric, each from the last round's multipliers:
/// of the edges whose theta is at its bound, or, where there are no coherent angles, of those round
/// the faces that the proof points at, as long as the poorest of an edge's four vertices gains corners.
/// A round is kept where its fit has a lower objective; the first that is not is the last. Where no
/// round makes it feasible the triangulation stays as it was.
///
/// Leaves result's `intrinsic` and the multipliers there, from which the solve then starts, and
/// the summary. Error: kCancelled.
Status Retriangulate(const FlattenJob& job, Certificate* certificate, FlatSurface* result);

}  // namespace cirque
