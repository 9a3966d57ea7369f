#pragma once

#include "cirque/core/metric.h"
#include "cirque/core/solve_summary.h"
#include "cirque/core/status.h"
#include "cirque/pipeline/certificate.h"
#include "cirque/pipeline/flatten.h"
#include "cirque/pipeline/options.h"

namespace cirque {

/// Lowers the realised area distortion (AreaDistortion) of a flat surface by the angles of its
/// inner cones, which stay where they are: at most `options.refine_cones` steps of a quasi-Newton
/// method (BFGS), whose first Hessian is that of the linear model (ConeFit), on the triangulation
/// where the surface was solved, with the gradient of AreaDistortionGradient and a line search on
/// the realised distortion. On a closed surface the sum of the angles stays; angles stay
/// admissible. Ranged cones start at the angles the fit chose. At last everything is solved again
/// as Flatten does; where that is no better, flat and targets stay as they were.
///
/// `targets` and `flat` are those that the job ended in; summaries of the last solve and of the
/// refinement go to the certificate. Fails only when cancelled, or for options that Flatten refuses.
Status RefineCones(const FlattenJob& job, Certificate* certificate, ConeTargets* targets,
                   FlatSurface* flat);

}  // namespace cirque
