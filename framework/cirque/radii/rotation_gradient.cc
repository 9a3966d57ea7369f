#include "cirque/radii/rotation_gradient.h"

#include <memory>

#include "cirque/energy/circle_pattern_energy.h"
#include "cirque/linear/registry.h"
#include "cirque/linear/sparse_cholesky.h"
#include "cirque/linear/sparse_matrix.h"
#include "cirque/math/circle_angle.h"

namespace cirque {
namespace {

class Gradients {
 public:
  Gradients(const Triangulation& t, const CoherentAngles& angles, const LogRadii& log_radii)
      : t_(t), alpha_(angles.value), rho_(log_radii.value), by_d_(t.num_halfedges()) {
    for (const Index h : t.edge_halfedge) {
      const Index g = t.twin[h];
      if (g == kNone) continue;
      const CircleAngle angle = CircleAngle::FromCorners(alpha_[h], alpha_[g]);
      by_d_[h] = by_d_[g] = -0.5 * HalfAngleWeight(LogRatio(h), angle);
    }
    SparseMatrix lower;
    CirclePatternEnergy(t, angles).Hessian(rho_.data(), &lower);
    // Right sides add up to 0, and then lambda_0 is 0 whatever is added here.
    DiagonalEntry(&lower, 0) += 1 + DiagonalEntry(lower, 0);
    factor_ = MakeCholesky();
    has_factor_ = factor_->Factorize(lower);
  }

  bool HasFactor() const { return has_factor_; }

  Eigen::VectorXd Of(const SignedCorners& path) {
    Eigen::VectorXd weight = Eigen::VectorXd::Zero(t_.num_halfedges());
    for (const auto& [corner, sign] : path) weight[corner] += sign;
    Eigen::VectorXd by_rho = Eigen::VectorXd::Zero(t_.num_faces());
    for (const Index h : t_.edge_halfedge) {
      const Index g = t_.twin[h];
      if (g == kNone || weight[h] == weight[g]) continue;
      const double change = by_d_[h] * (weight[h] - weight[g]);
      by_rho[Triangulation::Face(h)] += change;
      by_rho[Triangulation::Face(g)] -= change;
    }
    return ByAngles(weight, factor_->Solve(by_rho));
  }

 private:
  double LogRatio(Index h) const {
    return rho_[Triangulation::Face(h)] - rho_[Triangulation::Face(t_.twin[h])];
  }

  Eigen::VectorXd ByAngles(const Eigen::VectorXd& weight, const Eigen::VectorXd& lambda) const {
    Eigen::VectorXd gradient(t_.num_halfedges());
    for (const Index h : t_.edge_halfedge) {
      const Index g = t_.twin[h];
      const double of_h = weight[h] + 2 * lambda[Triangulation::Face(h)];
      gradient[h] = of_h;
      if (g == kNone) continue;
      const double of_g = weight[g] + 2 * lambda[Triangulation::Face(g)];
      const double share = HalfAngleByThetaStar(LogRatio(h), alpha_[h] + alpha_[g]);
      gradient[h] = gradient[g] = share * of_h + (1 - share) * of_g;
    }
    return gradient;
  }

  const Triangulation& t_;
  const Eigen::VectorXd& alpha_;
  const Eigen::VectorXd& rho_;
  Eigen::VectorXd by_d_;
  std::unique_ptr<SparseCholesky> factor_;
  bool has_factor_ = false;
};

}  // namespace

StatusOr<Eigen::MatrixXd> RotationGradients(const Triangulation& t, const CoherentAngles& angles,
                                            const LogRadii& log_radii,
                                            const std::vector<SignedCorners>& paths) {
  Gradients gradients(t, angles, log_radii);
  if (!gradients.HasFactor()) {
    return Status(StatusCode::kNotConverged,
                  "the radii's Hessian is not positive definite in floating point");
  }
  Eigen::MatrixXd all(t.num_halfedges(), static_cast<int>(paths.size()));
  for (std::size_t q = 0; q < paths.size(); ++q) {
    all.col(static_cast<int>(q)) = gradients.Of(paths[q]);
  }
  return all;
}

}  // namespace cirque
