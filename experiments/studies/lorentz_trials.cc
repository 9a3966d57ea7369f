#include "experiments/studies/lorentz_trials.h"

#include <cmath>
#include <numeric>
#include <random>

#include <Eigen/LU>

#include "cirque/energy/lorentz_energy.h"
#include "cirque/layout/moebius_normalization.h"
#include "cirque/math/lorentz.h"
#include "cirque/solver/newton_strategy.h"

namespace cirque {
namespace {

using Eigen::Vector3d;

constexpr int kMostSteps = 200;
constexpr double kTolerance = 1e-14;

double CentreOf(const std::vector<Vector3d>& points) {
  return std::accumulate(points.begin(), points.end(), Vector3d(0, 0, 0)).norm() /
         static_cast<double>(points.size());
}

std::vector<double> EqualShares(const std::vector<Vector3d>& points) {
  return std::vector<double>(points.size(), 1.0 / static_cast<double>(points.size()));
}

/// Where the boost by the ball vector x leaves the centre of mass.
double CentreAfter(const std::vector<Vector3d>& points, const Vector3d& x) {
  const LorentzBoost boost(x);
  std::vector<Vector3d> moved;
  for (const Vector3d& v : points) moved.push_back(boost(v));
  return CentreOf(moved);
}

}  // namespace

std::vector<Vector3d> Crowd(int count, double scale, unsigned seed) {
  std::mt19937_64 random(seed);
  std::normal_distribution<double> normal;
  const auto unit = [&] {
    const double x = normal(random), y = normal(random), z = normal(random);
    return Vector3d(x, y, z).normalized();
  };
  const Vector3d centre = unit();
  std::vector<Vector3d> points;
  for (int i = 0; i < count; ++i) points.push_back((centre + scale * unit()).normalized());
  return points;
}

LorentzTrial RecentredNewton(const std::vector<Vector3d>& points) {
  SolverLimits limits;
  limits.max_iterations = kMostSteps;
  limits.gradient_tolerance = kTolerance;
  const LorentzNormalization result = MinimizeLorentz(points, EqualShares(points), limits);
  return {result.summary.num_iterations(), CentreOf(result.points),
          ToString(result.summary.termination)};
}

LorentzTrial NewtonInBall(const std::vector<Vector3d>& points) {
  NewtonOptions options;
  options.max_iterations = kMostSteps;
  options.gradient_tolerance = kTolerance;
  const std::vector<double> weights = EqualShares(points);
  const LorentzEnergy energy(points, weights);
  Eigen::VectorXd x = Vector3d::Zero();
  const SolveSummary summary = NewtonStrategy(options).Minimize(energy, {}, &x);
  return {summary.num_iterations(), CentreAfter(points, x), ToString(summary.termination)};
}

LorentzTrial FullNewtonInBall(const std::vector<Vector3d>& points) {
  const std::vector<double> weights = EqualShares(points);
  const LorentzEnergy energy(points, weights);
  LorentzTrial trial{0, CentreOf(points), "iteration_limit"};
  Vector3d x = Vector3d::Zero();
  for (; trial.iterations < kMostSteps; ++trial.iterations) {
    const LorentzJet jet = energy.Jet(x);
    if (jet.slope.norm() <= kTolerance) {
      trial.outcome = "converged";
      break;
    }
    x -= jet.curvature.partialPivLu().solve(jet.slope);
    if (!(x.norm() < 1)) {
      trial.outcome = "left the ball";
      ++trial.iterations;
      return trial;
    }
    trial.centre = CentreAfter(points, x);
  }
  return trial;
}

}  // namespace cirque
