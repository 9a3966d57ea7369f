#pragma once

#include <vector>

#include <Eigen/Core>

#include "cirque/core/infeasibility.h"
#include "cirque/core/metric.h"
#include "cirque/core/solve_summary.h"
#include "cirque/intrinsic/input_chart.h"
#include "cirque/intrinsic/intrinsic_delaunay.h"
#include "cirque/intrinsic/intrinsic_surface.h"
#include "cirque/pipeline/options.h"

namespace cirque {

/// A flat cone metric conformal to the input's, where it was solved and as the input's triangles
/// have it.
struct FlatSurface {
  IntrinsicTriangulation intrinsic;  ///< where it was solved; without flips: the input itself
  CoherentAngles angles;             ///< of intrinsic
  Eigen::VectorXd multipliers;       ///< of the angle fit, rows as in AngleConstraints
  LogRadii log_radii;                ///< of intrinsic; the image has the area of the surface
  EdgeLengths intrinsic_lengths;     ///< flat, of intrinsic: with it a CON file
  InputChart on_input;
  InfeasibilityCertificate infeasibility;  ///< with kInfeasible: why there is none
};

/// What is to be flattened, and how.
struct FlattenJob {
  const IntrinsicSurface& surface;
  const ConeTargets& targets;
  const ParameterizeOptions& options;
  const SolveControl& control;
  /// Edges of the surface that are locked from the first round on; null: none.
  const std::vector<bool>* locked = nullptr;
};

}  // namespace cirque
