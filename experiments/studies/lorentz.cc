// The re-centred Newton method against Newton's method in ball coordinates: results/lorentz.md.
#include <cmath>
#include <numeric>
#include <random>
#include <string>
#include <vector>

#include <Eigen/LU>
#include <fmt/format.h>
#include <gflags/gflags.h>

#include "cirque/energy/lorentz_energy.h"
#include "cirque/layout/moebius_normalization.h"
#include "cirque/math/moebius.h"
#include "cirque/solver/newton_strategies.h"

#include "experiments/studies/studies.h"

DEFINE_int32(points, 1000, "how many points crowd");
DEFINE_int32(seed, 1, "of their places");

namespace cirque {
namespace {

using Eigen::Vector3d;

constexpr int kMostSteps = 200;
constexpr double kTolerance = 1e-14;
constexpr int kScales = 13;  ///< 1 to 1e-12

/// How one method ended on one set of points.
struct LorentzTrial {
  int iterations = 0;
  double centre = 0;    ///< |centre of mass| of the points as the method leaves them
  std::string outcome;  ///< "converged", or why not
};

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

/// `count` points within about `scale` of one direction, all from the seed.
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

/// MinimizeLorentz.
LorentzTrial RecentredNewton(const std::vector<Vector3d>& points) {
  SolverLimits limits;
  limits.max_iterations = kMostSteps;
  limits.gradient_tolerance = kTolerance;
  const LorentzNormalization result = MinimizeLorentz(points, EqualShares(points), limits);
  return {result.summary.num_iterations(), CentreOf(result.points),
          ToString(result.summary.termination)};
}

/// The strategy `newton`, with its line search, on the energy in ball coordinates.
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

/// Full steps x - H^-1 g in ball coordinates, as in the thesis.
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

std::string Cells(const LorentzTrial& trial) {
  return fmt::format(" {} | {:.1e} | {} |", trial.iterations, trial.centre, trial.outcome);
}

std::string Table() {
  std::string text = fmt::format(
      "# Newton's method on the Lorentz energy\n\n"
      "Made by `studies lorentz --output=results/lorentz.md`: {} points within `scale` of one "
      "direction, equal weights; converged where the gradient is at most 1e-14. *re-centred*: "
      "MinimizeLorentz; *line search*: the strategy `newton` in ball coordinates; *full steps*: "
      "the same without its line search, as in the thesis. *centre*: distance of the boosted "
      "points' "
      "centre of mass from 0.\n\n"
      "| scale | re-centred steps | centre | outcome | line search steps | centre | outcome | full "
      "steps | centre | outcome |\n|--:|--:|--:|---|--:|--:|---|--:|--:|---|\n",
      FLAGS_points);
  double scale = 1;
  for (int i = 0; i < kScales; ++i, scale /= 10) {
    const auto points = Crowd(FLAGS_points, scale, static_cast<unsigned>(FLAGS_seed));
    text += fmt::format("| {:.0e} |", scale) + Cells(RecentredNewton(points)) +
            Cells(NewtonInBall(points)) + Cells(FullNewtonInBall(points)) + "\n";
  }
  return text;
}

}  // namespace

Status RunLorentz(const StudyCall& call) {
  if (Status s = NoArguments(call); !s.ok()) return s;
  if (FLAGS_points < 4) return Status::InvalidInput("--points: at least 4 are needed");
  return Deliver(Table());
}

}  // namespace cirque
