#include "cirque/cones/seamless_search.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "cirque/cones/cone_heuristic.h"

namespace cirque {
namespace {

constexpr int kRings = 3;
constexpr int kMostAreaSweeps = 8, kLeastMoves = 60, kMovesPerCone = 6;
constexpr std::size_t kMostPaired = 2000;  ///< moves that pairs are sought among
constexpr double kGoal = 2e-3;             ///< [rad]: what a model is right to
constexpr double kLeastGain = 1e-9;        ///< of an area, relative
/// Of the sum of squares: less than that a move does not take away for nothing. The area's change
/// is known to first order only, and would be run after in circles.
constexpr double kLeastShare = 0.05;
/// Weights of |u|^2 as shares of one over what it was: a doubling costs as much as a rotation
/// missed by .2 rad, .07 rad, .02 rad, nothing.
constexpr std::array<double, 4> kWeights = {5e-2, 5e-3, 5e-4, 0};

bool Cancelled(const std::atomic<bool>* cancelled) { return cancelled && *cancelled; }

double Curvature(const Cone& cone) { return 2 * kPi - cone.lower; }

}  // namespace

SeamlessSearch::SeamlessSearch(const ConeProblem& problem, const RotationModel& model,
                               std::vector<Cone> cones, double unit)
    : problem_(problem),
      model_(model),
      corners_at_(
          SortIntoBuckets(problem.triangulation().vertex, problem.triangulation().num_vertices)),
      unit_(unit),
      cones_(std::move(cones)),
      taken_(problem.triangulation().num_vertices, false),
      rotations_(model.Predict(cones_)),
      offset_(Eigen::VectorXd::Zero(model.size())),
      u_(PredictedLogScale(problem, cones_)) {
  for (const Cone& cone : cones_) taken_[cone.vertex] = true;
  UpdateSlope();
}

double SeamlessSearch::Miss() const {
  return model_.size() == 0 ? 0 : Rest().lpNorm<Eigen::Infinity>();
}

double SeamlessSearch::AreaDistortion() const { return AreaNorm(problem_, u_); }

Eigen::VectorXd SeamlessSearch::Rest() const {
  return (rotations_ + offset_).unaryExpr([this](double r) { return BeyondMultiple(r, unit_); });
}

void SeamlessSearch::UpdateSlope() { slope_ = problem_.Solve(problem_.area().cwiseProduct(u_)); }

std::vector<Index> SeamlessSearch::Rings(Index v) const {
  const Triangulation& t = problem_.triangulation();
  std::vector<Index> reached = {v};
  std::size_t begin = 0;
  for (int ring = 0; ring < kRings; ++ring) {
    const std::size_t end = reached.size();
    for (; begin < end; ++begin) {
      const Index w = reached[begin];
      for (Index i = corners_at_.first[w]; i < corners_at_.first[w + 1]; ++i) {
        reached.push_back(t.Tail(corners_at_.item[i]));
        reached.push_back(t.Tip(corners_at_.item[i]));
      }
    }
    std::sort(reached.begin() + static_cast<std::ptrdiff_t>(end), reached.end());
    reached.erase(std::unique(reached.begin() + static_cast<std::ptrdiff_t>(end), reached.end()),
                  reached.end());
  }
  std::sort(reached.begin(), reached.end());
  reached.erase(std::unique(reached.begin(), reached.end()), reached.end());
  return reached;
}

/// At five corners or more, whatever the curvature, and beside no other cone.
bool SeamlessSearch::MayLieAt(int cone, Index v) const {
  if (!problem_.IsCandidate(v) || taken_[v]) return false;
  const double least = std::min(Curvature(cones_[cone]), -kPi);
  if (problem_.LeastCurvature(v) > least + 1e-9) return false;
  const Triangulation& t = problem_.triangulation();
  for (Index i = corners_at_.first[v]; i < corners_at_.first[v + 1]; ++i) {
    for (const Index w : {t.Tail(corners_at_.item[i]), t.Tip(corners_at_.item[i])}) {
      if (taken_[w] && w != cones_[cone].vertex) return false;
    }
  }
  return true;
}

std::vector<SeamlessSearch::Move> SeamlessSearch::Moves(int i) const {
  const Cone& cone = cones_[i];
  std::vector<Move> moves;
  if (cone.lower != cone.upper || !problem_.IsCandidate(cone.vertex)) return moves;
  const double mu = Curvature(cone);
  const Eigen::MatrixXd& s = model_.by_angle_sum();
  for (const Index w : Rings(cone.vertex)) {
    if (!MayLieAt(i, w)) continue;
    moves.push_back(
        {i, w, 2 * mu * (slope_[w] - slope_[cone.vertex]), mu * (s.col(cone.vertex) - s.col(w))});
  }
  return moves;
}

std::vector<SeamlessSearch::Move> SeamlessSearch::AllMoves() const {
  std::vector<Move> all;
  for (int i = 0; i < static_cast<int>(cones_.size()); ++i) {
    for (Move& move : Moves(i)) all.push_back(std::move(move));
  }
  return all;
}

void SeamlessSearch::Take(const Move& move) {
  Cone& cone = cones_[move.cone];
  Eigen::VectorXd moved = Eigen::VectorXd::Zero(u_.size());
  moved[move.to] = Curvature(cone);
  moved[cone.vertex] -= Curvature(cone);
  u_ += problem_.Solve(moved);
  UpdateSlope();
  rotations_ += move.turn;
  taken_[cone.vertex] = false;
  taken_[move.to] = true;
  cone.vertex = move.to;
  ++moves_;
}

/// The cone's move that the slope likes best, if it keeps what the slope promises.
bool SeamlessSearch::TryAreaMove(int cone) {
  const std::vector<Move> moves = Moves(cone);
  const auto best = std::min_element(moves.begin(), moves.end(),
                                     [](const Move& a, const Move& b) { return a.area < b.area; });
  if (best == moves.end() || best->area >= 0) return false;
  const Index from = cones_[cone].vertex;
  const double before = AreaDistortion();
  Take(*best);
  if (AreaDistortion() < (1 - kLeastGain) * before) return true;
  Take({cone, from, 0, -best->turn});
  moves_ -= 2;
  return false;
}

void SeamlessSearch::DescendArea(const std::atomic<bool>* cancelled) {
  std::vector<bool> rests(cones_.size(), false);
  for (int sweep = 0; sweep < kMostAreaSweeps; ++sweep) {
    bool moved = false;
    for (std::size_t i = 0; i < cones_.size(); ++i) {
      if (Cancelled(cancelled)) return;
      if (rests[i]) continue;
      rests[i] = !TryAreaMove(static_cast<int>(i));
      moved = moved || !rests[i];
    }
    if (!moved) return;
  }
}

/// The sum of squares of Rest() after a move.
double SeamlessSearch::RestAfter(const Move& move) const {
  double after = 0;
  for (int q = 0; q < move.turn.size(); ++q) {
    const double beyond = BeyondMultiple(rotations_[q] + offset_[q] + move.turn[q], unit_);
    after += beyond * beyond;
  }
  return after;
}

bool SeamlessSearch::BestSingle() {
  const std::vector<Move> moves = AllMoves();
  const double rest = Rest().squaredNorm();
  const Move* best = nullptr;
  double most = 0;
  for (const Move& move : moves) {
    const double lower = rest - RestAfter(move);
    const double gain = lower - weight_ * move.area;
    if (lower < kLeastShare * rest || gain <= most) continue;
    most = gain;
    best = &move;
  }
  if (best) Take(*best);
  return best != nullptr;
}

/// Whether neither move ends where the other does, or beside it.
bool SeamlessSearch::GoTogether(const Move& a, const Move& b) {
  taken_[a.to] = true;
  const bool together = MayLieAt(b.cone, b.to);
  taken_[a.to] = false;
  return together;
}

/// With a and b the turns of two moves, |rest + a + b|^2 = |rest|^2 + (what a alone changes) +
/// (what b alone changes) + 2 a.b: all pairs at once are a product of matrices.
bool SeamlessSearch::BestPair() {
  std::vector<Move> moves = AllMoves();
  const Eigen::VectorXd rest = Rest();
  const double squares = rest.squaredNorm();
  const auto change = [&](const Move& move) { return (rest + move.turn).squaredNorm() - squares; };
  if (moves.size() > kMostPaired) {
    std::nth_element(moves.begin(), moves.begin() + kMostPaired, moves.end(),
                     [&](const Move& a, const Move& b) { return change(a) < change(b); });
    moves.resize(kMostPaired);
  }
  const auto count = static_cast<int>(moves.size());
  Eigen::MatrixXd turns(model_.size(), count);
  Eigen::VectorXd alone(count);
  for (int i = 0; i < count; ++i) {
    turns.col(i) = moves[i].turn;
    alone[i] = change(moves[i]);
  }
  std::pair<int, int> best(-1, -1);
  double least = 0;
  for (int i = 0; i < count; ++i) {
    const Eigen::VectorXd products = 2 * (turns.leftCols(i).transpose() * turns.col(i));
    for (int j = 0; j < i; ++j) {
      const double both = alone[i] + alone[j] + products[j];
      const double cost = both + weight_ * (moves[i].area + moves[j].area);
      if (both > -kLeastShare * squares || cost >= least) continue;
      if (moves[i].cone == moves[j].cone || !GoTogether(moves[i], moves[j])) continue;
      least = cost;
      best = {i, j};
    }
  }
  if (best.first < 0) return false;
  Take(moves[best.first]);
  Take(moves[best.second]);
  return true;
}

void SeamlessSearch::Run(const Eigen::VectorXd& offset, const std::atomic<bool>* cancelled) {
  offset_ = offset;
  const double area = std::max(u_.cwiseAbs2().dot(problem_.area()), 1e-3);
  const int most = kLeastMoves + kMovesPerCone * static_cast<int>(cones_.size());
  for (const double share : kWeights) {
    weight_ = share / area;
    for (int i = 0; i < most && Miss() > kGoal && !Cancelled(cancelled); ++i) {
      if (!BestSingle() && !BestPair()) break;
    }
    if (Miss() <= kGoal) return;
  }
}

}  // namespace cirque
