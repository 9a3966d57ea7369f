#include "cirque/cones/log_scale_norm.h"

#include <cmath>
#include <utility>
#include <vector>

#include "cirque/linear/conjugate_gradients.h"

namespace cirque {
namespace {

constexpr double kCgTolerance = 1e-4;  ///< of a Newton step
constexpr int kMostCgIterations = 100;
constexpr int kMostNewtonSteps = 12, kMostHalvings = 12;
constexpr double kLeastDecrease = 1e-5;  ///< relative, of a Newton step after which another follows

/// f(b) = 1/p sum_v a_v |u_v|^p + 1/2 filter sum len^2 (b_i - b_j)^2, u = u_0 + H b, the second sum
/// over the boundary edges between open vertices, lengths of a surface of area 1. Convex.
class LogScaleNorm {
 public:
  LogScaleNorm(const BoundaryProblem& problem, int power, double filter)
      : problem_(problem), power_(power) {
    const IntrinsicSurface& surface = problem.surface();
    const Triangulation& t = surface.triangulation;
    const double area = SurfaceArea(surface);
    for (Index e = 0; e < t.num_edges() && filter > 0; ++e) {
      const Index h = t.edge_halfedge[e];
      if (!t.IsBoundaryEdge(e) || !problem.IsOpen(t.Tail(h)) || !problem.IsOpen(t.Tip(h))) continue;
      const double length = surface.lengths.value[e];
      springs_.push_back({t.Tail(h), t.Tip(h), filter * length * length / area});
    }
  }

  double Value(const Eigen::VectorXd& b, const Eigen::VectorXd& u) const {
    return problem_.area().dot(u.array().abs().pow(power_).matrix()) / power_ +
           0.5 * b.dot(Stretched(b));
  }

  Eigen::VectorXd Gradient(const Eigen::VectorXd& b, const Eigen::VectorXd& u) const {
    const Eigen::VectorXd slope =
        (problem_.area().array() * u.array().abs().pow(power_ - 2) * u.array()).matrix();
    return problem_.HarmonicAdjoint(slope) + Stretched(b);
  }

  /// The Newton step: with W = (p - 1) a |u|^(p - 2) that of the quadratic form H' W H + filter.
  Eigen::VectorXd Step(const Eigen::VectorXd& u, const Eigen::VectorXd& gradient) const {
    const Eigen::VectorXd weight =
        ((power_ - 1) * problem_.area().array() * (u.array().abs().pow(power_ - 2) + Floor(u)))
            .matrix();
    const auto apply = [&](const Eigen::VectorXd& x, Eigen::VectorXd* y) {
      *y = problem_.HarmonicAdjoint(weight.cwiseProduct(problem_.Harmonic(x))) + Stretched(x);
    };
    const Eigen::VectorXd diagonal = weight + Stiffness();
    const auto precondition = [&](const Eigen::VectorXd& x, Eigen::VectorXd* y) {
      *y = x.cwiseQuotient(diagonal);
    };
    Eigen::VectorXd step = Eigen::VectorXd::Zero(u.size());
    ConjugateGradients(apply, -gradient, precondition, kCgTolerance, kMostCgIterations, &step);
    return step;
  }

 private:
  struct Spring {
    Index i, j;
    double stiffness;
  };

  /// Where u vanishes so does W for p > 2.
  double Floor(const Eigen::VectorXd& u) const {
    return power_ == 2 ? 0 : 1e-3 * std::pow(u.cwiseAbs().maxCoeff(), power_ - 2);
  }

  Eigen::VectorXd Stretched(const Eigen::VectorXd& b) const {
    Eigen::VectorXd force = Eigen::VectorXd::Zero(b.size());
    for (const auto& [i, j, stiffness] : springs_) {
      force[i] += stiffness * (b[i] - b[j]);
      force[j] += stiffness * (b[j] - b[i]);
    }
    return force;
  }

  Eigen::VectorXd Stiffness() const {
    Eigen::VectorXd diagonal = Eigen::VectorXd::Zero(problem_.area().size());
    for (const auto& [i, j, stiffness] : springs_) {
      diagonal[i] += stiffness;
      diagonal[j] += stiffness;
    }
    return diagonal;
  }

  const BoundaryProblem& problem_;
  const int power_;
  std::vector<Spring> springs_;
};

/// Newton with halvings from `b`; for p = 2 one step is the minimum.
Eigen::VectorXd Minimise(const BoundaryProblem& problem, const LogScaleNorm& norm,
                         Eigen::VectorXd b) {
  Eigen::VectorXd u = problem.LogScale(b);
  double value = norm.Value(b, u);
  for (int i = 0; i < kMostNewtonSteps; ++i) {
    const Eigen::VectorXd step = norm.Step(u, norm.Gradient(b, u));
    const Eigen::VectorXd along = problem.Harmonic(step);
    double length = 1, next = norm.Value(b + step, u + along);
    for (int k = 0; k < kMostHalvings && !(next < value); ++k) {
      length /= 2;
      next = norm.Value(b + length * step, u + length * along);
    }
    if (!(next < value)) break;
    const bool last = next > (1 - kLeastDecrease) * value;
    b += length * step;
    u += length * along;
    value = next;
    if (last) break;
  }
  return b;
}

}  // namespace

Eigen::VectorXd LeastNormLogScale(const BoundaryProblem& problem, int power, double filter) {
  Eigen::VectorXd b = Eigen::VectorXd::Zero(problem.area().size());
  for (int less = 2; less < power; less *= 2) {
    b = Minimise(problem, LogScaleNorm(problem, less, filter), std::move(b));
  }
  return Minimise(problem, LogScaleNorm(problem, power, filter), std::move(b));
}

Eigen::VectorXd LogScaleStep(const BoundaryProblem& problem, int power, double filter,
                             const Eigen::VectorXd& u, const Eigen::VectorXd& gradient) {
  return LogScaleNorm(problem, power, filter).Step(u, gradient);
}

}  // namespace cirque
