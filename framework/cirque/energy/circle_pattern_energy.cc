#include "cirque/energy/circle_pattern_energy.h"

#include <cmath>

#include <glog/logging.h>

#include "cirque/math/circle_angle.h"
#include "cirque/math/compensated_sum.h"
#include "cirque/math/half_angles.h"
#include "cirque/math/parallel_chunks.h"

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
      edges_.push_back({h, g, alpha, angles.value[g], {}});
    }
  }
  ParallelChunks(static_cast<int>(edges_.size()), [&](int first, int end) {
    ChunkOf<> alpha_i(end - first), alpha_j(end - first);
    ChunkOf<CircleAngle> angle(end - first);
    for (int k = first; k < end; ++k) {
      alpha_i[k - first] = edges_[k].alpha_i;
      alpha_j[k - first] = edges_[k].alpha_j;
    }
    CircleAngles(alpha_i, alpha_j, angle);
    for (int k = first; k < end; ++k) edges_[k].angle = angle[k - first];
  });
}

double CirclePatternEnergy::InteriorEdge::natural_d() const {
  return MinimalLogRatio(alpha_i, alpha_j);
}

/// Some interior edges: what the functions of half_angles.h take, and what they give.
class CirclePatternEnergy::EdgeChunk {
 public:
  EdgeChunk(const CirclePatternEnergy& energy, const double* rho, int first, int end)
      : d_(end - first), sine_(end - first), one_minus_cosine_(end - first) {
    for (int k = 0; k < end - first; ++k) {
      const InteriorEdge& e = energy.edges_[first + k];
      d_[k] = rho[e.i()] - rho[e.j()];
      sine_[k] = e.angle.sine;
      one_minus_cosine_[k] = e.angle.one_minus_cosine;
    }
  }

  double d(int k) const { return d_[k]; }

  template <class Function>
  ChunkOf<> Evaluate(const Function& function) const {
    ChunkOf<> result(static_cast<int>(d_.size()));
    function(d_, sine_, one_minus_cosine_, result);
    return result;
  }

  /// The same edges from their other sides.
  void Reverse() {
    for (double& d : d_) d = -d;
  }

 private:
  ChunkOf<> d_, sine_, one_minus_cosine_;
};

template <class Counts>
double CirclePatternEnergy::Sum(const double* rho, const Counts& counts) const {
  const double of_faces =
      ParallelSum(num_faces_, [&](int f) { return counts(f) ? boundary_star_[f] * rho[f] : 0.0; });
  const int num_edges = static_cast<int>(edges_.size());
  const auto add = [&](int first, int end, CompensatedSum* sum) {
    EdgeChunk chunk(*this, rho, first, end);
    const ChunkOf<> phi_i = chunk.Evaluate(HalfAngles);
    chunk.Reverse();
    const ChunkOf<> phi_j = chunk.Evaluate(HalfAngles);
    for (int k = 0; k < end - first; ++k) {
      const InteriorEdge& e = edges_[first + k];
      if (!counts(e.i())) continue;
      *sum += EdgePotentialValue(-chunk.d(k), e.angle.theta, phi_i[k], phi_j[k]);
      *sum -= (e.alpha_i + e.alpha_j) * (rho[e.i()] + rho[e.j()]);
    }
  };
  return of_faces + ParallelSumOfChunks(num_edges, add);
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
  ParallelChunks(static_cast<int>(edges_.size()), [&](int first, int end) {
    const ChunkOf<> half = EdgeChunk(*this, rho, first, end).Evaluate(HalfAngles);
    for (int k = 0; k < end - first; ++k) {
      // The two halves add up to the corner angles themselves: those sum to pi in every triangle, so
      // that the whole gradient sums to zero but for rounding without bias. pi - theta would be off
      // by the rounding of pi, every time.
      const InteriorEdge& e = edges_[first + k];
      phi[e.h] = half[k];
      phi[e.g] = (e.alpha_i + e.alpha_j) - half[k];
    }
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
  ParallelChunks(static_cast<int>(edges_.size()), [&](int first, int end) {
    const ChunkOf<> of_edge = EdgeChunk(*this, rho, first, end).Evaluate(HalfAngleWeights);
    for (int k = 0; k < end - first; ++k) {
      const InteriorEdge& e = edges_[first + k];
      weight[e.h] = weight[e.g] = of_edge[k];
    }
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
