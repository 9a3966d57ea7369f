#include "cirque/cones/reweighted_cones.h"

#include <algorithm>
#include <cmath>

#include "cirque/cones/cone_clusters.h"
#include "cirque/solver/sparse_cholesky.h"

namespace cirque {
namespace {

constexpr double kFirstEpsilon = 0.3, kLastEpsilon = 1e-3;  ///< [rad]
constexpr double kEpsilonFactor = 0.7, kBetaFactor = 1.5;   ///< an iteration
constexpr double kThreshold = 1e-2;                         ///< [rad]: less is no cone

/// The iterates, over the problem's candidates.
class Reweighting {
 public:
  explicit Reweighting(const ConeProblem& problem)
      : problem_(problem),
        laplacian_(problem.Laplacian()),
        area_(problem.area()(problem.candidates())),
        curvature_(problem.curvature()(problem.candidates())),
        mu_(curvature_) {}

  /// One least-squares problem; false when it could not be factored.
  bool Iterate(double beta, double epsilon) {
    const Eigen::VectorXd weight =
        beta * (mu_.array().square() + epsilon * epsilon).inverse().matrix();
    SparseMatrix normal = laplacian_ * weight.asDiagonal() * laplacian_;
    for (int i = 0; i < normal.cols(); ++i) normal.coeffRef(i, i) += area_[i];
    const SparseMatrix lower = normal.triangularView<Eigen::Lower>();
    if (!factor_->Factorize(lower)) return false;
    const Eigen::VectorXd u = factor_->Solve(-(laplacian_ * weight.cwiseProduct(curvature_)));
    mu_ = laplacian_ * u + curvature_;
    return mu_.allFinite();
  }

  std::vector<CurvatureCluster> Clusters() const {
    Eigen::VectorXd mu = Eigen::VectorXd::Zero(problem_.triangulation().num_vertices);
    mu(problem_.candidates()) = mu_;
    return ClusterCurvature(problem_.triangulation(), mu, kThreshold);
  }

 private:
  const ConeProblem& problem_;
  const SparseMatrix laplacian_;
  const Eigen::VectorXd area_, curvature_;
  Eigen::VectorXd mu_;
  const std::unique_ptr<SparseCholesky> factor_ = MakeCholesky();
};

}  // namespace

const OptionTable<ReweightedOptions>& ReweightedOptionTable() {
  static const OptionTable<ReweightedOptions> kTable("reweighted", [] {
    auto fields = BudgetFields<ReweightedOptions>();
    fields.push_back({"max_iterations",
                      &ReweightedOptions::max_iterations,
                      1,
                      1000,
                      {},
                      "reweightings, a factorisation each"});
    return fields;
  }());
  return kTable;
}

StatusOr<std::vector<Cone>> ReweightedCones::PlaceAtMost(const ConeProblem& problem,
                                                         int count) const {
  if (count == 0) return ConesAtClusters(problem, {}, 0);
  Reweighting reweighting(problem);
  const double norm = AreaNorm(problem, problem.LogScaleWithoutCones());
  // A share of what the distortion falls by with every cone, at first a small one.
  double beta = 1e-3 * norm * norm / count, epsilon = kFirstEpsilon;
  std::vector<CurvatureCluster> clusters;
  for (int i = 0; i < options_.max_iterations; ++i) {
    if (!reweighting.Iterate(beta, epsilon)) break;
    clusters = reweighting.Clusters();
    const bool settled = epsilon == kLastEpsilon;
    if (settled && static_cast<int>(clusters.size()) <= count) break;
    if (settled) beta *= kBetaFactor;
    epsilon = std::max(kLastEpsilon, kEpsilonFactor * epsilon);
  }
  return ConesAtClusters(problem, clusters, count);
}

}  // namespace cirque
