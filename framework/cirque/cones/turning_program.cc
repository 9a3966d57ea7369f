#include "cirque/cones/turning_program.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace cirque {
namespace {

constexpr int kMostArcs = 400, kMostNewtonSteps = 100;
constexpr double kMostVisits = 3e7;  ///< of corners, in all
constexpr double kTolerance = 1e-8;  ///< [rad]: of sums

/// The dual: what an arc's corners are pushed by adds up to `push`.
class Ascent {
 public:
  explicit Ascent(const TurningProgram& program)
      : program_(program),
        n_(static_cast<Index>(program.turning.size())),
        push_(Eigen::VectorXd::Zero(n_)),
        whole_{{0, n_, program.turning.sum()}, 0, true} {}

  /// Whether a minimiser for the arcs so far was found: without one the multipliers grow and grow.
  bool Solve() {
    while (visits_ < kMostVisits) {
      double change = 0;
      for (Row& row : rows_) {
        if (!Ascend(&row, &change)) return false;
      }
      if (!Ascend(&whole_, &change)) return false;
      if (change <= kTolerance) return true;
    }
    return false;
  }

  void Add(const TurningArc& arc) {
    rows_.push_back({{arc.first, arc.count, -program_.most_back}, 0, false});
  }

  Eigen::VectorXd Turning() const {
    Eigen::VectorXd x(n_);
    for (Index k = 0; k < n_; ++k) x[k] = TurningAt(k, 0);
    return x;
  }

 private:
  /// Corners that must turn by so much in all, or by more.
  struct Row {
    TurningArc arc;
    double multiplier;
    bool is_equation;
  };

  double TurningAt(Index k, double more) const {
    if (program_.weight[k] <= 0) return program_.turning[k];
    const double free = program_.turning[k] + (push_[k] + more) / program_.weight[k];
    return std::clamp(free, program_.lower[k], program_.upper[k]);
  }

  bool Yields(Index k, double more, bool up) const {
    if (program_.weight[k] <= 0) return false;
    const double x = TurningAt(k, more);
    return up ? x < program_.upper[k] : x > program_.lower[k];
  }

  /// The multiplier at which the row holds, by Newton's method on a monotone piecewise linear
  /// function; false: no multiplier makes it hold.
  bool Ascend(Row* row, double* change) {
    double more = 0;
    for (int step = 0; step < kMostNewtonSteps; ++step) {
      double sum = 0, slope_up = 0, slope_down = 0;
      visits_ += row->arc.count;
      for (Index i = 0; i < row->arc.count; ++i) {
        const Index k = (row->arc.first + i) % n_;
        sum += TurningAt(k, more);
        if (Yields(k, more, true)) slope_up += 1 / program_.weight[k];
        if (Yields(k, more, false)) slope_down += 1 / program_.weight[k];
      }
      const double missing = row->arc.turning - sum;
      if (step == 0) *change = std::max(*change, Violation(*row, missing));
      if (std::abs(missing) <= 0.1 * kTolerance) break;
      const double slope = missing > 0 ? slope_up : slope_down;
      if (slope <= 0) {
        if (missing > 0 || row->is_equation) return false;
        more = -row->multiplier;
        break;
      }
      more += missing / slope;
      if (!row->is_equation && row->multiplier + more < 0) {
        more = -row->multiplier;
        if (missing <= 0) break;
      }
    }
    Push(more, row);
    return true;
  }

  static double Violation(const Row& row, double missing) {
    const bool slack = !row.is_equation && row.multiplier <= 0 && missing < 0;
    return slack ? 0 : std::abs(missing);
  }

  void Push(double more, Row* row) {
    row->multiplier += more;
    for (Index i = 0; i < row->arc.count; ++i) push_[(row->arc.first + i) % n_] += more;
  }

  const TurningProgram& program_;
  const Index n_;
  Eigen::VectorXd push_;
  Row whole_;
  std::vector<Row> rows_;
  double visits_ = 0;
};

}  // namespace

TurningArc DeepestArc(const Eigen::VectorXd& turning) {
  const auto n = static_cast<Index>(turning.size());
  TurningArc deepest;
  double sum = 0, highest = 0;
  Index after_highest = 0;
  // Once more round, a sum that was the highest has been surpassed by the same one later.
  for (Index j = 0; j < 2 * n; ++j) {
    sum += turning[j % n];
    if (sum - highest < deepest.turning) {
      deepest = {after_highest % n, j + 1 - after_highest, sum - highest};
    }
    if (sum > highest) {
      highest = sum;
      after_highest = j + 1;
    }
  }
  return deepest;
}

std::optional<Eigen::VectorXd> LeastTurning(const TurningProgram& program) {
  Ascent ascent(program);
  for (int arcs = 0; arcs < kMostArcs; ++arcs) {
    if (!ascent.Solve()) return std::nullopt;
    Eigen::VectorXd turning = ascent.Turning();
    const TurningArc deepest = DeepestArc(turning);
    if (deepest.turning >= -program.most_back - 1e-7) return turning;
    ascent.Add(deepest);
  }
  return std::nullopt;
}

}  // namespace cirque
