#include "cirque/cones/curvature_peaks.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "cirque/cones/cone_choice.h"
#include "cirque/cones/cone_fit.h"
#include "cirque/cones/simple_cones.h"
#include "cirque/mesh/farthest_vertices.h"

namespace cirque {
namespace {

constexpr double kLeastPeak = 0.1;  ///< of the last peak that the budget would take anyway

/// The most curved vertices, in the order of being far from one another.
std::vector<Index> SpreadPeaks(const ConeProblem& problem, int count) {
  std::vector<Index> peaks = problem.candidates();
  std::stable_sort(peaks.begin(), peaks.end(), [&](Index a, Index b) {
    return std::abs(problem.curvature()[a]) > std::abs(problem.curvature()[b]);
  });
  const std::size_t kept = std::max<std::size_t>(peaks.size() / 10, std::size_t{8} * count);
  if (peaks.size() > kept) peaks.resize(kept);
  // On a polyhedron all others are flat.
  const double least = kLeastPeak * std::abs(problem.curvature()[peaks[count - 1]]);
  std::erase_if(peaks, [&](Index v) { return std::abs(problem.curvature()[v]) < least; });
  return FarthestVertices(problem.triangulation(), problem.lengths(), peaks, count);
}

}  // namespace

const OptionTable<CurvaturePeaksOptions>& CurvaturePeaksOptionTable() {
  static const OptionTable<CurvaturePeaksOptions> kTable("curvature_peaks",
                                                         BudgetFields<CurvaturePeaksOptions>());
  return kTable;
}

StatusOr<std::vector<Cone>> CurvaturePeaks::PlaceAtMost(const ConeProblem& problem,
                                                        int count) const {
  if (simple_) {
    const ConeSource& source = problem.source();
    const auto targets = SimpleConeTargets(*source.triangulation, *source.lengths);
    if (!targets.ok()) return targets.status();
    return ConesOf(*source.triangulation, *targets);
  }
  StatusOr<ConeChoice> choice = ConeChoice::Make(problem, count);
  if (!choice.ok()) return choice.status();
  if (choice->left() == 0) return std::vector<Cone>();
  // What is no peak comes last, the vertices with most corners first.
  Eigen::VectorXd score(problem.triangulation().num_vertices);
  for (const Index v : problem.candidates())
    score[v] = -count - 10 + problem.LeastCurvature(v) * -1e-3;
  double rank = 0;
  for (const Index v : SpreadPeaks(problem, choice->left())) score[v] = rank--;
  ConeFit fit(problem);
  while (const std::optional<Index> v = choice->TakeBest(score)) fit.Add(*v);
  fit.FitLeastSquares();
  return fit.Cones();
}

}  // namespace cirque
