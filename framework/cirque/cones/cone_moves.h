#pragma once

#include <string>
#include <vector>

#include "cirque/cones/cone_fit.h"
#include "cirque/cones/cone_problem.h"
#include "cirque/core/grouping.h"

namespace cirque {

/// Cones on their way to where a measure is lower, with the admissible curvatures of least measure
/// wherever they are. Moves lower the measure's form (ConeMeasure), relocations the measure itself.
class ConeMoves {
 public:
  /// `measure`: as of MakeConeMeasure. `max_sweeps`: how many are to come; the fewer, the shorter the
  /// first strides, for a stride that gains nothing is halved from sweep to sweep.
  ConeMoves(const ConeProblem& problem, const std::vector<Cone>& start, ConeMeasureKind measure,
            int max_sweeps);

  /// The curvatures for where the cones start. False when none are admissible.
  bool FitStart();

  /// Every cone once a few edges downhill; true while some cone may still move.
  bool Sweep();

  /// Moves one cone, of those that are missed least, to where a cone more would help most, and lets
  /// it settle there. False when no such change lowers the measure; the cones then are where they
  /// were.
  bool Relocate();

  /// Fits the curvatures until the measure no longer falls.
  void FitEnd();

  std::vector<Cone> Cones() const { return fit_.Cones(); }

 private:
  Index Proposal(int i, const Eigen::VectorXd& slope, int stride) const;
  void PrepareProposals(const Eigen::VectorXd& slope);
  bool TryMove(int i, const Eigen::VectorXd& slope, int stride);
  Index Downhill(Index v, double curvature, const Eigen::VectorXd& slope, int steps) const;
  std::vector<int> LeastMissed();
  std::vector<Index> BestPositions() const;
  bool TryPosition(int i, Index to, double before);
  void MoveTo(int i, Index to);
  void Settle(int i);
  void Adapt(int times);

  const ConeProblem& problem_;
  const Buckets corners_at_;
  ConeFit fit_;
  std::vector<bool> taken_;
  std::vector<int> stride_;  ///< of each cone's next move; 0: it rests
  /// What each cone's last refused move lost to the slope's promise, over the square of its stride. A
  /// shorter one is taken to lose no less by that, and not tried where the slope promises less. 0: unknown.
  std::vector<double> resistance_;
};

}  // namespace cirque
