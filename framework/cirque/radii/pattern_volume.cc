#include "cirque/radii/pattern_volume.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

#include "cirque/core/parallel.h"
#include "cirque/energy/dual_laplacian.h"
#include "cirque/math/compensated_sum.h"
#include "cirque/math/elementary_arrays.h"
#include "cirque/math/parallel_chunks.h"
#include "cirque/solver/newton_loop.h"

namespace cirque {
namespace {

constexpr int kMaxIterations = 30, kMaxHalvings = 30;
constexpr double kKeptShare = 0.05;  ///< of an angle, at least, in one step
/// The slope at the end of a step, relative to its start, that is still accepted.
constexpr double kOvershoot = 0.5;
constexpr double kLeastProgress = 0.9;  ///< of the gradient over two steps

/// The corner angles and the Newton step that moves them.
class Volume {
 public:
  Volume(const Triangulation& t, const Eigen::VectorXd& angles, const DualLaplacian& laplacian,
         VolumeDomain* domain)
      : t_(t), laplacian_(laplacian), domain_(*domain), phi_(angles) {}

  /// The normal equations of the least-squares problem at the present angles.
  void Linearize(SparseMatrix* lower, Eigen::VectorXd* right_side) {
    MeasureSprings();
    Eigen::VectorXd weight(t_.num_halfedges()), force(t_.num_halfedges());
    ParallelFor(t_.num_edges(), [&](Index e) {
      const Index h = t_.edge_halfedge[e], g = t_.twin[h];
      weight[h] = springs_[e].weight;
      force[h] = springs_[e].weight * springs_[e].log_ratio;
      if (g == kNone) return;
      weight[g] = weight[h];
      force[g] = -force[h];
    });
    right_side->resize(t_.num_faces());
    ParallelFor(t_.num_faces(), [&](Index f) { (*right_side)[f] = force.segment<3>(3 * f).sum(); });
    laplacian_.Assemble(weight, lower);
  }

  /// Moves the angles along the step that these multipliers give, as far as they stay positive and
  /// V rises. @pre Linearize at these angles.
  void Step(const Eigen::VectorXd& rho) {
    Eigen::VectorXd step(t_.num_edges());
    std::vector<double> longest(NumBlocks(t_.num_edges()), 1);
    ForEachBlock(t_.num_edges(), [&](int block, Index begin, Index end) {
      for (Index e = begin; e < end; ++e) {
        step[e] = StepOf(e, rho);
        longest[block] = std::min(longest[block], LongestStep(e, step[e]));
      }
    });
    double t = domain_.Least(*std::min_element(longest.begin(), longest.end()));
    const double slope = SlopeAt(0, step);
    for (int i = 0; i < kMaxHalvings && SlopeAt(t, step) < -kOvershoot * slope; ++i) t *= 0.5;
    ParallelFor(t_.num_edges(), [&](Index e) {
      if (!IsInterior(e)) return;
      phi_[Left(e)] += t * step[e];
      phi_[Right(e)] -= t * step[e];
    });
  }

 private:
  /// How an interior edge couples its faces; all 0 on the boundary.
  struct Spring {
    double weight = 0, log_ratio = 0;
  };

  Index Left(Index e) const { return t_.edge_halfedge[e]; }
  Index Right(Index e) const { return t_.twin[Left(e)]; }
  bool IsInterior(Index e) const { return Right(e) != kNone; }

  /// sin phi on the left and right of edges, of which phi is given.
  struct Sides {
    ChunkOf<> left, right;

    explicit Sides(int edges) : left(edges), right(edges) {}

    /// log(sin right / sin left), once both are sines.
    ChunkOf<> LogRatio() const {
      ChunkOf<> ratio = right;
      for (std::size_t k = 0; k < ratio.size(); ++k) ratio[k] /= left[k];
      Logarithms(ratio, ratio);
      return ratio;
    }
    void TakeSines() {
      Sines(left, left);
      Sines(right, right);
    }
  };

  /// The angles beside edges after a share of a step; of the boundary a right one to go on with.
  Sides AnglesAfter(Index first, Index end, double share, const Eigen::VectorXd* step) const {
    Sides phi(end - first);
    for (Index e = first; e < end; ++e) {
      const double moved = step ? share * (*step)[e] : 0;
      phi.left[e - first] = phi_[Left(e)] + moved;
      phi.right[e - first] =
          IsInterior(e) ? phi_[Right(e)] - moved : (kPi - phi.left[e - first]) / 2;
    }
    return phi;
  }

  void MeasureSprings() {
    springs_.resize(t_.num_edges());
    ParallelChunks(t_.num_edges(), [&](Index first, Index end) {
      Sides sides = AnglesAfter(first, end, 0, nullptr);
      ChunkOf<> sum = sides.left;
      for (std::size_t k = 0; k < sum.size(); ++k) sum[k] += sides.right[k];
      Sines(sum, sum);
      sides.TakeSines();
      const ChunkOf<> log_ratio = sides.LogRatio();
      for (Index e = first; e < end; ++e) {
        const Index k = e - first;
        springs_[e] = IsInterior(e) ? Spring{sides.left[k] * sides.right[k] / sum[k], log_ratio[k]}
                                    : Spring();
      }
    });
  }

  double StepOf(Index e, const Eigen::VectorXd& rho) const {
    if (!IsInterior(e)) return 0;
    const Spring& spring = springs_[e];
    const double difference =
        rho[Triangulation::Face(Left(e))] - rho[Triangulation::Face(Right(e))];
    return spring.weight * (spring.log_ratio - difference);
  }

  /// Up to where both angles keep their share.
  double LongestStep(Index e, double step) const {
    if (step == 0) return std::numeric_limits<double>::infinity();
    return (1 - kKeptShare) * phi_[step < 0 ? Left(e) : Right(e)] / std::abs(step);
  }

  /// dV/dt after a share t of the step.
  double SlopeAt(double t, const Eigen::VectorXd& step) const {
    return domain_.Sum(
        ParallelSumOfChunks(t_.num_edges(), [&](Index first, Index end, CompensatedSum* sum) {
          Sides sides = AnglesAfter(first, end, t, &step);
          sides.TakeSines();
          const ChunkOf<> log_ratio = sides.LogRatio();
          for (Index e = first; e < end; ++e) {
            if (!IsInterior(e) || !domain_.Counts(Triangulation::Face(Left(e)))) continue;
            *sum += step[e] * log_ratio[e - first];
          }
        }));
  }

  const Triangulation& t_;
  const DualLaplacian& laplacian_;
  VolumeDomain& domain_;
  Eigen::VectorXd phi_;          ///< per halfedge, the corner angle opposite it [rad]
  std::vector<Spring> springs_;  ///< of edges, at these angles
};

/// All on this process.
class WholeDomain final : public VolumeDomain {
 public:
  WholeDomain(const CirclePatternEnergy& energy, SystemSolver* solver, SolveSummary* summary)
      : damping_(energy), solver_(*solver), summary_(*summary) {}

  bool SolveForChange(SparseMatrix* lower, const Eigen::VectorXd& right_side,
                      const Eigen::VectorXd& rho, Eigen::VectorXd* change) override {
    damping_.DampHessian(lower);
    const Eigen::VectorXd missing = right_side - lower->selfadjointView<Eigen::Lower>() * rho;
    return solver_.Solve(*lower, missing, {kVolumeTolerance}, change, &summary_);
  }
  double Sum(double mine) override { return mine; }
  double Least(double mine) override { return mine; }
  double LargestEntry(const Eigen::VectorXd& gradient) override {
    return gradient.lpNorm<Eigen::Infinity>();
  }
  bool Counts(Index) const override { return true; }

 private:
  LevenbergMarquardtDamping damping_;
  SystemSolver& solver_;
  SolveSummary& summary_;
};

}  // namespace

void MaximizeVolume(const Triangulation& t, const Eigen::VectorXd& angles,
                    const CirclePatternEnergy& energy, double gradient_max, VolumeDomain* domain,
                    Eigen::VectorXd* rho) {
  Volume volume(t, angles, energy.laplacian(), domain);
  rho->setZero(t.num_faces());
  double before = std::numeric_limits<double>::infinity(), last = before;
  for (int i = 0; i < kMaxIterations; ++i) {
    // The multipliers change less and less: solve for their change.
    Eigen::VectorXd change;
    {
      SparseMatrix lower;
      Eigen::VectorXd right_side;
      volume.Linearize(&lower, &right_side);
      if (!domain->SolveForChange(&lower, right_side, *rho, &change)) break;
    }
    *rho += change;
    Eigen::VectorXd gradient(t.num_faces());
    energy.Gradient(rho->data(), gradient.data());
    const double now = domain->LargestEntry(gradient);
    if (now <= gradient_max || now > kLeastProgress * before) break;
    before = last;
    last = now;
    volume.Step(*rho);
  }
}

SolveSummary MaximizePatternVolume(const Triangulation& t, const CoherentAngles& angles,
                                   const CirclePatternEnergy& energy, double gradient_max,
                                   SystemSolver* solver, Eigen::VectorXd* rho) {
  SolveSummary summary;
  WholeDomain domain(energy, solver, &summary);
  MaximizeVolume(t, angles.value, energy, gradient_max, &domain, rho);
  return summary;
}

}  // namespace cirque
