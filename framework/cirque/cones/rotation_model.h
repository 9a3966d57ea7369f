#pragma once

#include <vector>

#include <Eigen/Core>

#include "cirque/cones/cone.h"
#include "cirque/cones/cone_problem.h"
#include "cirque/intrinsic/dual_paths.h"

namespace cirque {

/// What cones do to the rotations along paths, by the linear model of a ConeProblem, before
/// anything is fitted:
///   r_q = r_q(alpha_0) + s_q . (Theta - Theta_0),      s_q = -L^-1 D' w_q,
/// alpha_0 and Theta_0 angles and angle sums of the problem's metric, w_q the signs of the corners
/// that path q passes (CornersAlong), D the derivative of angles by log scales: with the cotangents
/// of the two other corners a and b of a triangle,
///   d alpha_k = 1/2 cot_b (u_a - u_k) + 1/2 cot_a (u_b - u_k).
/// One solve a path with the problem's factor. A cone of curvature mu that moves from v to w turns
/// path q by mu (s_q(v) - s_q(w)). Against the finished metric it errs by 2e-4 to .008 rad on good
/// meshes, by up to .1 on poor ones, and by more where many inequalities of the angle fit are
/// active.
class RotationModel {
 public:
  /// The problem must outlive the model.
  RotationModel(const ConeProblem& problem, std::vector<SignedCorners> paths);

  int size() const { return static_cast<int>(paths_.size()); }
  const std::vector<SignedCorners>& paths() const { return paths_; }

  /// s, paths x V: one column a vertex. 0 on the boundary, of mean 0 on a closed surface.
  const Eigen::MatrixXd& by_angle_sum() const { return by_angle_sum_; }

  /// r of a metric that is flat but for these cones [rad].
  Eigen::VectorXd Predict(const std::vector<Cone>& cones) const;

 private:
  std::vector<SignedCorners> paths_;
  Eigen::MatrixXd by_angle_sum_;
  Eigen::VectorXd without_cones_;
};

}  // namespace cirque
