#include "cirque/cones/reweighted_cones.h"

#include <algorithm>
#include <cmath>

#include "cirque/cones/descent.h"
#include "cirque/linear/registry.h"

namespace cirque {
namespace {

constexpr double kFirstEpsilon = 0.3, kLastEpsilon = 1e-3;  ///< [rad]
constexpr double kEpsilonFactor = 0.6, kBetaFactor = 1.5;   ///< an iteration
constexpr double kBetaFallback = 0.25;                      ///< while there are too few clusters
constexpr double kFirstBeta = 0.002;
constexpr double kThreshold = 1e-2;  ///< [rad]: less is no cone

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

  /// mu, V.
  Eigen::VectorXd Curvature() const {
    Eigen::VectorXd mu = Eigen::VectorXd::Zero(problem_.triangulation().num_vertices);
    mu(problem_.candidates()) = mu_;
    return mu;
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
  const Triangulation& t = problem.triangulation();
  const auto greedy = PlaceByDescent(problem, std::vector<bool>(t.num_vertices, true), count);
  if (!greedy.ok() || count == 0) return greedy;
  const double norm = AreaNorm(problem, PredictedLogScale(problem, *greedy));
  // A share of what one cone is worth about there.
  double beta = kFirstBeta * norm * norm / count, epsilon = kFirstEpsilon;
  Reweighting reweighting(problem);
  std::vector<bool> support(t.num_vertices, true);  // the last that left a choice
  bool found = false;
  for (int i = 0; i < options_.max_iterations; ++i) {
    if (!reweighting.Iterate(beta, epsilon)) break;
    if (epsilon > kLastEpsilon) {
      epsilon = std::max(kLastEpsilon, kEpsilonFactor * epsilon);
      continue;
    }
    const Eigen::VectorXd mu = reweighting.Curvature();
    const int clusters = NumClusters(t, mu, kThreshold);
    if (clusters >= count) {
      support = Support(mu, kThreshold);
      found = true;
    }
    if (found && clusters <= count) break;
    beta *= found ? kBetaFactor : kBetaFallback;
  }
  return PlaceByDescent(problem, support, count);
}

}  // namespace cirque
