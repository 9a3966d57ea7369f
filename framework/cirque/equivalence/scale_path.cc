#include "cirque/equivalence/scale_path.h"

#include <algorithm>
#include <limits>

#include "cirque/equivalence/laplacian_newton.h"
#include "cirque/solver/newton_strategies.h"

namespace cirque {
namespace {

constexpr double kFirstStepOnPath = 0.1, kLeastStepOnPath = 1e-6;
constexpr int kLeastSolvesOnPath = 20, kMostSolvesOnPath = 300, kMostStepsOnPath = 20,
              kMostStepsToPath = 200, kIdlePartsOnPath = 5;
constexpr int kUnknownsOnPath = 200000;  ///< in all solves together

class PathFollower {
 public:
  PathFollower(const ScaleProblem& problem, ScalePath path, const SolveControl& control,
               VertexScales* scales)
      : problem_(problem), path_(path), control_(control), scales_(*scales) {}

  bool Follow() {
    const int n = static_cast<int>(problem_.targets.angle_sum.size());
    scales_.assign(scales_.size(), 0);
    if (path_ == ScalePath::kFromZero) return true;
    Eigen::VectorXd zero = Eigen::VectorXd::Zero(n), ahead = zero;
    missing_.resize(n);
    if (!problem_.EnergyFrom(scales_).Gradient(zero.data(), missing_.data())) return false;
    const int most_solves =
        std::clamp(kUnknownsOnPath / std::max(n, 1), kLeastSolvesOnPath, kMostSolvesOnPath);
    double done = 0, step = kFirstStepOnPath;
    if (path_ == ScalePath::kLengths && !Reach([&] { return At(0); }, kMostStepsToPath, &zero)) {
      return false;
    }
    for (int solves = 0; done < 1; ++solves) {
      if (solves == most_solves) return false;
      const double next = std::min(1.0, done + step);
      Eigen::VectorXd moved = (next - done) * ahead;
      const bool reached = Reach([&] { return At(next); }, kMostStepsOnPath, &moved);
      if (reached) ahead = moved / (next - done);
      if (reached) done = next;
      step *= reached ? 2 : 0.25;
      if (step < kLeastStepOnPath) return false;
    }
    return true;
  }

 private:
  /// The energy at a fraction of the path.
  ConformalEquivalenceEnergy At(double fraction) const {
    if (path_ == ScalePath::kLengths) {
      return {problem_.start.triangulation, fraction * problem_.log_lengths, problem_.targets,
              problem_.flips, scales_};
    }
    ScaleTargets now = problem_.targets;
    now.angle_sum -= (1 - fraction) * missing_;
    return {problem_.start.triangulation, problem_.log_lengths, now, problem_.flips, scales_};
  }

  /// Minimises what `problem` makes at scales_, from u on, and moves scales_ and u there; leaves both where
  /// they are short of that. u is counted anew, after every part, as long as that helps.
  template <class Problem>
  bool Reach(const Problem& problem, int most_steps, Eigen::VectorXd* u) {
    const VertexScales start = scales_;
    SolverLimits limits{most_steps, kNearScaleResidual};
    Eigen::VectorXd step = *u, moved = Eigen::VectorXd::Zero(u->size());
    double least = std::numeric_limits<double>::infinity();
    for (int idle = 0; idle < kIdlePartsOnPath;) {
      const ConformalEquivalenceEnergy energy = problem();
      const SolveSummary solve =
          MinimizeScalesRobustly(energy, problem_.IsClosed(), limits, control_, &step);
      if (solve.termination == Termination::kCancelled) break;
      AdvanceScales(energy.ScaleOfVertices(step.data()), &scales_);
      moved += step;
      if (solve.final_gradient_max <= kNearScaleResidual) {
        *u = moved;
        return true;
      }
      if (solve.num_iterations() == 0) break;
      idle = solve.final_gradient_max < kLessResidual * least ? 0 : idle + 1;
      least = std::min(least, solve.final_gradient_max);
      limits.max_iterations = kScaleIterationsInPart;
      step.setZero();
    }
    scales_ = start;
    return false;
  }

  const ScaleProblem& problem_;
  const ScalePath path_;
  const SolveControl& control_;
  VertexScales& scales_;
  Eigen::VectorXd missing_;  ///< of the surface's own angle sums, over the targets
};

}  // namespace

bool FollowScalePath(const ScaleProblem& problem, ScalePath path, const SolveControl& control,
                     VertexScales* scales) {
  return PathFollower(problem, path, control, scales).Follow();
}

SolveSummary MinimizeScalesRobustly(const ConformalEquivalenceEnergy& energy, bool is_closed,
                                    const SolverLimits& limits, const SolveControl& control,
                                    Eigen::VectorXd* u) {
  if (is_closed && u->size() <= kMostLaplacianUnknowns) {
    return MinimizeByLaplacians(energy, limits, control, u);
  }
  return NewtonStrategy({limits, ""}).Minimize(energy, control, u);
}

void AdvanceScales(const Eigen::VectorXd& by, VertexScales* scales) {
  for (std::size_t v = 0; v < scales->size(); ++v) {
    (*scales)[v] = (*scales)[v] + by[static_cast<Eigen::Index>(v)];
  }
}

}  // namespace cirque
