#include "cirque/energy/circle_pattern_energy.h"

#include <cmath>

#include <glog/logging.h>

#include "cirque/math/circle_angle.h"
#include "cirque/math/compensated_sum.h"

namespace cirque {

bool CirclePatternResidual::Evaluate(double const* const* rho, double* residual,
                                     double** jacobians) const {
  const ResidualJet r = EdgeResidual(rho[0][0] - rho[1][0], alpha_i_, alpha_j_);
  if (!std::isfinite(r.value)) return false;
  *residual = r.value;
  if (jacobians && jacobians[0]) jacobians[0][0] = r.slope;
  if (jacobians && jacobians[1]) jacobians[1][0] = -r.slope;
  return true;
}

CirclePatternEnergy::CirclePatternEnergy(const Triangulation& t, const CoherentAngles& angles)
    : num_faces_(t.num_faces()),
      laplacian_(t),
      boundary_star_(Eigen::VectorXd::Constant(num_faces_, 2 * kPi)) {
  edges_.reserve(t.num_edges());
  for (const Index h : t.edge_halfedge) {
    const Index g = t.twin[h];
    const double alpha = angles.value[h];
    CHECK_GT(alpha, 0) << "corner " << h;
    if (g == kNone) {
      boundary_star_[Triangulation::Face(h)] -= 2 * alpha;
    } else {
      CHECK_GT(angles.value[g], 0) << "corner " << g;
      CHECK_LT(alpha + angles.value[g], kPi) << "halfedge " << h;
      edges_.push_back(
          {h, g, alpha, angles.value[g], CircleAngle::FromCorners(alpha, angles.value[g])});
    }
  }
}

double CirclePatternEnergy::InteriorEdge::natural_d() const {
  return MinimalLogRatio(alpha_i, alpha_j);
}

template <class Counts>
double CirclePatternEnergy::Sum(const double* rho, const Counts& counts) const {
  const double of_faces =
      ParallelSum(num_faces_, [&](int f) { return counts(f) ? boundary_star_[f] * rho[f] : 0.0; });
  const double of_edges = ParallelSum(static_cast<int>(edges_.size()), [&](int k) {
    const InteriorEdge& e = edges_[k];
    CompensatedSum sum;
    if (!counts(e.i())) return sum;
    sum += EdgePotential(rho[e.i()] - rho[e.j()], e.angle.theta).value;
    sum -= (e.alpha_i + e.alpha_j) * (rho[e.i()] + rho[e.j()]);
    return sum;
  });
  return of_faces + of_edges;
}

bool CirclePatternEnergy::Evaluate(const double* rho, double* value, double* gradient) const {
  *value = Sum(rho, [](int) { return true; });
  if (!std::isfinite(*value)) return false;
  return gradient ? Gradient(rho, gradient) : true;
}

bool CirclePatternEnergy::Share(const double* rho, const std::vector<bool>& own,
                                double* share) const {
  *share = Sum(rho, [&](int f) { return own[f]; });
  return std::isfinite(*share);
}

bool CirclePatternEnergy::Gradient(const double* rho, double* gradient) const {
  if (!AllFinite(rho)) return false;
  Eigen::VectorXd phi = Eigen::VectorXd::Zero(3 * num_faces_);
  ParallelFor(static_cast<int>(edges_.size()), [&](int k) {
    // The two halves add up to the corner angles themselves: those sum to pi in every triangle, so
    // that the whole gradient sums to zero but for rounding without bias. pi - theta would be off
    // by the rounding of pi, every time.
    const InteriorEdge& e = edges_[k];
    phi[e.h] = HalfAngle(rho[e.i()] - rho[e.j()], e.angle);
    phi[e.g] = (e.alpha_i + e.alpha_j) - phi[e.h];
  });
  ParallelFor(num_faces_, [&](int f) {
    gradient[f] = boundary_star_[f];
    for (Index h = 3 * f; h < 3 * f + 3; ++h) gradient[f] -= 2 * phi[h];
  });
  return true;
}

bool CirclePatternEnergy::Hessian(const double* rho, SparseMatrix* lower) const {
  if (!AllFinite(rho)) return false;
  Eigen::VectorXd weight = Eigen::VectorXd::Zero(3 * num_faces_);
  ParallelFor(static_cast<int>(edges_.size()), [&](int k) {
    const InteriorEdge& e = edges_[k];
    weight[e.h] = weight[e.g] = HalfAngleWeight(rho[e.i()] - rho[e.j()], e.angle);
  });
  laplacian_.Assemble(weight, lower);
  return true;
}

double CirclePatternEnergy::ResidualOffset() const {
  CompensatedSum sum;
  for (const InteriorEdge& e : edges_) {
    const double d = e.natural_d();
    sum += EdgePotential(d, e.angle.theta).value;
    sum += (e.alpha_i - e.alpha_j) * d;
  }
  return sum.Value();
}

void CirclePatternEnergy::AddResidualBlocks(double* rho, ceres::Problem* problem) const {
  for (int f = 0; f < num_faces_; ++f) problem->AddParameterBlock(rho + f, 1);
  for (const InteriorEdge& e : edges_) {
    if (e.i() == e.j()) continue;
    problem->AddResidualBlock(new CirclePatternResidual(e.alpha_i, e.alpha_j), nullptr, rho + e.i(),
                              rho + e.j());
  }
  problem->SetParameterBlockConstant(rho);
}

}  // namespace cirque
