#include "cirque/cones/curvature_peaks.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

#include <fmt/format.h>

#include "cirque/cones/cone_choice.h"
#include "cirque/cones/cone_fit.h"
#include "cirque/cones/curved_vertices.h"
#include "cirque/intrinsic/intrinsic_surface.h"
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
  using O = CurvaturePeaksOptions;
  static const OptionTable<O> kTable(
      "curvature_peaks",
      Joined<O>(BudgetOptions<O>(),
                {Option<O>("share", &O::share,
                           "of all curvature, which the cones shall carry, however many; 0: none")
                     .Between(0, 1)}));
  return kTable;
}

StatusOr<std::vector<Cone>> CurvaturePeaks::ChooseAtMost(const ConeProblem& problem,
                                                         int count) const {
  if (share_ > 0) return ConesAtCurvedVertices(problem, share_);
  if (simple_) {
    const ConeSource& source = problem.source();
    const auto targets = SimpleConeTargets(*source.surface);
    if (!targets.ok()) return targets.status();
    return ConesOf(source.surface->triangulation, *targets);
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
  FitAdmissible(problem, &*choice, &fit);
  return fit.Cones();
}

namespace {

/// Curvature of every vertex: 2 pi minus its angle sum [rad].
std::vector<double> Curvatures(const IntrinsicSurface& surface) {
  const Triangulation& t = surface.triangulation;
  std::vector<double> curvature(t.num_vertices, 2 * kPi);
  for (Index h = 0; h < t.num_halfedges(); ++h) curvature[t.vertex[h]] -= surface.angles.value[h];
  return curvature;
}

class ConeSpread {
 public:
  explicit ConeSpread(const IntrinsicSurface& surface)
      : t_(surface.triangulation),
        lengths_(surface.lengths),
        quarter_turns_(4 * EulerCharacteristic(t_)),
        corners_(surface.corners),
        curvature_(Curvatures(surface)) {}

  StatusOr<ConeTargets> Choose() const {
    ConeTargets targets = FreeBoundaryTargets(t_);
    if (quarter_turns_ == 0) return targets;
    const int sign = quarter_turns_ > 0 ? 1 : -1;
    for (const int vertices_per_cone : {8, 1}) {
      for (const int part : {1, 2, 4, 8}) {
        if (sign * part >= 4) break;  // no angle is left
        if (TryParts(sign * part, vertices_per_cone, &targets)) return targets;
      }
    }
    return Status::InvalidInput(fmt::format(
        "no simple set of cones: the curvature {} pi needs more vertices with more triangles than "
        "the surface has ({} vertices, at most {} triangles at one); subdivide it or give the "
        "cones in a file",
        quarter_turns_ / 2, t_.num_vertices, *std::max_element(corners_.begin(), corners_.end())));
  }

 private:
  /// Cones of this curvature each, in units of pi/2 (of which chi being even makes a multiple of
  /// 8 in all).
  bool TryParts(int part, int vertices_per_cone, ConeTargets* targets) const {
    const int count = quarter_turns_ / part;
    const std::vector<Index> candidates = Candidates(part, count);
    const bool enough = static_cast<Index>(candidates.size()) >= count &&
                        t_.num_vertices / vertices_per_cone >= count;
    if (!enough) return false;
    for (const Index v : FarthestVertices(t_, lengths_, candidates, count)) {
      targets->lower[v] = targets->upper[v] = kPi * (2 - part / 2.);
    }
    return true;
  }

  /// Vertices with corners enough for such a cone and half of one to spare, the most curved ones
  /// first; the best tenth of them, and never fewer than eight a cone while there are some.
  std::vector<Index> Candidates(int part, int count) const {
    std::vector<Index> candidates;
    for (Index v = 0; v < t_.num_vertices; ++v) {
      if (2 - part / 2. <= corners_[v] - 0.5) candidates.push_back(v);
    }
    const double sign = quarter_turns_ > 0 ? 1 : -1;
    std::stable_sort(candidates.begin(), candidates.end(),
                     [&](Index a, Index b) { return sign * curvature_[a] > sign * curvature_[b]; });
    const std::size_t kept = std::max<std::size_t>(candidates.size() / 10, std::size_t{8} * count);
    if (candidates.size() > kept) candidates.resize(kept);
    return candidates;
  }

  const Triangulation& t_;
  const EdgeLengths& lengths_;
  const int quarter_turns_;  ///< total curvature 2 pi chi in units of pi/2
  const std::vector<Index>& corners_;
  std::vector<double> curvature_;
};

}  // namespace

StatusOr<ConeTargets> SimpleConeTargets(const IntrinsicSurface& surface) {
  const Triangulation& t = surface.triangulation;
  return BoundaryLoops(t).empty() ? ConeSpread(surface).Choose() : FreeBoundaryTargets(t);
}

}  // namespace cirque
