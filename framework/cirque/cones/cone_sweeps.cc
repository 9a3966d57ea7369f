#include "cirque/cones/cone_sweeps.h"

#include <algorithm>
#include <cstddef>
#include <queue>

namespace cirque {
namespace {

constexpr int kFirstStride = 8;           ///< edges
constexpr double kWorthwhile = 3e-3;      ///< relative gain of a step that another is to follow
constexpr int kFirstSweeps = 4;           ///< that are made in any case
constexpr double kLeastGain = 1e-6;       ///< relative, of a sweep worth keeping
constexpr int kRounds = 4;                ///< of sweeps and curvatures
constexpr double kLeastRoundGain = 0.02;  ///< relative, of a round that another is to follow
constexpr int kCurvatureSteps = 12;       ///< of each fit of the curvatures
constexpr double kFirstStep = 0.05;       ///< [rad]: the largest change of the first of them
constexpr int kBisections = 60, kShrinks = 6;

/// Per vertex the nearest of the `sources`, in edges, by its place among them.
std::vector<int> NearestSource(const Triangulation& t, const Buckets& corners_at,
                               const std::vector<Index>& sources) {
  std::vector<int> nearest(t.num_vertices, -1);
  std::queue<Index> queue;
  for (std::size_t i = 0; i < sources.size(); ++i) {
    nearest[sources[i]] = static_cast<int>(i);
    queue.push(sources[i]);
  }
  for (; !queue.empty(); queue.pop()) {
    const Index v = queue.front();
    for (Index i = corners_at.first[v]; i < corners_at.first[v + 1]; ++i) {
      const Index h = corners_at.item[i];
      for (const Index w : {t.Tail(h), t.Tip(h)}) {
        if (nearest[w] >= 0) continue;
        nearest[w] = nearest[v];
        queue.push(w);
      }
    }
  }
  return nearest;
}

}  // namespace

ConeSweeps::ConeSweeps(const ConeProblem& problem, const std::vector<Cone>& start,
                       ConeMeasureKind measure)
    : problem_(problem),
      corners_at_(
          SortIntoBuckets(problem.triangulation().vertex, problem.triangulation().num_vertices)),
      measure_(MakeConeMeasure(measure, problem)),
      curvature_(start.size()),
      least_(start.size()),
      taken_(problem.triangulation().num_vertices, false),
      stride_(start.size(), kFirstStride) {
  for (std::size_t i = 0; i < start.size(); ++i) {
    vertices_.push_back(start[i].vertex);
    taken_[start[i].vertex] = true;
    curvature_[i] = 2 * kPi - start[i].lower;
    // A start may have less than the heuristics' bound: it stays admissible where it is.
    least_[i] = std::min(curvature_[i], problem.LeastCurvature(start[i].vertex));
  }
  u_ = WithCurvatures(curvature_);
}

void ConeSweeps::Run(int max_sweeps) {
  FitCurvatures();
  for (int round = 0; round < kRounds; ++round) {
    const double before = Measure();
    std::fill(stride_.begin(), stride_.end(), kFirstStride);
    SweepToRest(max_sweeps);
    FitCurvatures();
    if (Measure() > (1 - kLeastRoundGain) * before) return;
  }
}

/// Until no cone moves any more, or it is not worth it. The first strides are long and often gain
/// little.
void ConeSweeps::SweepToRest(int max_sweeps) {
  for (int sweep = 0; sweep < max_sweeps; ++sweep) {
    const double before = Measure();
    if (!Sweep()) return;
    if (sweep >= kFirstSweeps && Measure() > (1 - kWorthwhile) * before) return;
  }
}

/// u of these curvatures where the cones are.
Eigen::VectorXd ConeSweeps::WithCurvatures(const Eigen::VectorXd& curvature) const {
  Eigen::VectorXd right = -problem_.curvature();
  for (Eigen::Index i = 0; i < curvature.size(); ++i) right[vertices_[i]] += curvature[i];
  return problem_.Solve(right);
}

/// u after these moves.
Eigen::VectorXd ConeSweeps::MovedLogScale(const std::vector<Index>& to) const {
  Eigen::VectorXd right = Eigen::VectorXd::Zero(u_.size());
  for (std::size_t i = 0; i < to.size(); ++i) {
    right[to[i]] += curvature_[i];
    right[vertices_[i]] -= curvature_[i];
  }
  return u_ + problem_.Solve(right);
}

/// At most `steps` edges down, past no cone, to vertices that can carry the curvature.
Index ConeSweeps::Downhill(Index v, double curvature, const Eigen::VectorXd& slope,
                           int steps) const {
  const Triangulation& t = problem_.triangulation();
  for (; steps > 0; --steps) {
    Index best = v;
    for (Index i = corners_at_.first[v]; i < corners_at_.first[v + 1]; ++i) {
      const Index h = corners_at_.item[i];
      for (const Index w : {t.Tail(h), t.Tip(h)}) {
        const bool allowed =
            !taken_[w] && problem_.IsCandidate(w) && problem_.LeastCurvature(w) <= curvature;
        if (allowed && curvature * slope[w] < curvature * slope[best]) best = w;
      }
    }
    if (best == v) break;
    v = best;
  }
  return v;
}

/// Where each cone would go; until they are kept or taken back, both places count as taken.
std::vector<Index> ConeSweeps::Proposals(const Eigen::VectorXd& slope) {
  std::vector<Index> to = vertices_;
  for (std::size_t i = 0; i < to.size(); ++i) {
    if (stride_[i] == 0) continue;
    to[i] = Downhill(vertices_[i], curvature_[i], slope, stride_[i]);
    taken_[to[i]] = true;
  }
  return to;
}

/// Per cone whether the measure is lower around it.
std::vector<bool> ConeSweeps::WhereLower(const Eigen::VectorXd& moved) const {
  const Eigen::VectorXd change = measure_->Shares(moved) - measure_->Shares(u_);
  const std::vector<int> nearest = NearestSource(problem_.triangulation(), corners_at_, vertices_);
  std::vector<double> around(vertices_.size(), 0);
  for (Eigen::Index v = 0; v < change.size(); ++v) {
    if (nearest[v] >= 0) around[nearest[v]] += change[v];
  }
  std::vector<bool> lower;
  for (const double sum : around) lower.push_back(sum < 0);
  return lower;
}

bool ConeSweeps::Sweep() {
  measure_->AdaptTo(u_);
  const Eigen::VectorXd slope = problem_.Solve(measure_->Apply(u_));
  const std::vector<Index> proposed = Proposals(slope);
  const std::vector<bool> lower = WhereLower(MovedLogScale(proposed));
  std::vector<Index> kept = vertices_;
  for (std::size_t i = 0; i < kept.size(); ++i) {
    if (lower[i]) kept[i] = proposed[i];
  }
  Eigen::VectorXd moved = MovedLogScale(kept);
  const bool gains = measure_->Value(moved) < (1 - kLeastGain) * measure_->Value(u_);
  if (!gains) kept = vertices_;
  bool moving = false;
  for (std::size_t i = 0; i < kept.size(); ++i) {
    const bool rests = kept[i] == vertices_[i];
    stride_[i] = rests ? stride_[i] / 2 : std::min(kFirstStride, 2 * stride_[i]);
    moving = moving || stride_[i] > 0;
    taken_[proposed[i]] = taken_[vertices_[i]] = false;
    if (!rests) least_[i] = problem_.LeastCurvature(kept[i]);
  }
  vertices_ = std::move(kept);
  for (const Index v : vertices_) taken_[v] = true;
  if (gains) u_ = std::move(moved);
  return moving;
}

/// The nearest curvatures within their bounds that have the total.
Eigen::VectorXd ConeSweeps::Admissible(const Eigen::VectorXd& curvature) const {
  const auto shifted = [&](double shift) -> Eigen::VectorXd {
    return (curvature.array() + shift)
        .matrix()
        .cwiseMax(least_)
        .cwiseMin(problem_.GreatestCurvature());
  };
  if (!problem_.IsClosed()) return shifted(0);
  double low = -4 * kPi, high = 4 * kPi;
  for (int i = 0; i < kBisections; ++i) {
    const double middle = 0.5 * (low + high);
    (shifted(middle).sum() < problem_.TotalCurvature() ? low : high) = middle;
  }
  Eigen::VectorXd result = shifted(low);
  // Rounding, which Gauss-Bonnet does not forgive, goes to the cone with most room.
  Eigen::Index widest = 0;
  (problem_.GreatestCurvature() - result.array()).min((result - least_).array()).maxCoeff(&widest);
  result[widest] += problem_.TotalCurvature() - result.sum();
  return result;
}

void ConeSweeps::FitCurvatures() {
  measure_->AdaptTo(u_);
  Eigen::VectorXd last_curvature, last_slope;
  double step = 0;
  for (int i = 0; i < kCurvatureSteps; ++i) {
    const Eigen::VectorXd slope = problem_.Solve(measure_->Apply(u_))(vertices_);
    if (last_slope.size() == 0) {
      const double spread = slope.maxCoeff() - slope.minCoeff();
      if (!(spread > 0)) return;
      step = kFirstStep / spread;
    } else {
      const Eigen::VectorXd moved = curvature_ - last_curvature, turned = slope - last_slope;
      if (moved.dot(turned) > 0) step = moved.squaredNorm() / moved.dot(turned);
    }
    last_curvature = curvature_;
    last_slope = slope;
    const double before = measure_->Value(u_);
    bool gains = false;
    for (int shrink = 0; shrink < kShrinks && !gains; ++shrink, step /= 4) {
      const Eigen::VectorXd next = Admissible(last_curvature - step * slope);
      Eigen::VectorXd u = WithCurvatures(next);
      gains = measure_->Value(u) < (1 - kLeastGain) * before;
      if (!gains) continue;
      curvature_ = next;
      u_ = std::move(u);
    }
    if (!gains || measure_->Value(u_) > (1 - kWorthwhile) * before) return;
    measure_->AdaptTo(u_);
  }
}

std::vector<Cone> ConeSweeps::Cones() const {
  std::vector<Cone> cones;
  for (std::size_t i = 0; i < vertices_.size(); ++i) {
    cones.push_back(ConeOfCurvature(vertices_[i], curvature_[static_cast<Eigen::Index>(i)]));
  }
  return cones;
}

}  // namespace cirque
