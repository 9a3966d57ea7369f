#include "cirque/layout/log_scale_normalization.h"

#include <cmath>
#include <limits>
#include <numeric>

#include <Eigen/Cholesky>

namespace cirque {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

constexpr double kLongestStep = 0.9;  ///< as a vector of Klein's ball
constexpr double kArmijo = 1e-4, kShortest = 1e-10;
/// E is a sum of squares of logarithms that are exact to about 1e-14.
constexpr double kRounding = 1e-13;

/// E and its derivatives at x = 0.
struct Jet {
  double value = 0;
  Vector3d gradient = Vector3d::Zero();
  Matrix3d gauss_newton = Matrix3d::Zero(), hessian = Matrix3d::Zero();
};

class MeanSquare {
 public:
  explicit MeanSquare(const ScaledEdges& edges)
      : edges_(edges), total_(std::accumulate(edges.weight.begin(), edges.weight.end(), 0.0)) {}

  double Value(const std::vector<Vector3d>& points) const {
    double sum = 0;
    for (std::size_t e = 0; e < edges_.ends.size(); ++e) {
      const double scale = LogScale(points, e);
      sum += Share(e) * scale * scale;
    }
    return sum;
  }

  Jet Derivatives(const std::vector<Vector3d>& points) const {
    Jet jet;
    for (std::size_t e = 0; e < edges_.ends.size(); ++e) {
      const auto& [i, j] = edges_.ends[e];
      const double share = Share(e), scale = LogScale(points, e);
      const Vector3d middle = 0.5 * (points[i] + points[j]);
      jet.value += share * scale * scale;
      jet.gradient += 2 * share * scale * middle;
      jet.gauss_newton += 2 * share * middle * middle.transpose();
      jet.hessian += share * scale *
                     (points[i] * points[i].transpose() + points[j] * points[j].transpose() -
                      2 * Matrix3d::Identity());
    }
    jet.hessian += jet.gauss_newton;
    return jet;
  }

 private:
  double Share(std::size_t e) const { return edges_.weight[e] / total_; }

  double LogScale(const std::vector<Vector3d>& points, std::size_t e) const {
    const auto& [i, j] = edges_.ends[e];
    // Points that doubles cannot tell apart count as one rounding error apart.
    const double chord =
        std::max((points[i] - points[j]).norm(), std::numeric_limits<double>::epsilon());
    return std::log(chord / edges_.length[e]);
  }

  const ScaledEdges& edges_;
  const double total_;
};

Vector3d NewtonStep(const Jet& jet) {
  const Eigen::LLT<Matrix3d> newton(jet.hessian);
  Vector3d step = newton.info() == Eigen::Success
                      ? Vector3d(-newton.solve(jet.gradient))
                      : Vector3d(-jet.gauss_newton.ldlt().solve(jet.gradient));
  const bool descends = step.allFinite() && step.dot(jet.gradient) < 0;
  if (!descends) step = -jet.gradient;
  return step.norm() > kLongestStep ? Vector3d(kLongestStep * step.normalized()) : step;
}

std::vector<Vector3d> Boosted(const std::vector<Vector3d>& points, const LorentzBoost& boost) {
  std::vector<Vector3d> moved;
  moved.reserve(points.size());
  for (const Vector3d& v : points) moved.push_back(boost(v));
  return moved;
}

}  // namespace

LogScaleNormalization MinimizeLogScale(std::vector<Vector3d> points, const ScaledEdges& edges,
                                       const SolverLimits& limits) {
  const MeanSquare energy(edges);
  LogScaleNormalization result;
  while (true) {
    const Jet jet = energy.Derivatives(points);
    result.value = jet.value;
    result.gradient = jet.gradient.cwiseAbs().maxCoeff();
    result.converged = result.gradient <= limits.gradient_tolerance;
    if (result.converged || result.iterations == limits.max_iterations) return result;
    const Vector3d step = NewtonStep(jet);
    const double slope = step.dot(jet.gradient);
    double length = 1;
    for (; length > kShortest; length /= 2) {
      const LorentzBoost boost(length * step);
      std::vector<Vector3d> moved = Boosted(points, boost);
      const double limit = jet.value + kArmijo * length * slope + kRounding * jet.value;
      if (!(energy.Value(moved) <= limit)) continue;
      points = std::move(moved);
      result.boosts.push_back(boost);
      break;
    }
    if (!(length > kShortest)) return result;
    ++result.iterations;
  }
}

}  // namespace cirque
