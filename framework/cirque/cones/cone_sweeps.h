#pragma once

#include <memory>
#include <vector>

#include <Eigen/Core>

#include "cirque/cones/cone.h"
#include "cirque/cones/cone_measure.h"
#include "cirque/cones/cone_problem.h"
#include "cirque/core/grouping.h"

namespace cirque {

/// Many cones on their way to where a measure is lower, all at once: a sweep costs some solves with
/// the problem's factor, however many cones there are. What ConeMoves does for few.
///
/// A sweep moves every cone some edges down the slope of the measure (times its curvature), looks
/// at what became of the measure around each, by the vertices to which no other cone is nearer (in
/// edges), takes back the moves around which it rose, and keeps the others if the measure falls.
/// In between, the curvatures go down the slope of the measure's form by projected gradients
/// (step lengths of J. Barzilai, J. Borwein, "Two-point step size gradient methods", 1988) within
/// their bounds and with their total.
class ConeSweeps {
 public:
  /// `start`: fixed cones at candidates, whose curvatures are admissible.
  ConeSweeps(const ConeProblem& problem, const std::vector<Cone>& start, ConeMeasureKind measure);

  /// Rounds of at most so many sweeps, and the curvatures before, between and after, as long as the
  /// measure falls by them. It does not grow.
  void Run(int max_sweeps);

  /// Every cone once; true while some cone may still move.
  bool Sweep();

  /// Some steps of the curvatures.
  void FitCurvatures();

  double Measure() const { return measure_->Value(u_); }
  std::vector<Cone> Cones() const;

 private:
  void SweepToRest(int max_sweeps);
  std::vector<Index> Proposals(const Eigen::VectorXd& slope);
  Index Downhill(Index v, double curvature, const Eigen::VectorXd& slope, int steps) const;
  std::vector<bool> WhereLower(const Eigen::VectorXd& moved) const;
  Eigen::VectorXd MovedLogScale(const std::vector<Index>& to) const;
  Eigen::VectorXd WithCurvatures(const Eigen::VectorXd& curvature) const;
  Eigen::VectorXd Admissible(const Eigen::VectorXd& curvature) const;

  const ConeProblem& problem_;
  const Buckets corners_at_;
  const std::unique_ptr<ConeMeasure> measure_;
  std::vector<Index> vertices_;
  Eigen::VectorXd curvature_, least_;  ///< of each cone [rad], and the least that it may have
  std::vector<bool> taken_;            ///< per vertex
  std::vector<int> stride_;            ///< of each cone's next move, in edges; 0: it rests
  Eigen::VectorXd u_;                  ///< V
};

}  // namespace cirque
