#pragma once

#include <vector>

#include <Eigen/Core>

#include "cirque/core/metric.h"
#include "cirque/core/solve_summary.h"
#include "cirque/core/status.h"
#include "cirque/domains/domain.h"
#include "cirque/domains/inscribed_in_curve.h"
#include "cirque/math/closed_curve.h"
#include "cirque/mesh/surface.h"

namespace cirque {

/// Vertices of a boundary on a curve, in its order, the first at its beginning.
struct VerticesOnCurve {
  std::vector<Index> vertex;
  std::vector<double> arcs;     ///< where along the curve, increasing from 0
  std::vector<bool> at_corner;  ///< of the curve, where they stay
};

/// A flat metric of a disk whose boundary is, but for a similarity, inscribed in a curve.
class CurveFit {
 public:
  /// The disk's edges are to join no two vertices of the boundary (SplitEdges).
  CurveFit(const Surface& disk, const ClosedCurve& curve, const MapRequest& request,
           const SolveControl& control);

  /// Fills in the map with a layout of that metric, or of the nearest that came out. Errors: those of
  /// Parameterize, where the surface has no map with a free boundary; kUnrepresentable where the boundary
  /// has too few vertices for the curve; cancelled.
  Status Run(SurfaceMap* map);

  const CurveSummary& summary() const { return summary_; }
  const VerticesOnCurve& on_curve() const { return on_curve_; }
  /// The angle sums that the map was asked for.
  const ConeTargets& targets() const { return targets_; }

 private:
  Status MapFreely(SurfaceMap* map);
  void Begin(const SurfaceMap& free);
  void Bound();
  Eigen::VectorXd Lengths(const EdgeLengths& lengths) const;
  ConeTargets Targets(const Eigen::VectorXd& shape) const;
  Status PlaceOn(std::vector<double> arcs);
  Status TooFewVertices() const;

  const Surface& disk_;
  const InscribedPolygons polygons_;
  const ClosedCurve& curve_;
  const MapRequest& request_;
  const SolveControl& control_;
  std::vector<Index> loop_;  ///< halfedges of the boundary, on_curve_.vertex their tails
  Eigen::VectorXd lower_, upper_;
  VerticesOnCurve on_curve_;
  CurveSummary summary_;
  ConeTargets targets_;
};

}  // namespace cirque
