#include "cirque/cones/l1_cones.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "cirque/cones/descent.h"

namespace cirque {
namespace {

constexpr double kThreshold = 1e-3;  ///< [rad]: less curvature is no cone
constexpr double kTolerance = 1e-7;  ///< of the program
constexpr double kLambdaFactor = 0.25;

/// The weight at which, without cones, the dual would just fit its box.
double LargestUsefulLambda(const ConeProblem& problem) {
  const Eigen::VectorXd weighted = problem.area().cwiseProduct(problem.LogScaleWithoutCones());
  const Eigen::VectorXd phi = problem.Solve(weighted);
  if (!problem.IsClosed()) return phi.lpNorm<Eigen::Infinity>();
  return 0.5 * (phi.maxCoeff() - phi.minCoeff());
}

}  // namespace

const OptionTable<L1Options>& L1OptionTable() {
  static const OptionTable<L1Options> kTable("l1", [] {
    auto fields = BudgetFields<L1Options>();
    fields.push_back({"lambda", &L1Options::lambda, 0, 1e9, {}, "0: sought for the budget"});
    fields.push_back({"max_solves", &L1Options::max_solves, 1, 100, {}, "of that search"});
    return fields;
  }());
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

StatusOr<std::vector<Cone>> L1Cones::PlaceAtMost(const ConeProblem& problem, int count) const {
  const Triangulation& t = problem.triangulation();
  const std::vector<bool> nowhere(t.num_vertices, false);
  if (count == 0) return PlaceByDescent(problem, nowhere, 0);
  const bool search = options_.lambda == 0;
  double lambda = search ? LargestUsefulLambda(problem) / count : options_.lambda;
  BoxProgram program = L1Dual(problem, lambda);
  std::vector<bool> support = nowhere;
  for (int solve = 0; solve < (search ? options_.max_solves : 1); ++solve) {
    program.bound.setConstant(lambda);
    const Eigen::VectorXd mu = L1Curvature(problem, SolveBoxProgram(program, kTolerance));
    support = Support(mu, kThreshold);
    if (std::count(support.begin(), support.end(), true) >= 2 * count) break;
    lambda *= kLambdaFactor;
  }
  return PlaceByDescent(problem, support, count);
}

}  // namespace cirque
