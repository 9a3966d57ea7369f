#include "cirque/layout/moebius_normalization.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <string>

#include <Eigen/Cholesky>
#include <fmt/format.h>

#include "cirque/energy/lorentz_energy.h"
#include "cirque/solver/solve_run.h"

namespace cirque {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

/// The hyperbolic length beyond which 1 - |x| = 2 e^{-2 r} loses too many of its bits.
constexpr double kLongestStep = 15;
/// Newton's step is trusted up to this length; beyond, the gradient's direction is.
constexpr double kNewtonRange = 1;
constexpr double kUnitTolerance = 1e-6;
constexpr int kMaxBisections = 60;

std::string Fault(const std::vector<Vector3d>& points, const std::vector<double>& weights) {
  if (points.empty()) return "there is no point to centre";
  if (points.size() != weights.size()) {
    return fmt::format("{} points but {} weights", points.size(), weights.size());
  }
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (!(std::abs(points[i].norm() - 1) < kUnitTolerance)) {
      return fmt::format("point {} is no unit vector: its length is {}", i, points[i].norm());
    }
    if (!(weights[i] > 0 && std::isfinite(weights[i]))) {
      return fmt::format("the weight of point {} is {}, not positive", i, weights[i]);
    }
  }
  const double total = std::accumulate(weights.begin(), weights.end(), 0.0);
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (!(weights[i] < 0.5 * total)) {
      return fmt::format("point {} has at least half of all weight: no boost centres it", i);
    }
  }
  return "";
}

/// dS/dr at hyperbolic distance r from 0 along the unit vector u:
///   sum w (tanh r - v.u) / (1 - v.u tanh r), with both sides scaled to stay exact near v = u.
double SlopeAlong(const std::vector<Vector3d>& points, const std::vector<double>& weights,
                  const Vector3d& u, double r) {
  const double q = std::exp(-2 * r);  // tanh r = (1 - q)/(1 + q)
  double slope = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double near = (points[i] - u).squaredNorm(), far = (points[i] + u).squaredNorm();
    slope += weights[i] * (near - q * far) / (near + q * far);
  }
  return slope;
}

/// How far to go along u: `length` where that brings the slope down well, else to the minimum.
double SearchGeodesic(const std::vector<Vector3d>& points, const std::vector<double>& weights,
                      const Vector3d& u, double length) {
  const double start = SlopeAlong(points, weights, u, 0);
  if (std::abs(SlopeAlong(points, weights, u, length)) <= 0.5 * std::abs(start)) return length;
  double low = 0, high = kLongestStep;
  if (SlopeAlong(points, weights, u, high) <= 0) return high;
  for (int i = 0; i < kMaxBisections && high - low > 1e-3 * high; ++i) {
    const double middle = 0.5 * (low + high);
    (SlopeAlong(points, weights, u, middle) < 0 ? low : high) = middle;
  }
  return low > 0 ? low : high;
}

/// The ball vector of the next step from the centre.
Vector3d Step(const std::vector<Vector3d>& points, const std::vector<double>& weights,
              const Vector3d& gradient, const Matrix3d& hessian) {
  Vector3d step = -hessian.ldlt().solve(gradient);
  // Where points crowd, the Hessian is singular to rounding and its inverse noise.
  if (!(step.norm() < kNewtonRange && step.dot(gradient) < 0)) {
    step = -kNewtonRange * gradient.normalized();
  }
  const Vector3d direction = step.normalized();
  return std::tanh(SearchGeodesic(points, weights, direction, step.norm())) * direction;
}

void Iterate(const std::vector<double>& weights, SolveRun* run, LorentzNormalization* result) {
  const Eigen::VectorXd centre = Vector3d::Zero();
  Eigen::VectorXd gradient;
  if (!run->Begin(centre, &gradient)) return;
  SparseMatrix lower;
  while (run->Continue(gradient)) {
    run->Hessian(centre, &lower);
    const Matrix3d hessian = Eigen::MatrixXd(lower).selfadjointView<Eigen::Lower>();
    const Vector3d x = Step(result->points, weights, gradient, hessian);
    const LorentzBoost boost(x);
    for (Vector3d& v : result->points) v = boost(v);
    result->boosts.push_back(boost);
    run->Gradient(centre, &gradient);
    if (!run->Accept(x, gradient, 1)) return;
  }
}

}  // namespace

LorentzNormalization MinimizeLorentz(const std::vector<Vector3d>& points,
                                     const std::vector<double>& weights, const SolverLimits& limits,
                                     const SolveControl& control) {
  LorentzNormalization result;
  result.points = points;
  result.summary.strategy = "recentred newton";
  if (std::string fault = Fault(points, weights); !fault.empty()) {
    result.summary.termination = Termination::kInvalidStart;
    result.summary.message = std::move(fault);
    return result;
  }
  const double total = std::accumulate(weights.begin(), weights.end(), 0.0);
  std::vector<double> shares = weights;
  for (double& w : shares) w /= total;
  for (Vector3d& v : result.points) v.normalize();
  // The energy refers to the points that the iteration moves.
  const LorentzEnergy energy(result.points, shares);
  SolveRun run("recentred newton", limits, control, energy);
  Iterate(shares, &run, &result);
  result.summary = run.Finish(Vector3d::Zero());
  return result;
}

namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

constexpr double kLongestBoost = 0.9;  ///< as a vector of Klein's ball
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
  return step.norm() > kLongestBoost ? Vector3d(kLongestBoost * step.normalized()) : step;
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
