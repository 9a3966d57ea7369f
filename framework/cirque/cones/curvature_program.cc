#include "cirque/cones/curvature_program.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <Eigen/LU>

namespace cirque {
namespace {

constexpr double kMultiplierTolerance = 1e-12;  ///< relative to the gradient
constexpr double kSumTolerance = 1e-12;         ///< relative, of a start's total

/// The walk of the active-set method.
class ActiveSet {
 public:
  ActiveSet(const CurvatureProgram& program, Eigen::VectorXd start)
      : program_(program), mu_(std::move(start)), free_(mu_.size(), true) {
    for (int i = 0; i < mu_.size(); ++i) {
      free_[i] = mu_[i] > program.lower[i] && mu_[i] < program.upper[i];
    }
  }

  Eigen::VectorXd Run() {
    const auto n = static_cast<int>(mu_.size());
    for (int step = 0; step < 20 * (n + 1); ++step) {
      if (!StepOnFreeSet()) continue;
      if (!ReleaseOne()) break;
    }
    return mu_;
  }

 private:
  std::vector<int> FreeIndices() const {
    std::vector<int> indices;
    for (std::size_t i = 0; i < free_.size(); ++i) {
      if (free_[i]) indices.push_back(static_cast<int>(i));
    }
    return indices;
  }

  /// To the minimum over the free curvatures, or to the first bound on the way, which becomes
  /// active: true in the first case.
  bool StepOnFreeSet() {
    const std::vector<int> free = FreeIndices();
    const auto m = static_cast<int>(free.size());
    const bool summed = program_.total.has_value();
    multiplier_ = 0;
    if (m == 0) return true;
    const Eigen::VectorXd gradient = program_.gram * mu_ + program_.linear;
    Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(m + summed, m + summed);
    Eigen::VectorXd right = Eigen::VectorXd::Zero(m + summed);
    matrix.topLeftCorner(m, m) = program_.gram(free, free);
    right.head(m) = -gradient(free);
    const double scale = matrix.diagonal().head(m).maxCoeff();
    if (summed) {
      matrix.col(m).head(m).setConstant(scale);
      matrix.row(m).head(m).setConstant(scale);
    }
    const Eigen::VectorXd solution = matrix.partialPivLu().solve(right);
    if (summed) multiplier_ = -scale * solution[m];
    return Walk(free, solution.head(m));
  }

  bool Walk(const std::vector<int>& free, const Eigen::VectorXd& step) {
    double length = 1;
    int blocking = -1;
    for (std::size_t k = 0; k < free.size(); ++k) {
      const int i = free[k];
      const double bound = step[k] > 0 ? program_.upper[i] : program_.lower[i];
      const double room = step[k] == 0 ? 1 : (bound - mu_[i]) / step[k];
      if (room >= length) continue;
      length = std::max(room, 0.0);
      blocking = i;
    }
    for (std::size_t k = 0; k < free.size(); ++k) mu_[free[k]] += length * step[k];
    if (blocking < 0) return true;
    mu_[blocking] = step[std::find(free.begin(), free.end(), blocking) - free.begin()] > 0
                        ? program_.upper[blocking]
                        : program_.lower[blocking];
    free_[blocking] = false;
    return false;
  }

  /// Frees the active curvature that gains most from leaving its bound; false when none gains.
  bool ReleaseOne() {
    const Eigen::VectorXd gradient =
        ((program_.gram * mu_ + program_.linear).array() - multiplier_).matrix();
    const double tolerance = kMultiplierTolerance * (1 + gradient.lpNorm<Eigen::Infinity>());
    int best = -1;
    double gain = tolerance;
    for (int i = 0; i < mu_.size(); ++i) {
      if (free_[i] || program_.lower[i] == program_.upper[i]) continue;
      const double pull = mu_[i] == program_.lower[i] ? -gradient[i] : gradient[i];
      if (pull <= gain) continue;
      gain = pull;
      best = i;
    }
    if (best >= 0) free_[best] = true;
    return best >= 0;
  }

  const CurvatureProgram& program_;
  Eigen::VectorXd mu_;
  std::vector<bool> free_;
  double multiplier_ = 0;
};

bool IsFeasible(const CurvatureProgram& program, const Eigen::VectorXd& mu) {
  if (mu.size() != program.lower.size()) return false;
  if ((mu.array() < program.lower.array()).any() || (mu.array() > program.upper.array()).any()) {
    return false;
  }
  return !program.total ||
         std::abs(mu.sum() - *program.total) <= kSumTolerance * (1 + mu.lpNorm<1>());
}

}  // namespace

std::optional<Eigen::VectorXd> Minimize(const CurvatureProgram& program) {
  const Eigen::VectorXd width = program.upper - program.lower;
  if (width.size() > 0 && width.minCoeff() < 0) return std::nullopt;
  if (IsFeasible(program, program.start)) return ActiveSet(program, program.start).Run();
  Eigen::VectorXd start = Eigen::VectorXd::Zero(width.size());
  start = start.cwiseMax(program.lower).cwiseMin(program.upper);
  if (program.total) {
    const double share = width.sum() > 0 ? (*program.total - program.lower.sum()) / width.sum() : 0;
    const bool met = width.sum() > 0 || std::abs(*program.total - program.lower.sum()) < 1e-12;
    if (!met || share < 0 || share > 1) return std::nullopt;
    start = program.lower + share * width;
  }
  return ActiveSet(program, std::move(start)).Run();
}

}  // namespace cirque
