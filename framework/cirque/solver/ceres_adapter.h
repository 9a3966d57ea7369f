#pragma once

#include <functional>
#include <limits>
#include <string>

#include <Eigen/Core>
#include <ceres/iteration_callback.h>

#include "cirque/solver/solve_run.h"

namespace cirque {

/// Watches a solve by Ceres on behalf of a SolveRun: at every accepted iterate it takes the
/// energy's own gradient there, which is what the run's records, callback, limits and cancellation
/// go by. Ceres' own tests compare values and parameters; they are to be set so tight that they end
/// a solve only where doubles do.
class CeresWatch final : public ceres::IterationCallback {
 public:
  using PointFunction = std::function<Eigen::VectorXd()>;
  using GradientFunction =
      std::function<bool(const Eigen::VectorXd& point, Eigen::VectorXd* gradient)>;

  /// `accepted` gives Ceres' last accepted point. *x, at which the energy has
  /// the gradient `gradient`, follows it. A round of `max_idle` steps that change the value by
  /// rounding only and do not lower the gradient is ended.
  CeresWatch(SolveRun* run, GradientFunction gradient_at, PointFunction accepted,
             const Eigen::VectorXd& gradient, int max_idle, Eigen::VectorXd* x);

  ceres::CallbackReturnType operator()(const ceres::IterationSummary& summary) override;

  /// Makes Ceres return after the present iteration; another round follows.
  void EndRound() { round_ends_ = is_round_asked_ = true; }

  /// Called before Ceres is (again) to start from *x.
  void BeginRound();

  /// Accepts a point that Ceres evaluated last but did not take, if the gradient is clearly smaller
  /// there: values that agree in all digits make Ceres stop in front of the better point.
  void Offer(const Eigen::VectorXd& point);

  /// Called after Ceres returned: whether to start it again from *x. Otherwise the run has ended,
  /// as kStalled with `message` if for no other reason.
  bool AnotherRoundHelps(const std::string& message);

 private:
  bool Take(const ceres::IterationSummary& summary);
  void KeepBest();

  SolveRun* run_;
  const GradientFunction gradient_at_;
  const PointFunction accepted_;
  Eigen::VectorXd gradient_;  ///< at *x_
  Eigen::VectorXd* x_;
  bool round_ends_ = false, is_round_asked_ = false;
  const int max_idle_;
  int idle_ = 0;
  double best_, round_start_ = std::numeric_limits<double>::infinity();
  Eigen::VectorXd best_x_, best_gradient_;
};

}  // namespace cirque
