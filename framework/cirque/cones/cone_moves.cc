#include "cirque/cones/cone_moves.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "cirque/cones/cone_choice.h"

namespace cirque {
namespace {

constexpr int kLongestStride = 8;                           ///< edges
constexpr double kLeastGain = 1e-6;                         ///< relative, of a move worth making
constexpr int kAdaptations = 2, kLastAdaptations = 20;      ///< of the measure's form
constexpr std::size_t kMostMissed = 8, kMostPositions = 4;  ///< tried by a relocation
constexpr double kLeastRelocationGain = 1e-3;
/// Times the measure before: a new position not worth settling at.
constexpr double kHopeless = 1.05;

/// From which so many sweeps come down to a single edge and rest: 1 from two, twice as long for each more.
int FirstStride(int max_sweeps) {
  int stride = 1;
  for (int sweeps = 2; sweeps < max_sweeps && stride < kLongestStride; ++sweeps) stride *= 2;
  return stride;
}

}  // namespace

ConeMoves::ConeMoves(const ConeProblem& problem, const std::vector<Cone>& start,
                     ConeMeasureKind measure, int max_sweeps)
    : problem_(problem),
      corners_at_(
          SortIntoBuckets(problem.triangulation().vertex, problem.triangulation().num_vertices)),
      fit_(problem, MakeConeMeasure(measure, problem)),
      taken_(problem.triangulation().num_vertices, false),
      stride_(start.size(), FirstStride(max_sweeps)),
      resistance_(start.size(), 0) {
  std::vector<Index> vertices;
  for (const Cone& cone : start) vertices.push_back(cone.vertex);
  fit_.Prepare(vertices);
  for (const Index v : vertices) {
    fit_.Add(v);
    taken_[v] = true;
  }
}

bool ConeMoves::FitStart() {
  if (!fit_.FitLeastSquares()) return false;
  Adapt(kAdaptations);
  return true;
}

void ConeMoves::FitEnd() { Adapt(kLastAdaptations); }

/// Fits again where the measure's form has changed, as long as the measure falls by it.
void ConeMoves::Adapt(int times) {
  double before = std::numeric_limits<double>::infinity();
  for (int i = 0; i < times && fit_.AdaptMeasure(); ++i) {
    fit_.FitLeastSquares();
    const double now = fit_.Measure();
    if (now > (1 - kLeastGain) * before) break;
    before = now;
  }
}

bool ConeMoves::Sweep() {
  Adapt(kAdaptations);
  const Eigen::VectorXd slope = fit_.Descent();
  PrepareProposals(slope);
  bool moving = false;
  for (int i = 0; i < fit_.size(); ++i) {
    if (stride_[i] == 0) continue;
    const bool moved = TryMove(i, slope, stride_[i]);
    stride_[i] = moved ? std::min(kLongestStride, 2 * stride_[i]) : stride_[i] / 2;
    moving = moving || stride_[i] > 0;
  }
  return moving;
}

/// Where cone i is to be tried; where it is, when it is to stay.
Index ConeMoves::Proposal(int i, const Eigen::VectorXd& slope, int stride) const {
  const Index from = fit_.vertices()[i];
  const double curvature = fit_.curvature()[i];
  const Index to = Downhill(from, curvature, slope, stride);
  const double downhill = curvature * (slope[from] - slope[to]);
  return resistance_[i] * stride * stride > downhill ? from : to;
}

/// What a sweep will try unless the moves before change it, solved for together.
void ConeMoves::PrepareProposals(const Eigen::VectorXd& slope) {
  std::vector<Index> proposals;
  for (int i = 0; i < fit_.size(); ++i) {
    const Index to = Proposal(i, slope, stride_[i]);
    if (to != fit_.vertices()[i]) proposals.push_back(to);
  }
  fit_.Prepare(proposals);
}

bool ConeMoves::TryMove(int i, const Eigen::VectorXd& slope, int stride) {
  const Index from = fit_.vertices()[i], to = Proposal(i, slope, stride);
  if (to == from) return false;
  const double downhill = fit_.curvature()[i] * (slope[from] - slope[to]);
  const double before = fit_.Distortion();
  fit_.Move(i, to);
  const bool fits = fit_.FitLeastSquares();
  const double after = fit_.Distortion();
  if (!fits || after > (1 - kLeastGain) * before) {
    resistance_[i] = (downhill - 0.5 * (before * before - after * after)) / (stride * stride);
    fit_.UndoMove();
    return false;
  }
  resistance_[i] = 0;
  taken_[from] = false;
  taken_[to] = true;
  return true;
}

/// At most `steps` edges down curvature times slope, past no other cone.
Index ConeMoves::Downhill(Index v, double curvature, const Eigen::VectorXd& slope,
                          int steps) const {
  const Triangulation& t = problem_.triangulation();
  for (; steps > 0; --steps) {
    Index best = v;
    for (Index i = corners_at_.first[v]; i < corners_at_.first[v + 1]; ++i) {
      const Index h = corners_at_.item[i];
      for (const Index w : {t.Tail(h), t.Tip(h)}) {
        const bool lower = curvature * slope[w] < curvature * slope[best];
        if (!taken_[w] && problem_.IsCandidate(w) && lower) best = w;
      }
    }
    if (best == v) break;
    v = best;
  }
  return v;
}

bool ConeMoves::Relocate() {
  const double before = fit_.Measure();
  for (const int i : LeastMissed()) {
    if (!fit_.FitWithout(i)) continue;
    const Index from = fit_.vertices()[i];
    for (const Index to : BestPositions()) {
      if (TryPosition(i, to, before)) return true;
    }
    MoveTo(i, from);
  }
  return false;
}

/// The cones without which the form is lowest.
std::vector<int> ConeMoves::LeastMissed() {
  std::vector<std::pair<double, int>> missed;
  for (int i = 0; i < fit_.size(); ++i) {
    if (fit_.FitWithout(i)) missed.emplace_back(fit_.Distortion(), i);
  }
  fit_.FitLeastSquares();
  std::sort(missed.begin(), missed.end());
  if (missed.size() > kMostMissed) missed.resize(kMostMissed);
  std::vector<int> cones;
  for (const auto& [distortion, i] : missed) cones.push_back(i);
  return cones;
}

/// Where a little curvature would lower the form most: maxima among neighbours.
std::vector<Index> ConeMoves::BestPositions() const {
  const Triangulation& t = problem_.triangulation();
  const Eigen::VectorXd score = DistanceFromCones(problem_, fit_, fit_.Descent());
  std::vector<bool> is_maximum(t.num_vertices, true);
  for (const Index h : t.edge_halfedge) {
    const Index a = t.Tail(h), b = t.Tip(h);
    if (score[a] != score[b]) is_maximum[score[a] < score[b] ? a : b] = false;
  }
  std::vector<std::pair<double, Index>> maxima;
  for (const Index v : problem_.candidates()) {
    if (is_maximum[v] && !taken_[v]) maxima.emplace_back(-score[v], v);
  }
  std::sort(maxima.begin(), maxima.end());
  if (maxima.size() > kMostPositions) maxima.resize(kMostPositions);
  std::vector<Index> positions;
  for (const auto& [score_there, v] : maxima) positions.push_back(v);
  return positions;
}

bool ConeMoves::TryPosition(int i, Index to, double before) {
  MoveTo(i, to);
  if (fit_.Measure() > kHopeless * before) return false;
  Settle(i);
  if (fit_.Measure() > (1 - kLeastRelocationGain) * before) return false;
  std::fill(stride_.begin(), stride_.end(), kLongestStride);
  return true;
}

void ConeMoves::MoveTo(int i, Index to) {
  resistance_[i] = 0;
  taken_[fit_.vertices()[i]] = false;
  taken_[to] = true;
  fit_.Move(i, to);
  fit_.FitLeastSquares();
  Adapt(kAdaptations);
}

void ConeMoves::Settle(int i) {
  for (int stride = kLongestStride; stride > 0;) {
    const bool moved = TryMove(i, fit_.Descent(), stride);
    stride = moved ? std::min(kLongestStride, 2 * stride) : stride / 2;
  }
  Adapt(kAdaptations);
}

}  // namespace cirque
