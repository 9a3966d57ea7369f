#include "cirque/domains/boundary_iteration.h"

#include <utility>

#include "cirque/math/anderson_mixing.h"

namespace cirque {
namespace {

constexpr int kMostRounds = 60;
constexpr int kDepth = 8;  ///< of Anderson's acceleration
constexpr double kGoodEnough = 1e-7;
constexpr double kLargestChange = 0.5;  ///< of a log length in a round
constexpr int kWithoutGain = 6;         ///< rounds, at rounding

/// Of the flat metric; of the boundary those of what the exact map is of, where there is one.
EdgeLengths LengthsThatCount(const Surface& surface, const FlatSurface& flat) {
  EdgeLengths lengths = flat.on_input.lengths;
  if (!flat.exact) return lengths;
  const Triangulation& t = surface.triangulation;
  const std::vector<Index>& now = flat.exact->intrinsic.edge_of_input;
  for (Index e = 0; e < t.num_edges(); ++e) {
    if (!t.IsBoundaryEdge(e)) continue;
    lengths.value[e] = flat.exact->lengths.value[now.empty() ? e : now[e]];
  }
  return lengths;
}

}  // namespace

BoundaryIteration::BoundaryIteration(const Surface& surface, BoundaryRule rule,
                                     const ParameterizeOptions& options,
                                     const SolveControl& control)
    : surface_(surface),
      rule_(std::move(rule)),
      options_(options),
      control_(control),
      shares_(rule_.shares),
      shape_(rule_.start) {
  options_.refine_map = "none";
}

bool BoundaryIteration::IsSettled() const { return least_ <= kGoodEnough; }

Status BoundaryIteration::Run(SurfaceMap* failed) {
  const SolvedTriangulation asked = options_.triangulation;
  Status status = RunFromHere(failed);
  if (!best_ || status.code() == StatusCode::kCancelled) return status;
  if (!IsSettled() && asked == SolvedTriangulation::kDelaunay) {
    options_.triangulation = SolvedTriangulation::kInput;
    shape_ = rule_.start;
    status = RunFromHere(failed);
    options_.triangulation = asked;
  }
  if (status.code() != StatusCode::kCancelled && !IsSettled()) {
    shares_ /= 2, shape_ = best_shape_;
    status = RunFromHere(failed);
  }
  return status.code() == StatusCode::kCancelled ? status : Status();
}

Status BoundaryIteration::RunFromHere(SurfaceMap* failed) {
  AndersonMixing mixing(kDepth);
  for (int since = 0, round = 0; since < kWithoutGain && round < kMostRounds; ++since, ++round) {
    SurfaceMap next;
    Status status =
        Parameterize(surface_, {options_, rule_.targets(shape_), {}, {}}, control_, &next);
    ++rounds_;
    if (!status.ok()) {
      *failed = std::move(next);
      return status;
    }
    const Eigen::VectorXd change = rule_.change(shape_, LengthsThatCount(surface_, next.flat));
    const double largest = change.cwiseAbs().maxCoeff();
    if (largest < least_) {
      if (largest > kGoodEnough || largest < least_ / 2) since = 0;
      least_ = largest, best_ = std::move(next), best_shape_ = shape_;
    }
    if (least_ <= rule_.at_rest) break;
    const Eigen::ArrayXd bounded = change.array().max(-kLargestChange).min(kLargestChange);
    shape_ = mixing.Next(shape_, shares_.cwiseProduct(bounded.matrix()));
  }
  return Status();
}

}  // namespace cirque
