#include "cirque/cones/sparse_cones.h"

#include <algorithm>
#include <cmath>
#include <memory>

#include "cirque/cones/cone_choice.h"
#include "cirque/core/grouping.h"
#include "cirque/linear/registry.h"

namespace cirque {
namespace {

constexpr double kL1Threshold = 1e-3;  ///< [rad]: less curvature is no cone
constexpr double kTolerance = 1e-7;    ///< of the program
constexpr double kLambdaFactor = 0.25;

/// The vertices that carry more curvature than `threshold` [rad] of a measure mu (V).
std::vector<bool> Support(const Eigen::VectorXd& mu, double threshold) {
  std::vector<bool> support(mu.size());
  for (Eigen::Index v = 0; v < mu.size(); ++v) support[v] = std::abs(mu[v]) > threshold;
  return support;
}

/// The number of connected sets of such vertices of one sign.
int NumClusters(const Triangulation& t, const Eigen::VectorXd& mu, double threshold) {
  DisjointSets sets(t.num_vertices);
  for (const Index h : t.edge_halfedge) {
    const double a = mu[t.Tail(h)], b = mu[t.Tip(h)];
    if (std::min(std::abs(a), std::abs(b)) > threshold && a * b > 0) {
      sets.Unite(t.Tail(h), t.Tip(h));
    }
  }
  int count = 0;
  for (Index v = 0; v < t.num_vertices; ++v) {
    if (std::abs(mu[v]) > threshold && sets.Find(v) == v) ++count;
  }
  return count;
}

/// The weight at which, without cones, the dual would just fit its box.
double LargestUsefulLambda(const ConeProblem& problem) {
  const Eigen::VectorXd weighted = problem.area().cwiseProduct(problem.LogScaleWithoutCones());
  const Eigen::VectorXd phi = problem.Solve(weighted);
  if (!problem.IsClosed()) return phi.lpNorm<Eigen::Infinity>();
  return 0.5 * (phi.maxCoeff() - phi.minCoeff());
}

}  // namespace

const OptionTable<L1Options>& L1OptionTable() {
  using O = L1Options;
  static const OptionTable<O> kTable(
      "l1", Joined<O>(BudgetOptions<O>(),
                      {Option<O>("lambda", &O::lambda, "0: sought for the budget").Between(0, 1e9),
                       Option<O>("max_solves", &O::max_solves, "of that search").Between(1, 100)}));
  return kTable;
}

BoxProgram L1Dual(const ConeProblem& problem, double lambda) {
  const SparseMatrix laplacian = problem.Laplacian();
  const Eigen::VectorXd inverse_area = problem.area()(problem.candidates()).cwiseInverse();
  const SparseMatrix product = laplacian * inverse_area.asDiagonal() * laplacian;
  BoxProgram program;
  program.hessian = product.triangularView<Eigen::Lower>();
  program.linear = problem.curvature()(problem.candidates());
  program.bound = Eigen::VectorXd::Constant(program.linear.size(), lambda);
  return program;
}

Eigen::VectorXd L1Curvature(const ConeProblem& problem, const BoxSolution& solution) {
  Eigen::VectorXd mu = Eigen::VectorXd::Zero(problem.triangulation().num_vertices);
  mu(problem.candidates()) = solution.upper - solution.lower;
  return mu;
}

StatusOr<std::vector<Cone>> L1Cones::ChooseAtMost(const ConeProblem& problem, int count) const {
  const Triangulation& t = problem.triangulation();
  const std::vector<bool> nowhere(t.num_vertices, false);
  if (count == 0) return ChooseByDescent(problem, nowhere, 0);
  const bool search = options_.lambda == 0;
  double lambda = search ? LargestUsefulLambda(problem) / count : options_.lambda;
  BoxProgram program = L1Dual(problem, lambda);
  std::vector<bool> support = nowhere;
  for (int solve = 0; solve < (search ? options_.max_solves : 1); ++solve) {
    program.bound.setConstant(lambda);
    const Eigen::VectorXd mu = L1Curvature(problem, SolveBoxProgram(program, kTolerance));
    support = Support(mu, kL1Threshold);
    if (std::count(support.begin(), support.end(), true) >= 2 * count) break;
    lambda *= kLambdaFactor;
  }
  return ChooseByDescent(problem, support, count);
}

namespace {

constexpr double kFirstEpsilon = 0.3, kLastEpsilon = 1e-3;  ///< [rad]
constexpr double kEpsilonFactor = 0.6, kBetaFactor = 1.5;   ///< an iteration
constexpr double kBetaFallback = 0.25;                      ///< while there are too few clusters
constexpr double kFirstBeta = 0.002;
constexpr double kReweightedThreshold = 1e-2;  ///< [rad]: less is no cone

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
  using O = ReweightedOptions;
  static const OptionTable<O> kTable(
      "reweighted", Joined<O>(BudgetOptions<O>(), {Option<O>("max_iterations", &O::max_iterations,
                                                             "reweightings, a factorisation each")
                                                       .Between(1, 1000)}));
  return kTable;
}

StatusOr<std::vector<Cone>> ReweightedCones::ChooseAtMost(const ConeProblem& problem,
                                                          int count) const {
  const Triangulation& t = problem.triangulation();
  const auto greedy = ChooseByDescent(problem, std::vector<bool>(t.num_vertices, true), count);
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
    const int clusters = NumClusters(t, mu, kReweightedThreshold);
    if (clusters >= count) {
      support = Support(mu, kReweightedThreshold);
      found = true;
    }
    if (found && clusters <= count) break;
    beta *= found ? kBetaFactor : kBetaFallback;
  }
  return ChooseByDescent(problem, support, count);
}

}  // namespace cirque
