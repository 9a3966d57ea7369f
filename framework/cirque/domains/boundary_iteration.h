#pragma once

#include <functional>
#include <limits>
#include <optional>

#include <Eigen/Core>

#include "cirque/core/metric.h"
#include "cirque/core/solve_summary.h"
#include "cirque/core/status.h"
#include "cirque/domains/domain.h"
#include "cirque/mesh/surface.h"

namespace cirque {

/// A boundary whose angle sums are to be those of a shape that is known once its edges' lengths are: of
/// logarithms of lengths, edge by edge.
struct BoundaryRule {
  /// The angle sums of the shape.
  std::function<ConeTargets(const Eigen::VectorXd& shape)> targets;
  /// What the shape lacks of that by which the flat metric that came out has its lengths.
  std::function<Eigen::VectorXd(const Eigen::VectorXd& shape, const EdgeLengths& flat)> change;
  Eigen::VectorXd start;
  Eigen::VectorXd shares;  ///< of a change, that a round takes
  double at_rest = 1e-10;  ///< the lengths stay where a round changes no log by more
};

/// Flattens with the boundary's angle sums of the shape, by the lengths that come out again (with exact
/// those of the metric of the exact map), until these stay: a fixed point, by Anderson's acceleration, one solve a round, ten to twenty rounds. Where that
/// does not settle, as where intrinsic flips join vertices of one loop or change from round to round, it
/// begins again on the input's connectivity, then from the best shape with half the shares.
class BoundaryIteration {
 public:
  BoundaryIteration(const Surface& surface, BoundaryRule rule, const ParameterizeOptions& options,
                    const SolveControl& control);

  /// Errors: those of Parameterize where no round led to a map, of which `failed` then is the last;
  /// cancelled.
  Status Run(SurfaceMap* failed);

  /// Whether the lengths stay.
  bool IsSettled() const;

  /// @pre Run was ok. The map that changes least, without refinement, and its shape.
  SurfaceMap& map() { return *best_; }
  const Eigen::VectorXd& shape() const { return best_shape_; }
  double change() const { return least_; }  ///< the largest of a log length
  int rounds() const { return rounds_; }

 private:
  Status RunFromHere(SurfaceMap* failed);

  const Surface& surface_;
  const BoundaryRule rule_;
  ParameterizeOptions options_;
  const SolveControl& control_;
  Eigen::VectorXd shares_, shape_, best_shape_;
  std::optional<SurfaceMap> best_;
  double least_ = std::numeric_limits<double>::infinity();
  int rounds_ = 0;
};

}  // namespace cirque
