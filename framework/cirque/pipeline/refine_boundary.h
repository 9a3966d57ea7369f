#pragma once

#include <Eigen/Core>

#include "cirque/cones/boundaries.h"
#include "cirque/cones/boundary_problem.h"
#include "cirque/core/metric.h"
#include "cirque/core/status.h"
#include "cirque/pipeline/certificate.h"
#include "cirque/pipeline/flat_surface.h"

namespace cirque {

/// Angle sums of a boundary, V, 0 inside: as predicted, and those of the isometric boundary, from
/// which a prediction is so far away that its image may overlap itself.
struct PredictedBoundary {
  Eigen::VectorXd angle_sums, isometric;
};

/// Lowers the realised L^p norm of the log scale (LogScaleNorm) of a flat surface by the angle sums of
/// its boundary, from the predicted ones, for which `flat` was solved: at most descent.steps steps
/// with the exact gradient and the linear model's Hessian (LogScaleStep), halved until they bring
/// enough, within the problem's bounds.
///
/// The image of a disk without cones does not begin to overlap itself: each trial is laid out and its
/// boundary looked at by exact arithmetic (OverlapsItself). Where the predicted one does so
/// already, the descent begins at the first of 1/2, 1/4, 1/8 and none of the way from the isometric
/// boundary whose image does not. (Where a surface is cut open the image depends on the cut, and is
/// not looked at.)
///
/// `targets`, `flat` and the certificate receive what comes out, with `boundary` filled in. Fails only
/// when cancelled.
Status RefineBoundary(const FlattenJob& job, const BoundaryDescent& descent,
                      const BoundaryProblem& problem, const PredictedBoundary& predicted,
                      Certificate* certificate, ConeTargets* targets, FlatSurface* flat);

}  // namespace cirque
