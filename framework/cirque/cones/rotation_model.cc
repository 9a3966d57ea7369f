#include "cirque/cones/rotation_model.h"

#include <cmath>
#include <utility>

namespace cirque {
namespace {

/// D' w, V.
Eigen::VectorXd ByLogScale(const Triangulation& t, const Eigen::VectorXd& alpha,
                           const SignedCorners& path) {
  Eigen::VectorXd by_scale = Eigen::VectorXd::Zero(t.num_vertices);
  for (const auto& [k, sign] : path) {
    const Index a = Triangulation::Next(k), b = Triangulation::Prev(k);
    const double of_a = 0.5 * sign / std::tan(alpha[b]), of_b = 0.5 * sign / std::tan(alpha[a]);
    by_scale[t.vertex[a]] += of_a;
    by_scale[t.vertex[b]] += of_b;
    by_scale[t.vertex[k]] -= of_a + of_b;
  }
  return by_scale;
}

}  // namespace

RotationModel::RotationModel(const ConeProblem& problem, std::vector<SignedCorners> paths)
    : paths_(std::move(paths)),
      by_angle_sum_(size(), problem.triangulation().num_vertices),
      without_cones_(size()) {
  const Triangulation& t = problem.triangulation();
  const Eigen::VectorXd alpha = MeasureCornerAngles(t, problem.lengths()).value;
  for (int q = 0; q < size(); ++q) {
    const Eigen::VectorXd s = -problem.Solve(ByLogScale(t, alpha, paths_[q]));
    by_angle_sum_.row(q) = s.transpose();
    without_cones_[q] = RotationAlong(paths_[q], alpha) + s.dot(problem.curvature());
  }
}

Eigen::VectorXd RotationModel::Predict(const std::vector<Cone>& cones) const {
  Eigen::VectorXd rotation = without_cones_;
  for (const Cone& cone : cones) {
    rotation -= (2 * kPi - 0.5 * (cone.lower + cone.upper)) * by_angle_sum_.col(cone.vertex);
  }
  return rotation;
}

}  // namespace cirque
