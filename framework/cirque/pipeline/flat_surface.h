#pragma once

#include <memory>
#include <optional>
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

struct EquivalentTriangulation;
struct PrescribedRotations;

/// A flat metric on the triangulation that it was solved on, no triangle of which is flipped.
struct SolvedMetric {
  IntrinsicTriangulation intrinsic;
  CornerAngles angles;  ///< flat
  EdgeLengths lengths;  ///< flat
  /// Of conformal equivalence: what the overlay is made of; intrinsic's lengths are flat too, and of
  /// a surface that was solved on its double it is the half. Null: a circle pattern, whose overlay is
  /// drawn by StraightLines.
  std::shared_ptr<const EquivalentTriangulation> equivalent = {};
};

/// A flat cone metric conformal to the input's, where it was solved and as the input's triangles
/// have it.
struct FlatSurface {
  IntrinsicTriangulation intrinsic;  ///< where it was solved; without flips: the input itself
  CoherentAngles angles;             ///< of intrinsic
  Eigen::VectorXd multipliers;       ///< of the angle fit, rows as in AngleConstraints
  LogRadii log_radii;                ///< of intrinsic; the image has the area of the surface
  EdgeLengths intrinsic_lengths;     ///< flat, of intrinsic: with it a CON file
  bool is_own = false;               ///< the metric is the surface's own, which is flat
  /// V, where intrinsic's flips are Ptolemy's and the metric is conformally equivalent: what edges of
  /// the input are straight in is TraceIdealGeodesic's to say. Empty: a circle pattern.
  Eigen::VectorXd log_scale;
  InputChart on_input;
  /// With ParameterizeOptions::exact the first that was solved, before any edge was locked. Only with
  /// it may triangles of `on_input` be flipped.
  std::optional<SolvedMetric> exact;
  InfeasibilityCertificate infeasibility;  ///< with kInfeasible: why there is none
};

/// What to do about the angle fit's dual, which can wander where no coherent angles exist, or hardly any.
enum class DualFit {
  kFirst,      ///< the interior point decides where it wanders
  kWandered,   ///< it did with targets before these: the interior point is tried first, on the
               ///< surface's own triangles, where the other decided too
  kOrNothing,  ///< where it wanders no map is wanted
};

/// What is to be flattened, and how.
struct FlattenJob {
  const IntrinsicSurface& surface;
  const ConeTargets& targets;
  const ParameterizeOptions& options;
  const SolveControl& control;
  /// Edges of the surface that are locked from the first round on; null: none.
  const std::vector<bool>* locked = nullptr;
  /// Along loops of the surface's triangulation; null: any.
  const PrescribedRotations* rotations = nullptr;
  DualFit dual = DualFit::kFirst;
};

}  // namespace cirque
