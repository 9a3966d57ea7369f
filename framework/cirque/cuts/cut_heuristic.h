#pragma once

#include <string>
#include <vector>

#include <Eigen/Core>

#include "cirque/core/metric.h"
#include "cirque/core/status.h"
#include "cirque/intrinsic/intrinsic_surface.h"

namespace cirque {

/// What there is to choose a cut by.
struct CutProblem {
  const IntrinsicSurface& surface;
  const EdgeLengths& flat;  ///< E: of the flat metric; before there is one the surface's own
  const std::vector<Eigen::Vector3d>* position = nullptr;  ///< V; null: a metric without points
};

/// A way to say where a surface should be opened: what it costs to open each edge. The cut is short
/// in these costs (CutGraph), and so are the borders of charts (PartIntoCharts).
class CutHeuristic {
 public:
  virtual ~CutHeuristic() = default;

  /// E, finite and >= 0, in proportion to the surface's scale; the same for the same problem. Error
  /// (invalid input): the problem lacks what the heuristic looks at.
  virtual StatusOr<Eigen::VectorXd> EdgeCosts(const CutProblem& problem) const = 0;

  /// Names of heuristics that are to be tried instead, a map each (MapFullest); none: it is one itself.
  virtual std::vector<std::string> Candidates() const { return {}; }
};

}  // namespace cirque
