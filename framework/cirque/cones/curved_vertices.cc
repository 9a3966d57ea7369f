#include "cirque/cones/curved_vertices.h"

#include <algorithm>
#include <cmath>

#include <glog/logging.h>

#include "cirque/linear/registry.h"

namespace cirque {
namespace {

constexpr double kFlat = 1e-12;  ///< [rad]: what rounding leaves of no curvature

/// The fewest candidates that carry the share of all |K|, by flag.
std::vector<bool> MostCurved(const ConeProblem& problem, double share) {
  const auto curvature = [&](Index v) { return std::abs(problem.curvature()[v]); };
  std::vector<Index> sorted = problem.candidates();
  std::stable_sort(sorted.begin(), sorted.end(),
                   [&](Index a, Index b) { return curvature(a) > curvature(b); });
  double all = 0;
  for (const Index v : sorted) all += curvature(v);
  std::vector<bool> chosen(problem.triangulation().num_vertices, false);
  double carried = 0;
  for (const Index v : sorted) {
    if (curvature(v) <= kFlat || (share < 1 && carried >= share * all)) break;
    chosen[v] = true;
    carried += curvature(v);
  }
  return chosen;
}

/// u at the candidates: 0 at the cones, and with L u = -K at the others.
Eigen::VectorXd LogScaleBetween(const ConeProblem& problem, const std::vector<bool>& cone,
                                const SparseMatrix& laplacian) {
  const std::vector<Index>& candidates = problem.candidates();
  std::vector<int> number(candidates.size(), -1);
  std::vector<int> others;
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    if (cone[candidates[i]]) continue;
    number[i] = static_cast<int>(others.size());
    others.push_back(static_cast<int>(i));
  }
  Eigen::VectorXd u = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(candidates.size()));
  if (others.empty()) return u;
  const auto num_others = static_cast<Eigen::Index>(others.size());
  std::vector<Eigen::Triplet<double>> entries;
  Eigen::VectorXd right(num_others);
  for (Eigen::Index j = 0; j < num_others; ++j) {
    right[j] = -problem.curvature()[candidates[others[j]]];
    for (SparseMatrix::InnerIterator it(laplacian, others[j]); it; ++it) {
      const int i = number[it.row()];
      if (i >= j) entries.emplace_back(i, j, it.value());
    }
  }
  SparseMatrix lower(num_others, num_others);
  lower.setFromTriplets(entries.begin(), entries.end());
  const auto factor = MakeCholesky();
  CHECK(factor->Factorize(lower)) << "the Laplacian is not positive definite";
  const Eigen::VectorXd solution = factor->Solve(right);
  for (Eigen::Index j = 0; j < num_others; ++j) u[others[j]] = solution[j];
  return u;
}

/// Cones with bounds of their curvatures.
struct BoundedCurvatures {
  std::vector<Index> vertex;
  Eigen::VectorXd value, least, greatest;

  /// Moves the sum to `total` as far as the bounds let it, each cone by the same part of its room.
  void SpreadRest(double total) {
    const double rest = total - value.sum();
    const Eigen::VectorXd room =
        rest > 0 ? Eigen::VectorXd(greatest - value) : Eigen::VectorXd(least - value);
    const double sum = room.sum();
    if (sum != 0) value += std::min(1.0, rest / sum) * room;
  }
};

BoundedCurvatures Bounded(const ConeProblem& problem, const std::vector<bool>& cone,
                          const Eigen::VectorXd& curvature) {
  BoundedCurvatures cones;
  for (const Index v : problem.candidates()) {
    if (cone[v]) cones.vertex.push_back(v);
  }
  const auto count = static_cast<Eigen::Index>(cones.vertex.size());
  cones.value.resize(count);
  cones.least.resize(count);
  cones.greatest.resize(count);
  for (Eigen::Index i = 0; i < count; ++i) {
    const Index v = cones.vertex[i];
    const double own = problem.curvature()[v];
    cones.least[i] = std::min(own, problem.LeastCurvature(v));
    cones.greatest[i] = std::max(own, problem.GreatestCurvature());
    cones.value[i] = std::clamp(curvature[v], cones.least[i], cones.greatest[i]);
  }
  return cones;
}

}  // namespace

std::vector<Cone> ConesAtCurvedVertices(const ConeProblem& problem, double share) {
  const std::vector<bool> cone = MostCurved(problem, share);
  const SparseMatrix laplacian = problem.Laplacian();
  const Eigen::VectorXd flux = laplacian * LogScaleBetween(problem, cone, laplacian);
  Eigen::VectorXd curvature = problem.curvature();
  for (std::size_t i = 0; i < problem.candidates().size(); ++i) {
    curvature[problem.candidates()[i]] += flux[static_cast<Eigen::Index>(i)];
  }
  BoundedCurvatures bounded = Bounded(problem, cone, curvature);
  if (problem.IsClosed()) bounded.SpreadRest(problem.TotalCurvature());
  std::vector<Cone> cones;
  for (std::size_t i = 0; i < bounded.vertex.size(); ++i) {
    cones.push_back(
        ConeOfCurvature(bounded.vertex[i], bounded.value[static_cast<Eigen::Index>(i)]));
  }
  return cones;
}

}  // namespace cirque
