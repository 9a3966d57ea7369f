#include "cirque/radii/pattern_volume.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "cirque/core/parallel.h"
#include "cirque/energy/dual_laplacian.h"
#include "cirque/math/parallel_sum.h"
#include "cirque/solver/regularization.h"

namespace cirque {
namespace {

constexpr int kMaxIterations = 30, kMaxHalvings = 30;
constexpr double kKeptShare = 0.05;  ///< of an angle, at least, in one step
constexpr double kOvershoot =
    0.5;  ///< slope at the end of a step, relative to its start, that is still accepted
constexpr double kTolerance = 1e-2;     ///< of the change of the multipliers
constexpr double kLeastProgress = 0.9;  ///< of the gradient over two steps

/// The interior edges' angles and the Newton step that moves them.
class Volume {
 public:
  Volume(const Triangulation& t, const CoherentAngles& angles, const DualLaplacian& laplacian)
      : num_faces_(t.num_faces()), laplacian_(laplacian) {
    edges_.reserve(t.num_edges());
    for (const Index h : t.edge_halfedge) {
      const Index g = t.twin[h];
      if (g == kNone) continue;
      edges_.push_back({h, g, Triangulation::Face(h), Triangulation::Face(g), angles.value[h],
                        angles.value[g], 0, 0, 0});
    }
  }

  /// The normal equations of the least-squares problem at the present angles.
  void Linearize(SparseMatrix* lower, Eigen::VectorXd* right_side) {
    Eigen::VectorXd weight = Eigen::VectorXd::Zero(3 * num_faces_), force = weight;
    ForEachEdge([&](Edge& e) {
      const double sin_i = std::sin(e.phi_i), sin_j = std::sin(e.phi_j);
      e.weight = sin_i * sin_j / std::sin(e.phi_i + e.phi_j);
      e.log_ratio = std::log(sin_j / sin_i);
      weight[e.h] = weight[e.g] = e.weight;
      force[e.h] = e.weight * e.log_ratio;
      force[e.g] = -force[e.h];
    });
    right_side->resize(num_faces_);
    ParallelFor(num_faces_, [&](int f) { (*right_side)[f] = force.segment<3>(3 * f).sum(); });
    laplacian_.Assemble(weight, lower);
  }

  /// Moves the angles along the step that these multipliers give, as far as they stay positive and
  /// V rises.
  void Step(const Eigen::VectorXd& rho) {
    double t = 1;
    for (Edge& e : edges_) {
      e.step = e.weight * (e.log_ratio - (rho[e.i] - rho[e.j]));
      t = std::min({t, LongestStep(e.phi_i, e.step), LongestStep(e.phi_j, -e.step)});
    }
    const double slope = SlopeAt(0);
    for (int i = 0; i < kMaxHalvings && SlopeAt(t) < -kOvershoot * slope; ++i) t *= 0.5;
    ForEachEdge([t](Edge& e) {
      e.phi_i += t * e.step;
      e.phi_j -= t * e.step;
    });
  }

 private:
  struct Edge {
    Index h, g;           ///< its halfedges
    int i, j;             ///< the faces left of them
    double phi_i, phi_j;  ///< their corner angles opposite it [rad]
    double weight, log_ratio, step;
  };

  static double LongestStep(double angle, double step) {
    return step < 0 ? -(1 - kKeptShare) * angle / step : std::numeric_limits<double>::infinity();
  }

  /// dV/dt after a share t of the step.
  double SlopeAt(double t) const {
    return ParallelSum(static_cast<int>(edges_.size()), [&](int k) {
      const Edge& e = edges_[k];
      return e.step * std::log(std::sin(e.phi_j - t * e.step) / std::sin(e.phi_i + t * e.step));
    });
  }

  template <class Body>
  void ForEachEdge(const Body& body) {
    ParallelFor(static_cast<int>(edges_.size()), [&](int k) { body(edges_[k]); });
  }

  int num_faces_;
  const DualLaplacian& laplacian_;
  std::vector<Edge> edges_;
};

}  // namespace

SolveSummary MaximizePatternVolume(const Triangulation& t, const CoherentAngles& angles,
                                   const CirclePatternEnergy& energy, double gradient_max,
                                   SystemSolver* solver, Eigen::VectorXd* rho) {
  Volume volume(t, angles, energy.laplacian());
  SolveSummary summary;
  HessianShift shift(energy);
  SparseMatrix lower;
  Eigen::VectorXd right_side, gradient(t.num_faces());
  rho->setZero(t.num_faces());
  double before = std::numeric_limits<double>::infinity(), last = before;
  for (int i = 0; i < kMaxIterations; ++i) {
    volume.Linearize(&lower, &right_side);
    // The multipliers change less and less: solve for their change.
    const SparseMatrix& matrix = shift.Apply(lower);
    Eigen::VectorXd change;
    const Eigen::VectorXd missing = right_side - matrix.selfadjointView<Eigen::Lower>() * *rho;
    if (!solver->Solve(matrix, missing, {kTolerance}, &change, &summary)) break;
    *rho += change;
    energy.Gradient(rho->data(), gradient.data());
    const double now = gradient.lpNorm<Eigen::Infinity>();
    if (now <= gradient_max || now > kLeastProgress * before) break;
    before = last;
    last = now;
    volume.Step(*rho);
  }
  return summary;
}

}  // namespace cirque
